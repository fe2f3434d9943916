# Tries: a pipe instead of a file, in a folder
# Stopped by: the upload: only plain files
# expect: compile-error, device

mkfifo edge-table-closed.c
