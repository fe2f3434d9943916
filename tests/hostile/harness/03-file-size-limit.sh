# Tries: results that cannot be written whole
# Stopped by: every file is written beside and then renamed; the store is one transaction
# expect: refused

. "$HOSTILE/scene.sh"
(ulimit -f 8; "$MESHGRADE" grade class -o out --no-pictures 2>&1) | cat >log
tell "${PIPESTATUS[0]}" out "(large|full|write|disk)"
