# Tries: an engine with 30 descriptors
# Stopped by: the box cannot be made: a fault
# expect: refused

. "$HOSTILE/scene.sh"
(ulimit -n 30; "$MESHGRADE" grade class -o out --no-pictures)
tell $? out
