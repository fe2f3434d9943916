#!/bin/bash
# A class that is continued with other tools (compiler, libc, valgrind, layers): told, and not mixed
# in silence.
. "$(dirname "$0")/tap.sh"
euler=$(ls "$submissions"/topology/euler-closed-mesh/right/*.c | head -n 1)
class=$scratch/class out=$scratch/out
hands_in() { mkdir -p "$class/$1" && cp "$euler" "$class/$1/euler-closed-mesh.c"; }
grade() { "$meshgrade" grade "$class" -o "$out" --no-pictures -j 1 "$@" >"$scratch/marks" 2>"$scratch/talk"; }

# Makes a stored result say that it was made with something else.
fake() { # student, key, text
    python3 - "$out/meshgrade.sqlite" "$@" <<'P'
import hashlib, json, sqlite3, struct, sys
path, student, key, text = sys.argv[1:]
store = sqlite3.connect(path)
row = list(store.execute("SELECT student_folder, exercise, digest, result, scenes FROM result WHERE student_folder = ?", (student,)).fetchone())
result = json.loads(row[3])
assert result["engine"][key], (key, "is not recorded")
result["engine"][key] = text
row[3] = json.dumps(result)
seal = hashlib.sha256(b"".join(struct.pack("<Q", len(c.encode())) + c.encode() for c in row)).hexdigest()
store.execute("UPDATE result SET result = ?, seal = ? WHERE student_folder = ?", (row[3], seal, student))
store.commit()
P
}

hands_in ana
hands_in bea
grade
ok "a class is graded" [ $? -eq 0 ]
ok "each result tells its tools" python3 - "$out" <<'P'
import glob, json, subprocess, sys
first = lambda *command: subprocess.run(command, capture_output=True, text=True).stdout.splitlines()[0]
for path in glob.glob(sys.argv[1] + "/results/*/*.json"):
    engine = json.load(open(path))["engine"]
    assert engine["compiler"] == first("gcc", "--version") and engine["libc"] == first("ldd", "--version"), engine
    assert engine["layers"].startswith("all"), engine
P
ok "nothing is said of tools where all are the same" sh -c '! grep -q "Made with different tools" "$1/index.html"' - "$out"

for key in compiler libc valgrind layers; do
    rm -rf "$scratch/kept"
    cp -r "$out" "$scratch/kept"
    [ "$key" != valgrind ] || [ -x /usr/bin/valgrind ] || { skip "$key" "no valgrind here"; continue; }
    fake ana "$key" "another $key 1.0"
    grade
    ok "another $key: with nothing new to grade all is well" [ $? -eq 0 ]
    hands_in carla
    grade
    code=$?
    ok "another $key: refused before a new answer is graded" [ "$code" -eq 2 -a ! -e "$out/results/carla" ]
    ok "in one line" [ "$(wc -l <"$scratch/talk")" -eq 1 ]
    ok "that says what differs and what to do" matches "$scratch/talk" \
        "^meshgrade: 1 result in this folder was made with other tools \($key: another $key 1.0 there, .+ here\): .*--rejudge --apply.*another folder.*--mixed"
    rm -rf "$class/carla" "$out"
    cp -r "$scratch/kept" "$out"
done

fake ana libc "another libc 1.0"
hands_in carla
grade --rejudge
ok "what would change can be looked at" [ $? -eq 0 ]
grade --rejudge --apply --only bea
ok "grading some anew mixes, too" [ $? -eq 2 ]
grade --mixed
ok "--mixed goes on" [ $? -eq 0 -a -e "$out/results/carla/euler-closed-mesh.json" ]
ok "and the class page tells, in both languages" sh -c 'grep -q "Made with different tools" "$1/index.html" && grep -q "Hechos con herramientas distintas" "$1/index.html"' - "$out"
ok "with the results that differ" python3 - "$out/index.html" <<'P'
import re, sys
page = re.sub(r"<[^>]*>", "", open(sys.argv[1]).read())
line = next(l for l in page.splitlines() if "another libc 1.0" in l)
assert re.search(r"another libc 1\.0[^:]*:[^:]*: ana \(euler-closed-mesh\)", page.replace("\n", " ")), line[:500]
P
grade --rejudge --apply
ok "all anew makes them of one measure" [ $? -eq 0 ]
hands_in dora
grade
ok "and the class goes on" [ $? -eq 0 -a -e "$out/results/dora/euler-closed-mesh.json" ]
ok "with nothing to tell" sh -c '! grep -q "Made with different tools" "$1/index.html"' - "$out"

hands_in elsa
grade --without cgroup-pids
ok "another set of layers is told for real" [ $? -eq 2 ]
ok "by name" matches "$scratch/talk" 'layers: all.* there, all but .*cgroup-pids.* here'
done_testing
