# Tries: 300 files of 1 MB, more than a whole class may have
# Stopped by: the upload: what is too heavy is let go, and nobody else is refused
# expect: compile-error, folder-too-large

mkdir edge-table-closed
cp "$HOSTILE/right.c" edge-table-closed/edge-table-closed.c
for i in $(seq 300); do truncate -s 1M "edge-table-closed/f$i.c"; done
