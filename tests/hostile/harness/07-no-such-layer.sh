# Tries: a protection of an unknown name left out
# Stopped by: the command line
# expect: refused

. "$HOSTILE/scene.sh"
"$MESHGRADE" grade class -o out --no-pictures --without everything
tell $? out
