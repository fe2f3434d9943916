#!/bin/bash
# kill -9 of grade at 20 points, then grade again: the same results as an undisturbed run.
. "$(dirname "$0")/tap.sh"
class=$scratch/class
euler=$submissions/topology/euler-closed-mesh
for student in a b c; do mkdir -p "$class/$student"; done
cp "$(ls "$euler"/right/*.c | head -n 1)" "$class/a/euler-closed-mesh.c"
cp "$(ls "$euler"/wrong/*.c | head -n 1)" "$class/b/euler-closed-mesh.c"
cp "$(ls "$euler"/wrong/*.c | tail -n 1)" "$class/c/euler-closed-mesh.c"

"$meshgrade" grade "$class" --seed 1 -o "$scratch/whole" --no-pictures -j 1 >/dev/null 2>&1
ok "an undisturbed run gives three results" [ "$(ls "$scratch"/whole/results/*/*.json | wc -l)" -eq 3 ]

# The points follow the CPU time charged to the run and its children, so they spread over its steps
# however busy the machine is. A point beyond the end of the run kills nothing, and must change nothing.
points=20
left=
mkfifo "$scratch/never"
for ((k = 1; k <= points; k++)); do
    out=$scratch/out$k
    "$meshgrade" grade "$class" --seed 1 -o "$out" --no-pictures -j 1 >/dev/null 2>&1 &
    pid=$!
    spent=0
    while [ "$spent" -lt $((k * 6)) ] && kill -0 $pid 2>/dev/null; do
        read -r -t 0.005 <>"$scratch/never" # waits, so that the run has the core
        read -r _ _ _ _ _ _ _ _ _ _ _ _ _ utime stime cutime cstime _ <"/proc/$pid/stat" 2>/dev/null || break
        spent=$((utime + stime + cutime + cstime))
    done
    kill -9 $pid 2>/dev/null
    wait $pid 2>/dev/null
    "$meshgrade" grade "$class" --seed 1 -o "$out" --no-pictures -j 1 >/dev/null 2>&1
    ok "killed at point $k, graded again" diff -r "$scratch/whole/results" "$out/results"
    [ ! -e "$out/scratch" ] || left="$left $k"
    rm -rf "$out"
done
ok "no run after a kill leaves a scratch folder" [ -z "$left" ]
done_testing
