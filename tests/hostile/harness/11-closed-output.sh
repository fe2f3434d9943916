# Tries: an engine whose output is closed
# Stopped by: grading goes on
# expect: graded

. "$HOSTILE/scene.sh"
"$MESHGRADE" grade class -o out --no-pictures >&- 2>&-
code=$?
[ "$code" -eq 0 ] || [ "$code" -eq 2 ] || echo "exit code $code"
tell 0 out
