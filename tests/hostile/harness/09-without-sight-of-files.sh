# Tries: grading where the tools would see the host's files
# Stopped by: the box: neither private root nor Landlock
# expect: refused

. "$HOSTILE/scene.sh"
"$MESHGRADE" grade class -o out --no-pictures --without private-root,landlock
tell $? out
