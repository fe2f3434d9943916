#!/bin/bash
# Records the golden pictures anew, after the renderer was changed on purpose. Look at each one before
# you commit it.
set -euo pipefail
cd "$(dirname "$0")/../.."
out=build/golden
rm -rf "$out"
tests/golden/make.sh "$out"
cp "$out"/*.png tests/golden/
ls -l tests/golden/*.png
