#!/bin/bash
# One run at a time writes into a folder of results; a second one says who is at work there.
. "$(dirname "$0")/tap.sh"
mkdir -p "$scratch/class/ana"
cp "$submissions/topology/euler-closed-mesh/right/by-faces.c" "$scratch/class/ana/euler-closed-mesh.c"
cd "$scratch" || exit 1

# Stopped as soon as it has the lock: what a second run would find long after it had begun.
"$meshgrade" grade class -o two --seed 7 --no-pictures >first 2>first.talk &
first=$!
until [ -s two/meshgrade.lock ] || ! kill -0 $first 2>/dev/null; do sleep 0.01; done
kill -STOP $first

for command in "grade class -o two --seed 7" "grade class -o two --seed 7 --rejudge" "report two"; do
    # shellcheck disable=SC2086
    "$meshgrade" $command >second 2>second.talk
    ok "$command: refused while another run is at work there" [ $? -eq 2 -a ! -s second ]
    ok "in one line" [ "$(wc -l <second.talk)" -eq 1 ]
    ok "that says who, where and since when" matches second.talk \
        "^meshgrade: two: another meshgrade is at work there \(process $first on $(hostname), since [0-9]{4}-[0-9-]+ [0-9:]+ UTC\); wait"
done
"$meshgrade" bench --quick -o two >second 2>second.talk
ok "a benchmark does not mix in either" [ $? -eq 2 -a "$(grep -c 'another meshgrade' second.talk)" -eq 1 -a ! -e two/journal.jsonl ]
kill -CONT $first
wait $first
ok "the first run ends well" [ $? -eq 0 ]
ok "and its result is no fault" grep -q '"verdict": "passed"' two/results/ana/euler-closed-mesh.json

"$meshgrade" grade class -o two --seed 7 --no-pictures >second 2>second.talk
ok "after its end the folder is free" [ $? -eq 0 ]

# Killed, it leaves its name behind, but no lock.
"$meshgrade" grade class -o killed --seed 7 --no-pictures >first 2>&1 &
first=$!
until [ -s killed/meshgrade.lock ] || ! kill -0 $first 2>/dev/null; do sleep 0.01; done
kill -KILL $first
wait $first 2>/dev/null
ok "a killed run leaves its name" matches killed/meshgrade.lock "^process $first on "
"$meshgrade" grade class -o killed --seed 7 --no-pictures >second 2>second.talk
ok "and no lock" [ $? -eq 0 ]
done_testing
