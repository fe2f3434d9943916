#!/bin/bash
# The grader graded, a handful: one mutant of every right answer through the cases of its judge, and the tool
# itself. make mutants takes many of each, and all the checks.
. "$(dirname "$0")/tap.sh"
judge=$BUILD/tests/mutants/judge_mutants
export PYTHONDONTWRITEBYTECODE=1

python3 - >"$scratch/kinds" 2>&1 <<'P'
import sys
sys.path.insert(0, "tests/mutants")
from mutate import mutants_of

source = """/* a + b */
#include "x.h"
int f(int n, int *a)
{
    int s = 0;
    for (int i = 0; i < n; i++)
        if (a[i] > 1 && n)
            s += g(a[i], n); // < not this
    puts("1 < 2");
    return s;
}
"""
found = {(m.operator, source[m.start : m.end], m.text) for m in mutants_of(source)}
for expected in [
    ("condition", "<", "<="), ("condition", "<", ">="), ("condition", "&&", "||"), ("condition", "a[i] > 1 && n", "!(a[i] > 1 && n)"),
    ("operator", "++", "--"), ("operator", "+=", "-="), ("constant", "1", "2"), ("constant", "1", "0"),
    ("off-by-one", "i", "(i) + 1"), ("statement", "s += g(a[i], n);", ";"), ("arguments", "a[i], n", "n, a[i]"),
]:
    assert expected in found, expected
for mutant in mutants_of(source):
    changed = mutant.apply(source)
    assert "/* a + b */" in changed and "// < not this" in changed and "return s" in changed, mutant.lines(source)
    assert '"1 < 2"' in changed or mutant.text == ";", mutant.lines(source)
P
ok "the tool makes each kind of mutant, and none in comments, texts and the last return" [ $? -eq 0 ]
sed 's/^/# /' "$scratch/kinds"

python3 - "$scratch" >"$scratch/survivor" 2>&1 <<'P'
import importlib.machinery, importlib.util, pathlib, sys, types
loader = importlib.machinery.SourceFileLoader("mutants_run", "tests/mutants/run")
run = importlib.util.module_from_spec(importlib.util.spec_from_loader("mutants_run", loader))
loader.exec_module(run)
case = lambda verdict, i: types.SimpleNamespace(exercise="e", original="o.c", before="b%d" % i, after="a", verdict=verdict)
caught, survivor = [case("wrong-answer", i) for i in range(999)], case("passed", 999)
out = pathlib.Path(sys.argv[1])
assert run.report(caught, {}, {}, out), "all caught"
assert not run.report(caught + [survivor], {}, {}, out), "99.9 % and a survivor that nobody explained"
assert run.report(caught + [survivor], {("o.c", "b999", "a"): "the same"}, {}, out), "explained"
P
ok "a survivor that nobody explained fails the run, whatever the score" [ $? -eq 0 ]
grep -A9 Traceback "$scratch/survivor" | sed 's/^/# /'

if [ -x "$judge" ]; then
    tests/mutants/run --program "$judge" --quick --handful --out "$scratch/mutants" >"$scratch/table"
    code=$?
    ok "one mutant of each right answer is caught" [ "$code" -eq 0 ]
    [ "$code" -eq 0 ] || sed 's/^/# /' "$scratch/table"
    awk '/^[^ ]+:[0-9]+ / {sub(/:[0-9]+$/, "", $1); file = $1} /^  - / && file {b = $0; getline a; print file ": said to be equivalent\n" b "\n" a; exit}' \
        "$scratch/mutants/mutants.txt" >"$scratch/lie"
    exercise=$(head -n 1 "$scratch/lie" | sed 's/\.c:.*//; s/.*\///')
    tests/mutants/run --program "$judge" --quick --exercise "$exercise" --only "$scratch/lie" --out "$scratch/again" --survivors "$scratch/lie" >"$scratch/table"
    ok "an explanation of a mutant that is caught turns it red" sh -c '[ "$1" -eq 1 ] && grep -q "but caught" "$2"' - $? "$scratch/table"
else
    skip "one mutant of each right answer is caught" "judge_mutants was not built"
fi
done_testing
