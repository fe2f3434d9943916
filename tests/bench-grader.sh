#!/bin/bash
# What a verdict costs, in CPU seconds of one core: a full check of every right answer of every exercise
# against the goal of 2.5 s, a quick one against 1 s, dearest first, and where the time of the dearest goes.
#
#   tests/bench-grader.sh [EXERCISE]...     all exercises without one
#
# Exits 1 when an answer misses a goal or is not passed.
set -eu
cd "$(dirname "$0")/.."
full_goal=2.5 quick_goal=1.0
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cpu() { # command... -> user + system seconds
    local TIMEFORMAT='%U %S'
    { time "$@" >/dev/null 2>&1; } 2>&1 | awk '{printf "%.2f", $1 + $2}'
}
sum() { awk '/s of CPU/ {for (i = 1; i <= NF; i++) if ($(i + 1) == "s") t += $i} END {printf "%.2f", t}' "$1"; }

for exercise in ${*:-$(build/meshgrade list | awk '{print $1}')}; do
    for answer in tests/submissions/*/"$exercise"/right/*.c; do
        code=0
        build/meshgrade check "$exercise" --all --times "$answer" >"$scratch/out" 2>"$scratch/times" || code=$?
        full=$(sum "$scratch/times")
        quick=$(cpu build/meshgrade check "$exercise" --quick "$answer")
        echo "$full $quick $exercise $(basename "$answer") $code" >>"$scratch/all"
        cp "$scratch/times" "$scratch/$exercise-$(basename "$answer").times"
    done
done
sort -k 1,1nr "$scratch/all" >"$scratch/sorted"

printf '%-24s %-26s %10s %10s\n' exercise 'right answer' "full, s" "quick, s"
awk -v full="$full_goal" -v quick="$quick_goal" '{
    why = ($1 > full ? "  full misses " full " s" : "") ($2 > quick ? "  quick misses " quick " s" : "")
    if ($5 != 0)
        why = why "  not passed"
    printf "%-24s %-26s %10.2f %10.2f%s\n", $3, $4, $1, $2, why
    missed += why != ""
    if ($2 > dearest) dearest = $2
    sum += $1
    first = NR == 1 ? $1 : first
} END {
    printf "%d right answers: %d miss a goal; full %.2f s at most, %.2f s on average (goal %s); quick %.2f s at most (goal %s)\n",
        NR, missed, first, sum / NR, full, dearest, quick
    exit missed > 0
}' "$scratch/sorted" && missed=0 || missed=1
echo "A full verdict is one submission's own; the reference is built, run and counted once a run and exercise."
echo "A quick check is the whole program, reference included."
read -r _ _ exercise answer _ <"$scratch/sorted"
echo
echo "where the time of the dearest goes, $exercise/right/$answer:"
grep 's of CPU' "$scratch/$exercise-$answer.times"
exit "$missed"
