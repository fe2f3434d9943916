# Tries: a source in UTF-16
# Stopped by: the compiler
# expect: compile-error, syntax

iconv -f UTF-8 -t UTF-16 "$HOSTILE/right.c" >edge-table-closed.c
