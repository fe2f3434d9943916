#!/bin/bash
# meshgrade calibrate: its table and its JSON; how noisy the machine is decides nothing here.
. "$(dirname "$0")/tap.sh"
mkdir "$scratch/temporary"
export TMPDIR=$scratch/temporary
"$meshgrade" calibrate --trials 1 --json >"$scratch/noise.json" 2>"$scratch/err"
ok "one trial of every kernel" [ $? -eq 0 ]
python3 - "$scratch/noise.json" >"$scratch/said" <<'PYTHON'
import json, sys
noise = json.load(open(sys.argv[1]))
rows = noise["rows"]
assert noise["format"] == "meshgrade-calibration-1"
assert {row["mesh"] for row in rows} == {"torus-10k-generated", "bunny-100k-scrambled"}
assert all(row["trials"] == 1 and 0 <= row["false_alarms"] <= 1 and row["ns"] > 0 for row in rows)
assert noise["trials"] == len(rows)
assert {"area", "twins", "vertex-normals"} <= {row["kernel"] for row in rows}
print("sound")
PYTHON
ok "its JSON counts what was measured" matches "$scratch/said" '^sound$'
ok "no trials are no calibration" exits_with 64 "$meshgrade" calibrate --trials 0 2>"$scratch/err"
ok "operands are refused with a remedy" exits_with 64 "$meshgrade" calibrate now 2>"$scratch/err"
ok "and it says so" matches "$scratch/err" 'takes no operands'
ok "nothing is left in the scratch folder" [ -z "$(ls "$TMPDIR")" ]
done_testing
