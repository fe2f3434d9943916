# Tries: no source at all
# Stopped by: the upload: nothing to grade
# expect: compile-error, no-source

mkdir edge-table-closed
echo 'I could not.' >edge-table-closed/notes.txt
