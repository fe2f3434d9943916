#!/bin/bash
# meshgrade bench paper and claims: every structure gives the same answers, every claim has its row.
. "$(dirname "$0")/tap.sh"
out=$scratch/out

"$meshgrade" bench paper claims --mesh bunny-10k-scrambled --blocks 2 -o "$out" >"$scratch/table" 2>"$scratch/talk"
ok "the paper's operations are measured" [ $? -eq 0 ]
ok "the table has a title for the mesh" matches "$scratch/table" 'Paper on bunny-10k-scrambled: [0-9,]+ triangles'
ok "claims are printed against measurements" matches "$scratch/table" 'E is about 3 V +3 +2\.'
ok "no line is longer than 100 columns" awk 'length($0) > 100 {exit 1}' "$scratch/table"
ok "all structures do all operations and agree" python3 - "$out" <<'P'
import json, sys
d = json.load(open(sys.argv[1] + "/bench.json"))
ours = {r["subject"]: set() for r in d["rows"]}
for r in d["rows"]:
    assert r["what"] == "paper" and r["error"] is None, r
    assert r["answer"] == ("equal" if r["ratio"] else "unchecked"), r
    ours[r["subject"]].add(r["operation"])
want = {"circulator", "barycentre", "normals", "smoothing", "subdivision", "collapse"}
assert ours == {"half-edge": want, "winged-edge": want, "indexed-csr": want}, ours
P
ok "claims keep the contract" python3 - "$out" <<'P'
import json, sys
claims = json.load(open(sys.argv[1] + "/bench.json"))["claims"]
assert len({c["name"] for c in claims}) >= 14 and len({c["mesh"] for c in claims}) >= 10
for c in claims:
    assert set(c) == {"name", "source", "claim", "mesh", "claimed", "measured", "holds"}
    assert c["claimed"] > 0 and c["measured"] > 0 and isinstance(c["holds"], bool)
P
ok "accesses of queries are printed" matches "$scratch/table" 'Half edge +k 4 4 '
ok "accesses keep the contract, in both files" python3 - "$out" <<'P'
import csv, json, sys
rows = json.load(open(sys.argv[1] + "/bench.json"))["accesses"]
assert len({r["subject"] for r in rows}) == 14 and len(rows) == 14 * 5
for r in rows:
    assert set(r) == {"subject", "title", "query", "claim", "growth", "holds", "by_size", "by_valence"}
    assert r["holds"] is True and r["growth"] in ("1", "lg s", "k", "k^2", "n"), r
    assert [a["valence"] for a in r["by_valence"]] == [4, 256]
    assert r["by_size"][1]["triangles"] > 3.5 * r["by_size"][0]["triangles"]
lines = list(csv.DictReader(open(sys.argv[1] + "/accesses.csv")))
assert len(lines) == 4 * len(rows)
assert float(lines[1]["accesses"]) == rows[0]["by_size"][1]["accesses"]
P
done_testing
