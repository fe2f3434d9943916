#!/bin/bash
# A part of the hostile suite in every test run; `make hostile` runs it whole.
. "$(dirname "$0")/tap.sh"
tests/hostile/run --list >"$scratch/rows"
ok "there are more than 200 rows" [ "$(wc -l <"$scratch/rows")" -gt 200 ]
ok "each of them stands in tests/hostile/README.md as it is in the tree" sh -c '
    missing=$(while IFS= read -r row; do grep -qF -- "$row" "$2" || echo "# $row"; done <"$1")
    [ -z "$missing" ] || { echo "$missing"; exit 1; }' - "$scratch/rows" tests/hostile/README.md
ok "README.md has no row that is not in the tree" [ "$(grep -cE '^\| [a-z]+/[0-9]' tests/hostile/README.md)" -eq "$(wc -l <"$scratch/rows")" ]
tests/hostile/run --part 8 >"$scratch/part" 2>&1 --as "$([ "$(id -u)" -eq 0 ] && echo root || echo user)"
code=$?
ok "every eighth row gets exactly its verdict and leaves nothing behind" [ "$code" -eq 0 ]
[ "$code" -eq 0 ] || sed 's/^/# /' "$scratch/part"
ok "a protection of an unknown name is refused" exits_with 64 "$meshgrade" check edge-table-any --without nothing "$submissions/edges/edge-table-any/right/sort.c" 2>/dev/null
done_testing
