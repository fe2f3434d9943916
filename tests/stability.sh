#!/bin/bash
# Grades the demo class RUNS times: idle, with both cores busy, with a larger environment, from other
# folders. Reports results that differ (marks, verdicts, counts: every byte of the result files).
#
#   tests/stability.sh RUNS [CLASS]     CLASS: the folder of uploads (default: the demo class)
set -eu
runs=$1
cd "$(dirname "$0")/.."
root=$PWD
work=$(mktemp -d)
busy=()
cleanup() {
    for pid in "${busy[@]}"; do kill "$pid" 2>/dev/null || true; done
    rm -rf "$work"
}
trap cleanup EXIT
class=${2:-}
if [ -z "$class" ]; then
    class=$work/class
    tests/demo-class.sh "$class"
fi

grade() { # run number
    local run=$1 folder=$work/run$1 extra=()
    mkdir -p "$folder/deeper/and/deeper"
    case $((run % 4)) in
    1) for _ in 1 2 3 4; do (while :; do :; done) & busy+=($!); done ;;
    2) extra=(env "PADDING=$(head -c 5000 /dev/zero | tr '\0' x)") ;;
    3) folder=$folder/deeper/and/deeper ;;
    esac
    (cd "$folder" && "${extra[@]}" "$root/build/meshgrade" grade "$class"/* -o "$folder/out" --no-pictures >/dev/null 2>"$folder/log") || [ $? -le 1 ] || cat "$folder/log"
    for pid in "${busy[@]}"; do kill "$pid" 2>/dev/null || true; done
    busy=()
    (cd "$folder/out/results" && find . -name '*.json' | LC_ALL=C sort | xargs -d '\n' sha256sum) >"$work/sums$run"
}

differing=0
for ((run = 0; run < runs; run++)); do
    grade "$run"
    if [ "$run" -gt 0 ]; then
        differ=$(diff "$work/sums0" "$work/sums$run" | grep -c '^>' || true)
        differing=$((differing + differ))
        echo "run $run: $(wc -l <"$work/sums$run") results, $differ differ from run 0"
        [ "$differ" -eq 0 ] || diff "$work/sums0" "$work/sums$run" | grep '^>' | head -n 5
    fi
done
echo "$runs runs, $differing results differ"
[ "$differing" -eq 0 ]
