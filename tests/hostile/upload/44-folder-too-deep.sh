# Tries: 40 folders in each other, on disk
# Stopped by: the upload: the depth of paths; nobody else is refused
# expect: compile-error, folder-path

cp "$HOSTILE/right.c" edge-table-closed.c
cp "$HOSTILE/honest.h" .
mkdir -p "$(printf 'a/%.0s' $(seq 40))"
cp "$HOSTILE/right.c" "$(printf 'a/%.0s' $(seq 40))"
