# Tries: marks that turn text around, and control characters of the second set, as a student's name
# Stopped by: text stays text; folders get names of their own
# expect: passed
# student: c\u202e\u2066\u009b31m\u061cd

cp "$HOSTILE/honest.h" .
cp "$HOSTILE/right.c" edge-table-closed.c
