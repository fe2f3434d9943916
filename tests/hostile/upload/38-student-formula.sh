# Tries: a formula for a spreadsheet as a student's name
# Stopped by: text stays text; folders get names of their own
# expect: passed
# student: =HYPERLINK("x","y")

cp "$HOSTILE/honest.h" .
cp "$HOSTILE/right.c" edge-table-closed.c
