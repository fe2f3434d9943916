# Tries: a folder for results that cannot be made
# Stopped by: the store
# expect: refused

. "$HOSTILE/scene.sh"
"$MESHGRADE" grade class -o /proc/meshgrade-out --no-pictures >log 2>&1
tell $? /proc/meshgrade-out "/proc/meshgrade-out: "
