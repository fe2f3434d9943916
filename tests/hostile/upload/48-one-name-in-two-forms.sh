# Tries: two files whose names look the same: é as one character, and as e with an accent
# Stopped by: the upload: names of files are plain ASCII
# expect: compile-error, file-name

cp "$HOSTILE/honest.h" "$HOSTILE/right.c" .
mv right.c edge-table-closed.c
printf 'static int one;\n' >"$(printf 'h\303\251lper.h')"
printf 'static int two;\n' >"$(printf 'he\314\201lper.h')"
