# Tries: an engine with 60 MB of address space
# Stopped by: what cannot be allocated is a fault
# expect: refused

. "$HOSTILE/scene.sh"
(ulimit -v 60000; "$MESHGRADE" grade class -o out --no-pictures)
tell $? out
