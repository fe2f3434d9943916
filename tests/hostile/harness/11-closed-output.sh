# Tries: an engine whose output is closed
# Stopped by: grading goes on
# expect: graded

. "$HOSTILE/scene.sh"
"$MESHGRADE" grade class -o out --no-pictures >&- 2>&-
tell $(($? > 1 ? 0 : $?)) out
