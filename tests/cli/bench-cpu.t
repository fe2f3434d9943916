#!/bin/bash
# MESHGRADE_CPU: the benchmark as on a machine with fewer vectors. No time is asserted.
. "$(dirname "$0")/tap.sh"
out=$scratch/out
run=("$meshgrade" bench kernels --mesh torus-1k-scrambled --blocks 1 -o "$out")

MESHGRADE_CPU=sse "${run[@]}" >"$scratch/table" 2>"$scratch/talk"
ok "a value that is none is refused" [ $? -eq 64 ]
ok "in one line that names those that are" sh -c '[ "$(wc -l <"$1")" -eq 1 ] && grep -q "plain, avx2 or avx512" "$1"' - "$scratch/talk"
ok "and measures nothing" [ ! -e "$out" ]

ok "plain C runs" sh -c 'table=$1; shift; MESHGRADE_CPU=plain "$@" >"$table" 2>/dev/null' - "$scratch/table" "${run[@]}"
cp "$out/bench.json" "$scratch/plain.json"
cp "$out/journal.jsonl" "$scratch/plain.jsonl"
ok "without a variant that has vectors" sh -c '! grep -qE "^ .*avx" "$1"' - "$scratch/table"
ok "and the table says who took them" matches "$scratch/table" '; vectors: plain'

"${run[@]}" >"$scratch/table" 2>"$scratch/talk"
ok "results of other vectors are not mixed" python3 - "$scratch" "$out" <<'P'
import json, sys
plain, full = (json.load(open(f)) for f in (sys.argv[1] + "/plain.json", sys.argv[2] + "/bench.json"))
most = full["machine"]["processor_vectors"]
assert plain["machine"]["vectors"] == "plain" and plain["machine"]["processor_vectors"] == most
assert full["machine"]["vectors"] == most
assert {r["variant"] for r in plain["rows"]} == {"plain", "threads"}
expected = {"plain": {"plain"}, "avx2": {"plain", "avx2"}, "avx512": {"plain", "avx2", "avx512"}}
assert {r["variant"] for r in full["rows"]} == expected[most] | {"threads"}
assert all(r["answer"] == "equal" for d in (plain, full) for r in d["rows"] if r["ratio"])
talk = open(sys.argv[1] + "/talk").read()
assert ("measuring anew" in talk) == (most != "plain"), talk
P
done_testing
