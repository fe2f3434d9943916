#!/bin/bash
# What a verdict costs, in CPU seconds of one core: a full check of a right submission of every exercise
# against the goal of 4 s, a quick one against 1.5 s, and where the time of a full one goes.
set -eu
cd "$(dirname "$0")/.."
cpu() { # command... -> user + system seconds
    local TIMEFORMAT='%U %S'
    { time "$@" >/dev/null 2>&1; } 2>&1 | awk '{printf "%.2f", $1 + $2}'
}
file_of() { ls "$1"right/*.c | head -n 1; }
sum() { awk '/s of CPU/ {for (i = 1; i <= NF; i++) if ($(i + 1) == "s") t += $i} END {printf "%.2f", t}'; }

printf '%-24s %18s %18s\n' exercise 'verdict, s (<= 4)' 'quick, s (<= 1.5)'
for folder in tests/submissions/*/*/; do
    exercise=$(basename "$folder")
    verdict=$(build/meshgrade check "$exercise" --all --times "$(file_of "$folder")" 2>&1 >/dev/null | sum)
    quick=$(cpu build/meshgrade check "$exercise" --quick "$(file_of "$folder")")
    printf '%-24s %18s %18s\n' "$exercise" "$verdict" "$quick"
done
echo "A verdict is one submission's own; the reference is built and counted once a run and exercise. A quick"
echo "check is the whole program, reference included."
for exercise in edge-table-any mesh-area; do
    echo
    echo "where the time of a verdict goes, $exercise:"
    build/meshgrade check "$exercise" --all --times "$(file_of "$(echo tests/submissions/*/$exercise/)")" 2>&1 >/dev/null | grep 's of CPU'
done
