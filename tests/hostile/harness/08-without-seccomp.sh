# Tries: grading without the one layer that everything stands on
# Stopped by: the box
# expect: refused

. "$HOSTILE/scene.sh"
grade --without seccomp
tell $? out "without seccomp"
