#!/bin/bash
# meshgrade bench: results, resuming after kill -9, formats, refusals. No time is asserted.
. "$(dirname "$0")/tap.sh"
out=$scratch/out
tiny=(--mesh torus-1k-scrambled --blocks 2 -o "$out")

"$meshgrade" bench kernel 2>"$scratch/talk"
ok "an unknown comparison is refused" [ $? -eq 64 ]
ok "and the ones that exist are named" matches "$scratch/talk" 'representations, kernels, paper, readers, claims'
"$meshgrade" bench --mesh cube 2>"$scratch/talk"
ok "an unknown mesh is refused" [ $? -eq 64 ]
ok "and how to name one is said" matches "$scratch/talk" 'KIND-SIZE-ORDER'
"$meshgrade" bench representations --subject half --mesh "$root/exercises/models/mug.ply" --blocks 1 -o "$scratch/file" >"$scratch/table" 2>&1
ok "a file is a mesh, too" [ $? -eq 0 ]
ok "and the table names it" matches "$scratch/table" 'Representations on mug-[0-9a-f]{8}: 6,000 triangles, 3,000 vertices, closed'
"$meshgrade" bench --blocks x 2>"$scratch/talk"
ok "a number of blocks that is none is refused" [ $? -eq 64 ]

"$meshgrade" bench representations kernels readers "${tiny[@]}" >"$scratch/table" 2>"$scratch/talk"
ok "a tiny comparison runs" [ $? -eq 0 ]
ok "the table has a title for the mesh" matches "$scratch/table" 'Kernels on torus-1k-scrambled: [0-9,]+ triangles'
ok "representations are told" matches "$scratch/table" 'Indexed mesh +18\.'
ok "no line is longer than 100 columns" awk 'length($0) > 100 {exit 1}' "$scratch/table"
ok "stderr tells where the results are" matches "$scratch/talk" 'bench\.json'
ok "no bar without a terminal" sh -c '! grep -q "####" "$1"' - "$scratch/talk"

ok "results keep the contract" python3 - "$out" <<'P'
import csv, json, sys
d = json.load(open(sys.argv[1] + "/bench.json"))
assert d["schema"] == "meshgrade-bench-1" and d["complete"] is True
assert {"cpu", "cores", "ram_bytes", "kernel", "compiler", "caches", "copy"} <= set(d["machine"])
assert all(c["gigabytes_per_second"] > 0 for c in d["machine"]["copy"])
assert {r["what"] for r in d["rows"]} == {"representations", "kernels", "readers"}
keys = set(d["rows"][0])
for r in d["rows"]:
    assert set(r) == keys, set(r) ^ keys
    compared = r["ratio"] is not None or r["operation"] == "bytes" and r["subject"] != "indexed-mesh"
    assert r["answer"] == ("equal" if compared else "unchecked"), r
    if r["error"] is None and r["operation"] != "bytes":
        assert r["blocks"] == 2 and r["samples"] > 0, r
        t = r["ns_per_triangle"] or r["ns_per_query"]
        assert 0 < t["least"] <= t["low"] <= t["median"] <= t["high"], r
    if r["ratio"]:
        assert r["ratio"]["low"] <= r["ratio"]["median"] <= r["ratio"]["high"], r
    if r["what"] == "kernels" and r["error"] is None:
        assert r["limit"]["fraction"] > 0, r
indexed = {r["operation"]: r for r in d["rows"] if r["subject"] == "indexed-mesh"}
assert indexed["bytes"]["bytes_per_triangle"]["formula"] == indexed["bytes"]["bytes_per_triangle"]["measured"]
assert {"build", "area", "edges", "vertex-normals", "boundary-loops", "is-edge", "smooth"} <= set(indexed)
goals = {g["operation"]: g for g in d["goals"]}
assert {"edges-any", "twins", "area", "vertex-normals", "stripify", "read-off"} <= set(goals)
assert all(g["warm"]["why"] == "no peer" and g["verdict"] in ("undecided", "missed") for g in d["goals"] if g["warm"]), goals
rows = list(csv.DictReader(open(sys.argv[1] + "/bench.csv")))
assert len(rows) == len(d["rows"])
g = json.load(open(sys.argv[1] + "/google.json"))
assert g["context"]["json_schema_version"] == 1
assert all(b["real_time"] > 0 and b["time_unit"] == "ns" for b in g["benchmarks"])
P
python=/usr/bin/python3 # Debian's, for Debian's modules
if [ -r /usr/share/benchmark/compare.py ] && $python -c 'import scipy' 2>/dev/null; then
    ok "google's compare.py reads google.json" \
        sh -c '"$1" /usr/share/benchmark/compare.py --no-color benchmarks "$2/google.json" "$2/google.json" | grep -q "OVERALL_GEOMEAN"' - $python "$out"
else
    skip "google's compare.py reads google.json" "libbenchmark-tools and python3-scipy are not installed"
fi

lines=$(wc -l <"$out/journal.jsonl")
"$meshgrade" bench representations kernels readers "${tiny[@]}" --csv >"$scratch/csv" 2>/dev/null
ok "the same command measures nothing anew" [ "$(wc -l <"$out/journal.jsonl")" -eq "$lines" ]
ok "--csv prints what bench.csv has" cmp -s "$scratch/csv" "$out/bench.csv"
"$meshgrade" bench kernels "${tiny[@]}" --json >"$scratch/json" 2>/dev/null
ok "--json prints google/benchmark's schema" python3 -c 'import json, sys; assert json.load(open(sys.argv[1]))["benchmarks"]' "$scratch/json"

# Killed as soon as the second block is in the journal: that one is kept, its line whole.
killed=$scratch/killed
"$meshgrade" bench kernels --mesh torus-2k-generated --blocks 40 -o "$killed" >/dev/null 2>&1 &
pid=$!
for _ in $(seq 600); do
    [ "$(wc -l 2>/dev/null <"$killed/journal.jsonl" || echo 0)" -ge 3 ] && break
    sleep 0.05
done
kill -9 "$pid"
wait "$pid" 2>/dev/null
printf '{"job":"kernels torus-2k' >>"$killed/journal.jsonl" # as if killed while writing
kept=$(sed -n 2,3p "$killed/journal.jsonl")
"$meshgrade" bench kernels --mesh torus-2k-generated --blocks 4 -o "$killed" >/dev/null 2>"$scratch/talk"
ok "after kill -9 the finished blocks are kept" [ "$(sed -n 2,3p "$killed/journal.jsonl")" = "$kept" ]
ok "and the rest is measured" python3 - "$killed" <<'P'
import json, sys
d = json.load(open(sys.argv[1] + "/bench.json"))
assert d["complete"] and all(r["blocks"] == 4 for r in d["rows"])
for line in open(sys.argv[1] + "/journal.jsonl"):
    json.loads(line)
P

head -c 1000 "$out/meshes/torus-1k-scrambled.mesh" >"$scratch/cut.mesh"
"$meshgrade" bench --worker kernels/plain "$scratch/cut.mesh" </dev/null >"$scratch/said" 2>/dev/null
ok "a worker refuses a damaged mesh" [ $? -eq 2 ]
ok "and says so" matches "$scratch/said" '^refused .*damaged'
ok "--counts counts instructions and allocations" sh -c '"$@" >/dev/null 2>&1' - \
    "$meshgrade" bench representations --subject half-edge "${tiny[@]}" --counts
ok "and they are in the results" python3 - "$out" <<'P'
import json, os, sys
d = json.load(open(sys.argv[1] + "/bench.json"))
built = next(r for r in d["rows"] if r["subject"] == "half-edge" and r["operation"] == "build")
counts = built["counts"]
if os.access("/usr/bin/valgrind", os.X_OK):
    assert counts["instructions"] > 1000
assert counts.get("allocations", 1) > 0 and counts.get("peak_bytes", 1) > 0
P
done_testing
