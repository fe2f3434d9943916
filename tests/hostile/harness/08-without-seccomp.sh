# Tries: grading without the one layer that everything stands on
# Stopped by: the box
# expect: refused

. "$HOSTILE/scene.sh"
"$MESHGRADE" grade class -o out --no-pictures --without seccomp
tell $? out
