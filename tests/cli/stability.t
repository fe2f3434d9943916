#!/bin/bash
# The program behind `make stability`: it must see when there is nothing to compare.
. "$(dirname "$0")/tap.sh"
mkdir -p "$scratch/empty/ana" "$scratch/short/ana"
echo 'a note' >"$scratch/empty/ana/notes.txt"
tests/stability.sh 2 "$scratch/empty" >"$scratch/log" 2>&1
ok "runs without any result are not stable" [ $? -ne 0 ]
ok "which is said" matches "$scratch/log" '2 incomplete runs'
echo 'no C' >"$scratch/short/ana/edge-table-closed.c"
tests/stability.sh 2 "$scratch/short" >"$scratch/log" 2>&1
ok "two runs with the same results are" [ $? -eq 0 ]
ok "which is counted" matches "$scratch/log" '^2 runs: 0 differing marks, 0 differing counts, 0 incomplete runs$'
done_testing
