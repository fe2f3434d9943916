# Tries: a second line as a student's name
# Stopped by: text stays text; folders get names of their own
# expect: passed
# student: a\nb,10

cp "$HOSTILE/honest.h" .
cp "$HOSTILE/right.c" edge-table-closed.c
