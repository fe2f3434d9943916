# Tries: commands for a shell, as a file's name
# Stopped by: the upload: letters, digits and ._- only
# expect: compile-error, file-name

mkdir edge-table-closed
cd edge-table-closed
cp "$HOSTILE/honest.h" .
cp "$HOSTILE/right.c" edge-table-closed.c
echo 'int extra;' >./'a;touch x;.c'
