# Tries: grading where the tools would see the host's files
# Stopped by: the box: neither private root nor Landlock
# expect: refused

. "$HOSTILE/scene.sh"
grade --without private-root,landlock
tell $? out "neither private root nor Landlock"
