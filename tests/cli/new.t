#!/bin/bash
# An exercise made by `new` in a copy of the tree: a few lines filled in, then listed, checked, validated
# and reported in both languages, without an edit anywhere else.
. "$(dirname "$0")/tap.sh"

tree=$scratch/tree
mkdir -p "$tree/build"
git ls-files -c -o --exclude-standard | grep -v '^tests/\(golden\|hostile\|fuzz\)/' | tar cf - -T - | tar xf - -C "$tree"
cp -a "$BUILD" build/runner "$tree/build/"
cp -a build/meshgrade build/meshgrade-render "$tree/build/"
find "$tree/build/$(basename "$BUILD")" -name 'test-logs' -exec rm -rf {} +
cd "$tree" || exit 1
unset MESHGRADE_ROOT
ours=$tree/build/meshgrade
inventory() { find . -path ./build -prune -o -type f -print0 | sort -z | xargs -0 sha256sum | sort; }
inventory >"$scratch/before"

"$ours" new parts/edge-pairs --like edge-table-closed >"$scratch/new"
ok "new writes an exercise" [ $? -eq 0 ]
ok "and says what is to be done next" matches "$scratch/new" 'validate edge-pairs'
inventory >"$scratch/after"
ok "no file that was there has changed" [ -z "$(comm -23 "$scratch/before" "$scratch/after")" ]
ok "every file that is new bears its name" \
    [ -z "$(comm -13 "$scratch/before" "$scratch/after" | grep -v 'edge-pairs')" ]
ok "the old name is nowhere in it" \
    [ -z "$(grep -rlE 'edge[-_]table[-_]closed' exercises/parts graders/judges/parts graders/runner/parts reference/answers/parts tests/submissions/parts)" ]

# A few lines: its title, a case more, a mistake more.
sed -i 's/"Edge pairs"/"Pairs of an edge"/; 0,/"es": "Pairs of an edge"/s//"es": "Parejas de una arista"/' exercises/parts/edge-pairs/exercise.json
sed -i 's/^    CASES_EMPTY(51),/    CASES_EMPTY(51),\n    {"octahedron", "closed", 61, PUBLIC | QUICK, .mesh = {SHAPE_BIPYRAMID, .count = 4}},/' \
    graders/judges/parts/edge-pairs.c
cat >tests/submissions/parts/edge-pairs/wrong/says-none.c <<'END'
/* Finds no edge at all. */
#include "edge-pairs.h"

#include <stddef.h>

int64_t edge_pairs(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count, int32_t **edges)
{
    (void)triangles;
    (void)triangle_count;
    (void)vertex_count;
    *edges = NULL;
    return 0;
}
END
make build/meshgrade config="$(basename "$BUILD")" >"$scratch/make" 2>&1
ok "the tree builds" [ $? -eq 0 ] || sed 's/^/# /' "$scratch/make"

"$ours" list >"$scratch/list"
ok "it is listed with its title" matches "$scratch/list" '^edge-pairs .*Pairs of an edge'
"$ours" validate edge-pairs --only right/two-passes,wrong/says-none,wrong/one-based >"$scratch/validate" 2>&1
ok "its submissions are validated" [ $? -eq 0 ] || sed 's/^/# /' "$scratch/validate"

mkdir work
cp tests/submissions/parts/edge-pairs/wrong/says-none.c work/edge-pairs.c
NO_COLOR=1 "$ours" check edge-pairs --quick work/edge-pairs.c >"$scratch/en" 2>&1
NO_COLOR=1 "$ours" check edge-pairs --quick --lang es work/edge-pairs.c >"$scratch/es" 2>&1
ok "check tells the mistake" matches "$scratch/en" 'is missing'
ok "and in Spanish" matches "$scratch/es" 'falta la arista'
ok "the case that was added runs" matches "$scratch/en" 'octahedron: '

mkdir -p class/ana
cp work/edge-pairs.c class/ana/
"$ours" grade class -o marks --exercise edge-pairs >"$scratch/grade" 2>&1
ok "a class is graded on it" [ $? -eq 1 ]
page=$(cat marks/students/*.html 2>/dev/null)
ok "its page has the title in both languages" \
    [ -n "$(grep -o 'Pairs of an edge' <<<"$page")" -a -n "$(grep -o 'Parejas de una arista' <<<"$page")" ]
ok "and the cause in both" \
    [ -n "$(grep -o 'missing edge' <<<"$page")" -a -n "$(grep -o 'falta una arista' <<<"$page")" ]

# What cannot be made is refused in one line, and nothing is written.
for wrong in edge-pairs parts/Edge parts/edge-pairs parts/ /x parts/a/b; do
    "$ours" new "$wrong" >"$scratch/refused" 2>&1
    ok "new $wrong is refused" [ $? -eq 64 -a "$(wc -l <"$scratch/refused")" -eq 1 ]
done
"$ours" new parts/other --like no-such-exercise >"$scratch/refused" 2>&1
ok "an unknown model is refused" [ $? -eq 64 ]
done_testing
