# Tries: an engine with 30 descriptors
# Stopped by: the box cannot be made: a fault
# expect: refused

. "$HOSTILE/scene.sh"
(ulimit -n 30; grade)
tell $? out "box: "
