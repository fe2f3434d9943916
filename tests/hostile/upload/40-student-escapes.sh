# Tries: escapes of a terminal and a change of direction as a student's name
# Stopped by: text stays text; folders get names of their own
# expect: passed
# student: a\u001b[2J\u202eb

cp "$HOSTILE/honest.h" .
cp "$HOSTILE/right.c" edge-table-closed.c
