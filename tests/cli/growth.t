#!/bin/bash
# The growth decision on solutions of known growth; `make growth` runs them all.
. "$(dirname "$0")/tap.sh"
if ! command -v valgrind >/dev/null; then
    echo "1..0 # SKIP nothing can be counted without valgrind"
    exit 0
fi
"$BUILD/tests/growth/known" mesh-area 1 >"$scratch/table" 2>"$scratch/err"
code=$?
ok "eight growths of one area algorithm are decided right" [ "$code" -eq 0 ]
[ "$code" -eq 0 ] || sed 's/^/# /' "$scratch/table" "$scratch/err"
ok "all of them were tried" matches "$scratch/table" '^8 solutions: 6 of 6 decided right'
ok "variations of the counts were tried" matches "$scratch/table" ': 0 of 1000 variations'
done_testing
