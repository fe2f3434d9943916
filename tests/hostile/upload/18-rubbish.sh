# Tries: bytes without a meaning
# Stopped by: the reader of archives: broken
# expect: compile-error, archive-broken

head -c 100000 "$HOSTILE/../../build/meshgrade" >upload.zip
