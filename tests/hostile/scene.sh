# Sourced by the scenes of harness/: a class of one right answer, and how grading it ended.
mkdir class class/ana out
cp "$ROOT/tests/submissions/edges/edge-table-closed/right/two-passes.c" class/ana/edge-table-closed.c

# Says "refused" for a refusal or fault without a mark, "graded" for a result, "marked" for a mark in
# spite of a refusal.
tell() { # exit code, out folder
    local marks
    marks=$(cat "$2"/results/*/*.json 2>/dev/null | grep -c '"verdict": "passed"')
    if [ "$1" -le 1 ] && [ "$marks" -gt 0 ]; then
        echo graded
    elif [ "$marks" -gt 0 ]; then
        echo marked
    else
        echo refused
    fi
}
