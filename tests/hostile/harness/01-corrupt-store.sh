# Tries: a result store that is none
# Stopped by: the store: a remedy is named, nothing is overwritten
# expect: refused

. "$HOSTILE/scene.sh"
head -c 5000 "$MESHGRADE" >out/meshgrade.sqlite
grade
tell $? out "move the file away"
