#!/bin/bash
# What a verdict costs, in CPU seconds of one core: a full check of a right submission of every exercise
# against the goal of 4 s, a quick one against 1.5 s, and where the time of a full one goes.
set -eu
cd "$(dirname "$0")/.."
cpu() { # command... -> user + system seconds
    local TIMEFORMAT='%U %S'
    { time "$@" >/dev/null 2>&1; } 2>&1 | awk '{printf "%.2f", $1 + $2}'
}
printf '%-24s %18s %18s %22s\n' exercise 'verdict, s (<= 4)' 'quick, s (<= 1.5)' 'reference once, s'
for folder in tests/submissions/*/*/; do
    exercise=$(basename "$folder")
    file=$(ls "$folder"right/*.c | head -n 1)
    quick=$(cpu build/meshgrade check "$exercise" --quick "$file")
    # A class of one and a class of two: the difference is one verdict, the rest is the reference.
    work=$(mktemp -d)
    mkdir -p "$work/one/a" "$work/two/a" "$work/two/b"
    for to in one/a two/a two/b; do cp "$file" "$work/$to/$exercise.c"; done
    one=$(cpu build/meshgrade grade "$work/one" -o "$work/out1" --no-pictures -j 1)
    two=$(cpu build/meshgrade grade "$work/two" -o "$work/out2" --no-pictures -j 1)
    verdict=$(awk -v a="$one" -v b="$two" 'BEGIN {printf "%.2f", b - a}')
    once=$(awk -v a="$one" -v v="$verdict" 'BEGIN {printf "%.2f", a - v}')
    printf '%-24s %18s %18s %22s\n' "$exercise" "$verdict" "$quick" "$once"
    rm -rf "$work"
done
echo
echo "where the time of one verdict goes (edge-table-any, CPU seconds by program):"
work=$(mktemp -d)
mkdir -p "$work/one/a"
cp tests/submissions/edges/edge-table-any/right/sort.c "$work/one/a/edge-table-any.c"
if command -v strace >/dev/null; then
    strace -f -e trace=execve,exit_group -tt -o "$work/trace" build/meshgrade grade "$work/one" -o "$work/out" \
        --no-pictures -j 1 >/dev/null 2>&1 || true
    awk '/execve\(/ && / = 0$/ {match($0, /execve\("[^"]*"/); p = substr($0, RSTART + 8, RLENGTH - 9); n[p]++}
         END {for (p in n) printf "  %5d starts of %s\n", n[p], p}' "$work/trace" | sort -rn | head -n 12
else
    echo "  (strace is not installed: the programs that are started are not listed)"
fi
rm -rf "$work"
