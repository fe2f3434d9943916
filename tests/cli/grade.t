#!/bin/bash
# meshgrade grade: layouts, results, resuming, rejudging, exports.
. "$(dirname "$0")/tap.sh"
edges=$submissions/edges/edge-table-any
euler=$submissions/topology/euler-closed-mesh
right_euler=$(ls "$euler"/right/*.c | head -n 1)

class=$scratch/class
mkdir -p "$class/Ana García" "$class/<b>Mallory</b>" "$scratch/zip/Bruno" "$scratch/zip/Berta" "$scratch/moodle/Carla Puig_77_assignsubmission_file_"
cp "$edges/right/sort.c" "$class/Ana García/edge-table-any.c"
cp "$right_euler" "$class/Ana García/euler-closed-mesh.c"
cp "$edges/wrong/boundary-lost.c" "$class/<b>Mallory</b>/edge-table-any.c"
cp "$right_euler" "$scratch/zip/Bruno/euler_closed_mesh.c"
cp "$right_euler" "$scratch/zip/Berta/euler_closed_mesh.c"
cp "$right_euler" "$scratch/moodle/Carla Puig_77_assignsubmission_file_/euler-closed-mesh.c"
(cd "$scratch/zip" && zip -qr ../b.zip .)
(cd "$scratch/moodle" && zip -qr ../moodle.zip .)
uploads=("$class" "$scratch/b.zip" "$scratch/moodle.zip")
out=$scratch/out

"$meshgrade" grade "${uploads[@]}" -o "$out" >"$scratch/marks" 2>"$scratch/talk"
code=$?
ok "a class with a wrong answer ends with 1" [ "$code" -eq 1 ]
ok "index.html, grades.csv and the store are there" [ -s "$out/index.html" -a -s "$out/grades.csv" -a -s "$out/meshgrade.sqlite" ]
ok "six results are there" [ "$(ls "$out"/results/*/*.json | wc -l)" -eq 6 ]
ok "the table of marks goes to stdout" matches "$scratch/marks" 'Ana Garc'
ok "no scratch is left" [ ! -e "$out/scratch" ]
ok "results keep the contract" python3 - "$out" <<'P'
import glob, json, sys
for path in glob.glob(sys.argv[1] + "/results/*/*.json"):
    r = json.load(open(path))
    for key in "student exercise verdict cause score max_score cases measures protections".split():
        assert key in r, (path, key)
    assert path.split("/")[-1] == r["exercise"] + ".json" and path.split("/")[-2] == r["student_folder"]
    for case in r["cases"]:
        assert all(k in case for k in ("name", "class", "verdict", "message"))
        assert case["verdict"] == "passed" or "element" in case
    assert r["max_score"] == 10
P
if [ -x build/meshgrade-render ]; then
    ok "rejected cases have pictures" sh -c 'ls "$1"/pictures/*/edge-table-any/*.png >/dev/null' - "$out"
else
    skip "rejected cases have pictures" "meshgrade-render was not built"
fi

cp -r "$out/results" "$scratch/first"
"$meshgrade" grade "${uploads[@]}" -o "$out" >/dev/null 2>"$scratch/talk"
ok "grading again changes nothing" diff -r "$scratch/first" "$out/results"

seed_of() {
    python3 -c 'import glob, json, sys
seeds = {json.load(open(p))["engine"]["seed"] for p in glob.glob(sys.argv[1] + "/results/*/*.json")} - {""}
print(*seeds)' "$1"
}
seed=$(seed_of "$out")
ok "all results of a class have one seed, which is not the published one" sh -c 'expr "$1" : "[1-9][0-9]*\$" >/dev/null' - "$seed"
ok "another seed is refused in a folder with results" exits_with 2 "$meshgrade" grade "$scratch/b.zip" -o "$out" --seed $((seed % 1000 + 1)) 2>"$scratch/talk"
ok "and the line says what to do" matches "$scratch/talk" 'another folder'
ok "a seed of 0 is wrong usage" exits_with 64 "$meshgrade" grade "$scratch/b.zip" -o "$scratch/none" --seed 0 2>/dev/null
mkdir -p "$scratch/elsewhere/deep"
(for _ in 1 2; do (while :; do :; done) & echo $!; done) >"$scratch/busy"
(cd "$scratch/elsewhere/deep" && PADDING=$(head -c 5000 /dev/zero | tr '\0' x) "$meshgrade" grade "${uploads[@]}" -o other --seed "$seed" --no-pictures >/dev/null 2>&1)
while read -r pid; do kill "$pid"; done <"$scratch/busy"
ok "busy cores, another folder and environment: the same bytes" diff -r "$scratch/first" "$scratch/elsewhere/deep/other/results"

cp "$edges/right/hash-table.c" "$class/<b>Mallory</b>/edge-table-any.c"
"$meshgrade" grade "${uploads[@]}" -o "$out" --no-pictures >/dev/null 2>&1
ok "a new file is graded anew, and now everybody passed" [ $? -eq 0 ]
"$meshgrade" grade "$scratch/b.zip" -o "$out" --rejudge --no-pictures >/dev/null 2>"$scratch/talk"
ok "rejudging tells that nothing differs" matches "$scratch/talk" '^0 results differ'

for format in csv gradescope junit vpl json; do
    student=()
    [ $format != vpl ] || student=(--student Bruno)
    "$meshgrade" export "$out" --format $format "${student[@]}" >"$scratch/export.$format" 2>"$scratch/talk"
    ok "export $format" [ $? -eq 0 -a -s "$scratch/export.$format" ]
done
ok "the exports parse" python3 - "$scratch" <<'P'
import csv, json, sys, xml.etree.ElementTree as xml
f = sys.argv[1] + "/export."
rows = list(csv.reader(open(f + "csv", newline="")))
assert len(rows) == 6 and len({len(r) for r in rows}) == 1, rows
json.load(open(f + "json")), json.load(open(f + "gradescope"))
xml.parse(f + "junit")
P
ok "Moodle VPL gets the grade on its last line" sh -c 'tail -n 1 "$1" | grep -qx "Grade :=>> 10"' - "$scratch/export.vpl"
ok "an unknown format is refused" exits_with 64 "$meshgrade" export "$out" --format excel 2>/dev/null
ok "a store that is no database is refused with a remedy" sh -c '
    mkdir "$2/bad" && echo rubbish-rubbish-rubbish-rubbish >"$2/bad/meshgrade.sqlite"
    "$1" grade "$3" -o "$2/bad" 2>"$2/talk"; [ $? -eq 2 ] && grep -q "move the file away" "$2/talk"' - "$meshgrade" "$scratch" "$scratch/b.zip"
done_testing
