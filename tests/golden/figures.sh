#!/bin/bash
# Writes the job that draws tests/golden/figures, and the charts and lessons of the benchmark's page for
# the results kept in tests/golden/bench, at half their size: figures.sh FOLDER
set -euo pipefail
out=$1
golden=$(dirname "$0")
separator=
add() { # scene, picture, width, height
    echo "$separator{\"scene\": \"$1\", \"out\": \"$2\", \"width\": $3, \"height\": $4}" >>"$out/figures.json"
    separator=,
}

echo '{"pictures": [' >"$out/figures.json"
for scene in "$golden"/figures/*.json; do
    name=$(basename "$scene" .json)
    cp "$scene" "$out/figure-$name.json"
    add "figure-$name.json" "figure-$name.png" 480 360
done

# Only the scenes: in a tree without the renderer none is drawn at full size.
mkdir -p "$out/bench" "$out/tree"
cp "$golden/bench/bench.json" "$out/bench"
ln -sfn "$PWD/exercises" "$PWD/graders" "$out/tree"
MESHGRADE_ROOT=$PWD/$out/tree build/meshgrade bench --page "$out/bench" 2>/dev/null
while read -r name width height; do
    add "bench/pictures/$name.json" "bench-$name.png" "$width" "$height"
done <<'SIZES'
bytes 600 410
costs 800 520
heat 720 430
strips 720 320
voxels 600 390
doubling 720 480
limit 600 490
peers 600 550
half-edges 600 450
winged-edge 600 450
model-strips 600 450
sphere 720 380
SIZES
echo ']}' >>"$out/figures.json"
