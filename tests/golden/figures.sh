#!/bin/bash
# Writes the job that draws tests/golden/figures: figures.sh FOLDER
set -euo pipefail
out=$1
separator=
echo '{"pictures": [' >"$out/figures.json"
for scene in "$(dirname "$0")"/figures/*.json; do
    name=$(basename "$scene" .json)
    cp "$scene" "$out/figure-$name.json"
    echo "$separator{\"scene\": \"figure-$name.json\", \"out\": \"figure-$name.png\", \"width\": 480, \"height\": 360}" \
        >>"$out/figures.json"
    separator=,
done
echo ']}' >>"$out/figures.json"
