# Tries: an archive of a kind that is not read
# Stopped by: the upload: with advice
# expect: compile-error, archive-kind

printf 'Rar!\032\007\000rubbish' >upload.rar
