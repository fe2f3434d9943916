# Tries: an engine with 60 MB of address space
# Stopped by: what cannot be allocated is a fault
# expect: refused

. "$HOSTILE/scene.sh"
(ulimit -v 60000; grade)
tell $? out "(memory|rlimits)"
