#!/bin/bash
# Grades one class RUNS times in different surroundings and counts what differs: marks (verdict,
# cause, score, every case and its message) and counts (every number measured).
#
#   tests/stability.sh RUNS [CLASS]
#
# CLASS: "known" (three students made of known-verdict submissions of every kind), "demo" (the
# class of `make demo`), or a folder of uploads. Surroundings, in turn: quiet, 2 and 4 busy
# processes, a larger environment, a deep folder, a plain user (when root), one core, the other core.
set -eu
runs=$1 class=${2:-known}
cd "$(dirname "$0")/.."
root=$PWD
work=$(mktemp -d)
chmod 755 "$work"
busy=()
stop_busy() {
    for pid in "${busy[@]}"; do kill "$pid" 2>/dev/null || true; done
    busy=()
}
trap 'stop_busy; rm -rf "$work"' EXIT

# One student a row of kinds; exercise by exercise the next kind of the row, where it has one.
make_known_class() { # folder
    local kinds exercise file index student=0
    for kinds in "right right right" "slow greedy wrong" "leak crash wrong"; do
        student=$((student + 1)) index=0
        read -ra kinds <<<"$kinds"
        mkdir -p "$1/student-$student"
        for exercise in "$work"/submissions/*/*/; do
            file=$(find "$exercise${kinds[index % 3]}" "${exercise}wrong" -name '*.c' 2>/dev/null | LC_ALL=C sort | head -n 1)
            cp "$file" "$1/student-$student/$(basename "$exercise").c"
            index=$((index + 1))
        done
    done
}

case $class in
known)
    build/meshgrade validate --expand "$work/submissions"
    make_known_class "$work/class"
    ;;
demo) tests/demo-class.sh "$work/class" ;;
*) cp -r "$class" "$work/class" ;;
esac
chmod -R a+rX "$work/class"
# How many results every run must bring: the known class has a submission a student and exercise; of another
# class the first run says it, and must bring one at least.
expected=0
[ "$class" != known ] || expected=$(find "$work/class" -name '*.c' | wc -l)

start_busy() { # how many
    local i
    for ((i = 0; i < $1; i++)); do
        (while :; do :; done) &
        busy+=($!)
    done
}

# Prepares the surroundings of a run: sets `folder`, `with` (a prefix of the command), `where`.
surround() { # run number
    with=() folder=$work/run$1
    local last=$(($(nproc) - 1))
    case $(($1 % 8)) in
    0) where="quiet" ;;
    1) where="2 busy processes" && start_busy 2 ;;
    2) where="4 busy processes" && start_busy 4 ;;
    3) where="larger environment" && with=(env "PADDING=$(head -c 5000 /dev/zero | tr '\0' x)") ;;
    4) where="deep folder" && folder=$folder/deeper/and/deeper/and/deeper ;;
    5) if [ "$(id -u)" = 0 ]; then
        where="plain user" with=(setpriv --reuid 65534 --regid 65534 --clear-groups)
    else
        where="plain user (as always)"
    fi ;;
    6) where="core 0" && with=(taskset -c 0) ;;
    7) where="core $last, bare environment" && with=(taskset -c "$last" env -i "PATH=$PATH") ;;
    esac
    mkdir -p "$folder"
    [ "$where" != "plain user" ] || chown -R 65534:65534 "$work/run$1"
}

marks=0 counts=0 short=0
for ((run = 0; run < runs; run++)); do
    surround "$run"
    failed=no
    (cd "$folder" && "${with[@]}" "$root/build/meshgrade" grade "$work"/class/* --seed 1 -o "$folder/out" \
        --no-pictures >/dev/null 2>"$work/log") || [ $? -le 1 ] || { cat "$work/log"; failed=yes; }
    stop_busy
    python3 tests/stability_facts.py "$folder/out/results" "$work/marks$run" "$work/counts$run"
    rm -rf "${work:?}/run$run"
    results=$(wc -l <"$work/marks$run")
    [ "$run" -gt 0 ] || [ "$expected" -gt 0 ] || expected=$((results > 0 ? results : 1))
    if [ "$failed" = yes ] || [ "$results" -ne "$expected" ]; then
        short=$((short + 1))
        echo "run $((run + 1)): $results results, expected $expected"
    fi
    if [ "$run" -gt 0 ]; then
        m=$(diff "$work/marks0" "$work/marks$run" | grep -c '^[<>]' || true)
        c=$(diff "$work/counts0" "$work/counts$run" | grep -c '^[<>]' || true)
        marks=$((marks + m)) counts=$((counts + c))
        [ $((m + c)) -eq 0 ] || diff "$work/marks0" "$work/marks$run" | head -n 5 || true
        [ $((m + c)) -eq 0 ] || diff "$work/counts0" "$work/counts$run" | head -n 5 || true
    fi
    printf 'run %3d of %d  %-30s %s results  %d marks and %d counts differ so far\n' \
        $((run + 1)) "$runs" "$where" "$results" "$marks" "$counts"
done
echo "$runs runs: $marks differing marks, $counts differing counts, $short incomplete runs"
[ $((marks + counts + short)) -eq 0 ] && [ "$runs" -gt 0 ]
