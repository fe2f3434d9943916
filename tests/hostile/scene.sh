# Sourced by the scenes of harness/: a class of one right answer, and how grading it ended.
mkdir class class/ana out
cp "$ROOT/tests/submissions/edges/edge-table-closed/right/two-passes.c" class/ana/edge-table-closed.c

# Grades the class into `out`; what is said goes to `log`.
grade() { # options...
    "$MESHGRADE" grade class -o out --no-pictures "$@" >log 2>&1
}

# Says "refused" for a refusal or fault that ends with code 2 (64: the command line), gives nobody a score, passing
# or failing, and says what is the matter; "graded" for a result of full marks; else what is wrong.
tell() { # exit code, out folder, pattern of what must be said
    local scores
    scores=$(cat "$2"/results/*/*.json 2>/dev/null | grep -cE '"score": *-?[0-9]')
    if [ "$1" -eq 0 ] && [ "$scores" -gt 0 ] && grep -qs '"verdict": "passed"' "$2"/results/*/*.json; then
        echo graded
    elif [ "$scores" -gt 0 ]; then
        echo "a score in spite of exit code $1"
    elif [ "$1" -ne 2 ] && [ "$1" -ne 64 ]; then
        echo "no score, but exit code $1"
    elif ! grep -qE "^meshgrade: .*$3" log; then
        echo "refused without a word of $3"
    else
        echo refused
    fi
}
