# Tries: a class that is not there
# Stopped by: the command line
# expect: refused

. "$HOSTILE/scene.sh"
"$MESHGRADE" grade nowhere -o out --no-pictures >log 2>&1
tell $? out "nowhere: "
