# Tries: a name on disk that other systems take for a path
# Stopped by: the upload: backslashes in names; nobody else is refused
# expect: compile-error, folder-path

cp "$HOSTILE/right.c" edge-table-closed.c
cp "$HOSTILE/honest.h" .
cp "$HOSTILE/right.c" 'src\..\main.c'
