# Tries: markup as a student's name
# Stopped by: text stays text; folders get names of their own
# expect: passed
# student: <img src=x onerror=alert(1)>

cp "$HOSTILE/honest.h" .
cp "$HOSTILE/right.c" edge-table-closed.c
