# Tries: a protection of an unknown name left out
# Stopped by: the command line
# expect: refused

. "$HOSTILE/scene.sh"
grade --without everything
tell $? out "see meshgrade doctor"
