# Tries: no source at all
# Stopped by: the upload: nothing to grade, which the terminal says
# expect: no result

mkdir edge-table-closed
echo 'I could not.' >edge-table-closed/notes.txt
