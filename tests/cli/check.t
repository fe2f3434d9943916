#!/bin/bash
# meshgrade check, list, start: what a student sees.
. "$(dirname "$0")/tap.sh"
edges=$submissions/edges/edge-table-any

"$meshgrade" list >"$scratch/list"
ok "list names every exercise" \
    [ "$(cut -d' ' -f1 "$scratch/list" | sort)" = "$(ls -d exercises/*/*/ | xargs -n 1 basename | grep -v licences | sort)" ]
"$meshgrade" list --lang es >"$scratch/list-es"
ok "list has Spanish titles" matches "$scratch/list-es" '^edge-table-any .* puntos  Tabla de aristas'
LC_ALL=es_ES.UTF-8 "$meshgrade" list >"$scratch/list-here"
ok "in the language of the environment" cmp -s "$scratch/list-es" "$scratch/list-here"
"$meshgrade" list --json >"$scratch/list.json"
ok "list --json is JSON" python3 -c 'import json,sys; assert "edge-table-any" in [e["name"] for e in json.load(open(sys.argv[1]))]' "$scratch/list.json"

"$meshgrade" check edge-table-any "$edges/wrong/boundary-lost.c" >"$scratch/wrong"
code=$?
head -n 3 "$scratch/wrong" >"$scratch/head"
ok "a wrong edge table ends with exit code 1" [ "$code" -eq 1 ]
ok "line 1 says what is wrong" matches "$scratch/head" 'edge \{[0-9]+,[0-9]+\} .*is missing'
ok "line 2 says where" matches "$scratch/head" '^  where .*edge \{[0-9]+,[0-9]+\}.*case [a-z-]+'
ok "line 3 says how to repeat it" matches "$scratch/head" "^  again .*meshgrade check edge-table-any .*boundary-lost.c --case [a-z-]+"
ok "without a terminal there is no colour" sh -c '! grep -q "$(printf "\033")" "$1"' - "$scratch/wrong"

again=$(sed -n 's/^  again  *meshgrade //p' "$scratch/head")
eval "\"$meshgrade\" $again" >"$scratch/again"
ok "the command of line 3 shows the same mistake" [ "$(head -n 1 "$scratch/again")" = "$(head -n 1 "$scratch/head")" ]

"$meshgrade" check edge-table-any --lang es "$edges/wrong/boundary-lost.c" >"$scratch/es"
ok "it speaks Spanish" matches "$scratch/es" 'falta la arista'

"$meshgrade" check edge-table-any "$edges/right/sort.c" --quick >"$scratch/right"
ok "a right answer ends with exit code 0" [ $? -eq 0 ]
"$meshgrade" check edge-table-any "$edges/right/sort.c" --quick >"$scratch/public"
ok "and it says that grading has further cases" matches "$scratch/public" '^Grading has [0-9]+ further cases?, not public'
"$meshgrade" check edge-table-any --lang es --quick "$edges/right/sort.c" >"$scratch/public-es"
ok "in Spanish too" matches "$scratch/public-es" '^Al corregir hay además [0-9]+ casos? sin publicar'
cat >"$scratch/endless.c" <<'C'
#include "edge-table-any.h"
int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count, int32_t **edges)
{
    (void)triangles, (void)vertex_count, (void)edges;
    for (volatile int32_t i = 0;; i = triangle_count) {
    }
}
C
"$meshgrade" check edge-table-any "$scratch/endless.c" --case tetrahedron >"$scratch/endless"
ok "a limit of CPU time is told as its rule" matches "$scratch/endless" 'more than 60 times the CPU time of the reference'
"$meshgrade" check edge-table-any --json "$edges/right/hash-table.c" >"$scratch/right.json"
ok "the result of a right answer is whole" python3 - "$scratch/right.json" <<'P'
import json, sys
r = json.load(open(sys.argv[1]))
keys = "student exercise verdict cause score max_score cases measures protections".split()
assert all(k in r for k in keys), r.keys()
assert r["verdict"] == "passed" and r["score"] == r["max_score"]
assert all(c["verdict"] == "passed" for c in r["cases"])
assert r["measures"]["growth"]["families"][0]["fit"]["class"] in ("n", "n lg n", "1")
assert "seccomp" in r["protections"]["active"]
P

echo 'int64_t edge_table_any(' >"$scratch/broken.c"
"$meshgrade" check edge-table-any "$scratch/broken.c" --quick >"$scratch/broken"
ok "what does not compile ends with 1" [ $? -eq 1 ]
"$meshgrade" check edge-table-any "$scratch/broken.c" --quick >"$scratch/broken"
ok "and shows the compiler's message" matches "$scratch/broken" 'broken\.c:1'
echo '#include "edge-table-any.h"' >"$scratch/empty.c"
"$meshgrade" check edge-table-any "$scratch/empty.c" --quick >"$scratch/empty"
ok "a missing function is named" matches "$scratch/empty" 'edge_table_any'

ok "an unknown exercise is wrong usage" exits_with 64 "$meshgrade" check no-such-thing "$scratch/empty.c" 2>/dev/null
ok "a missing file is wrong usage" exits_with 64 "$meshgrade" check edge-table-any "$scratch/absent.c" 2>"$scratch/absent"
ok "and is named" matches "$scratch/absent" 'absent.c'
ok "an unknown command is wrong usage" exits_with 64 "$meshgrade" frobnicate 2>/dev/null
ok "an unknown option is wrong usage" exits_with 64 "$meshgrade" check --frobnicate 2>/dev/null
for command in list start check grade report export validate doctor; do
    ok "$command --help" sh -c '"$1" "$2" --help | grep -q "^usage: meshgrade $2"' - "$meshgrade" "$command"
done

case_seed() { # case, options...
    case=$1
    shift
    "$meshgrade" check edge-table-any "$submissions/edges/edge-table-any/right/hash-table.c" --case "$case" --json "$@" |
        python3 -c 'import json, sys; case = json.load(sys.stdin)["cases"][0]; print(case["verdict"], case["seed"], "--seed" in case["reproduce"])'
}
ok "a class's seed does not touch public cases" [ "$(case_seed cube-flipped --seed 12)" = "$(case_seed cube-flipped)" ]
hidden=$(case_seed cube --seed 12)
ok "but draws the others anew" sh -c '[ "$1" != "$2" ] && [ "$1" != "$3" ]' - "$hidden" "$(case_seed cube)" "$(case_seed cube --seed 13)"
ok "the same for the same seed, and says how to see them again" sh -c '[ "$1" = "$2" ] && case $1 in "passed "*" True") ;; *) false ;; esac' - "$hidden" "$(case_seed cube --seed 12)"
ok "a seed that is no number is wrong usage" exits_with 64 "$meshgrade" check edge-table-any "$scratch/empty.c" --seed x 2>/dev/null

cd "$scratch" || exit 1
"$meshgrade" start edge-table-any work >/dev/null
ok "start gives statement, header and starter" [ -s work/edge-table-any.md -a -s work/edge-table-any.es.md -a -s work/edge-table-any.h -a -s work/edge-table-any.c ]
"$meshgrade" check edge-table-any work/edge-table-any.c --quick >/dev/null
ok "the starter compiles and is a wrong answer" [ $? -eq 1 ]
echo mine >work/edge-table-any.c
"$meshgrade" start mesh-area work >/dev/null
ok "a second exercise in the folder has its own statement" cmp -s work/mesh-area.md "$root/exercises/processing/mesh-area/README.md"
"$meshgrade" start edge-table-any work >/dev/null 2>&1
ok "start never overwrites a student's work" [ "$(cat work/edge-table-any.c)" = mine ]
done_testing
