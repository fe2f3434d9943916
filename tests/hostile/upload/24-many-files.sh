# Tries: thirty files
# Stopped by: the upload: the number of files
# expect: compile-error, too-many-files

mkdir edge-table-closed
cd edge-table-closed
cp "$HOSTILE/right.c" edge-table-closed.c
for i in $(seq 30); do echo "int x$i;" >"f$i.c"; done
