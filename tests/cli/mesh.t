#!/bin/bash
# meshgrade mesh: what it says, its exit codes, its formats, and bench on a file.
. "$(dirname "$0")/tap.sh"
models=$root/exercises/models

"$meshgrade" mesh "$models/mug.ply" >"$scratch/mug" 2>&1
ok "a clean mesh exits with 0" [ $? -eq 0 ]
ok "and is told" matches "$scratch/mug" '^✓ clean'
ok "with its genus" matches "$scratch/mug" 'genus 1$'
ok "and its bytes in fourteen representations" sh -c '[ "$(grep -cE "^    .* [0-9]+ +[0-9.]+$" "$1")" = 14 ]' - "$scratch/mug"
"$meshgrade" mesh "$models/spider.ply" >"$scratch/spider" 2>&1
ok "a mesh with faults exits with 1" [ $? -eq 1 ]
ok "the first of each kind is named" matches "$scratch/spider" 'Edge \{551,568\} is run the same way by triangles 1096 and 1097\.'
ok "and what cannot hold it" matches "$scratch/spider" 'Half edge +-  cannot hold an incoherent edge'
ok "no line is longer than 80 columns" awk 'length($0) > 80 {exit 1}' "$scratch/spider"
"$meshgrade" mesh --lang es "$models/spider.ply" >"$scratch/es"
ok "in Spanish, too" matches "$scratch/es" '^✗ 24 aristas de grietas$'
"$meshgrade" mesh --no-crossings "$models/horse.ply" >"$scratch/quick"
ok "without self-intersections the horse is clean" [ $? -eq 0 ]
ok "and it says that they were not searched" matches "$scratch/quick" 'were not searched'

printf 'off\n5 3 0\n0 0 0\n1 0 0\n0 1 0\nnan 0 0\n0 0 1\n3 0 1 2\n2 0 1\n3 0 2\n4\n' >"$scratch/left.off"
"$meshgrade" mesh "$scratch/left.off" >"$scratch/left" 2>&1
ok "what was left out is a fault of the file" [ $? -eq 1 ]
ok "and told with its line" matches "$scratch/left" '1 vertex that is not finite and that no face uses is left out, in line 6\.'
"$meshgrade" mesh --strict "$scratch/left.off" >/dev/null 2>"$scratch/talk"
ok "--strict refuses the file" [ $? -eq 64 ]
ok "and names the place" matches "$scratch/talk" 'left\.off:6: x must be a finite'
"$meshgrade" mesh - <"$scratch/left.off" >"$scratch/stdin"
ok "- reads the standard input" matches "$scratch/stdin" '4 vertices, 5 edges, 2 triangles'
printf 'OFF\n0 0 0\n' | "$meshgrade" mesh - >"$scratch/none"
ok "nothing at all is clean" [ $? -eq 0 ]

"$meshgrade" mesh --json "$models/bunny.ply" "$scratch/absent.ply" "$scratch/left.off" >"$scratch/json" 2>/dev/null
ok "a file that is absent is wrong usage, after the others" [ $? -eq 64 ]
ok "JSON tells all files" python3 - "$scratch/json" <<'P'
import json, sys
bunny, absent, left = json.load(open(sys.argv[1]))
assert bunny["vertices"] == 1877 and bunny["genus"] == 0 and bunny["volume"] is None and not bunny["clean"]
faults = {f["kind"]: f for f in bunny["faults"]}
assert len(faults) == 10 and faults["self-intersection"]["count"] == 4 == len(faults["self-intersection"]["elements"])
assert faults["self-intersection"]["elements"][0] == [1338, 3021] and faults["crack"]["complete"] is True
assert len(bunny["representations"]) == 14 and bunny["representations"][3]["bytes"] == 12 * (1877 + 3712)
assert sum(bunny["valence"]["counts"]) == 1877 and bunny["box"]["low"][0] == -0.5
assert "No such file" in absent["error"]
assert [(n["kind"], n["line"]) for n in left["notes"]] == [("lost-vertex", 6), ("short-face", 9)], left["notes"]
P

"$meshgrade" mesh >/dev/null 2>"$scratch/talk"
ok "no file is wrong usage" [ $? -eq 64 ]
"$meshgrade" mesh --picture a.png "$models/mug.ply" "$models/horse.ply" 2>/dev/null
ok "a picture of two files is wrong usage" [ $? -eq 64 ]
"$meshgrade" mesh --tolerance 0 "$models/mug.ply" 2>/dev/null
ok "a tolerance of 0 is wrong usage" [ $? -eq 64 ]
printf '\377\376v\0' >"$scratch/wide.obj"
"$meshgrade" mesh "$scratch/wide.obj" 2>"$scratch/talk"
ok "what is no mesh is wrong usage" [ $? -eq 64 ]
ok "and says why" matches "$scratch/talk" 'UTF-16'

if [ -x build/meshgrade-render ]; then
    "$meshgrade" mesh --picture "$scratch/spider.png" "$models/spider.ply" >/dev/null 2>"$scratch/talk"
    code=$?
    if grep -q OpenGL "$scratch/talk"; then
        skip "a picture is drawn" "no OpenGL here"
    else
        ok "a picture is drawn" [ $code -eq 1 -a -s "$scratch/spider.png" ]
    fi
    "$meshgrade" mesh --picture "$scratch/no/such/folder.png" "$models/mug.ply" >/dev/null 2>"$scratch/talk"
    ok "one that cannot be written is a fault" [ $? -eq 2 ]
    TMPDIR=$scratch/absent "$meshgrade" mesh --picture "$scratch/mug.png" "$models/mug.ply" >/dev/null 2>"$scratch/talk"
    ok "and so is no room for the scene, which names the place and what to do" matches "$scratch/talk" 'absent: .*set TMPDIR'
fi
"$meshgrade" mesh --page "$scratch/page" "$models/bunny.ply" >/dev/null 2>&1
ok "a page is written" [ $? -eq 1 -a -s "$scratch/page/index.html" -a -s "$scratch/page/assets/page.css" ]
ok "in both languages" matches "$scratch/page/index.html" '<span lang="es">4 autointersecciones'
ok "and asks nothing of the network" sh -c '! grep -qE "https?://" "$1"' - "$scratch/page/index.html"
done_testing
