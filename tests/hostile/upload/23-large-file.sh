# Tries: a source of 2 MB
# Stopped by: the upload: the size of a file
# expect: compile-error, file-too-large

head -c 2000000 /dev/zero | tr '\0' '\n' >edge-table-closed.c
