# Tries: results that cannot be written whole
# Stopped by: every file is written beside and then renamed; the store is one transaction
# expect: refused

. "$HOSTILE/scene.sh"
(ulimit -f 8; "$MESHGRADE" grade class -o out --no-pictures)
tell $? out
