#!/bin/bash
# Golden pictures and the renderer's other promises, as TAP.
set -uo pipefail
cd "$(dirname "$0")/../.."
out=build/golden
font=/usr/share/fonts/truetype/open-sans/OpenSans-Regular.ttf

skip_all() { echo "1..0 # SKIP $1"; exit 0; }
[ -x build/meshgrade-render ] || skip_all "build/meshgrade-render was not built: VTK or OpenImageIO is missing"
[ -r "$font" ] || skip_all "the golden pictures need the package fonts-open-sans"

count=0
# check NAME COMMAND...: passes when the command does
check() {
    local name=$1
    shift
    count=$((count + 1))
    if "$@"; then echo "ok - $name"; else echo "not ok - $name"; fi
}

# job NAME JSON: runs a job written in the output folder; sets $code and $said
job() {
    echo "$2" >"$out/$1"
    said=$(build/meshgrade-render "$out/$1" 2>&1)
    code=$?
}

rm -rf "$out"
if ! tests/golden/make.sh "$out" >"$out.log" 2>&1; then
    sed 's/^/# /' "$out.log"
    grep -q 'no OpenGL' "$out.log" && skip_all "no OpenGL here"
    echo "not ok - the golden scenes are drawn"
    echo "1..1"
    exit 1
fi
lines=$("$out/compare" tests/golden "$out")
echo "$lines"
count=$(echo "$lines" | wc -l)

cp "$out/edges.png" "$out/first.png.kept"
build/meshgrade-render "$out/job.json"
check "drawing again gives the same bytes" cmp "$out/edges.png" "$out/first.png.kept"

# VTK once drew letters of another weight after it had opened many sizes of a font.
sizes=$(for height in $(seq 400 40 1100); do
    printf '{"scene": "figure-heatmap.json", "out": "size-%d.png", "width": 320, "height": %d},' "$height" "$height"
done)
job sizes.json "{\"pictures\": [{\"scene\": \"figure-bars.json\", \"out\": \"size-0.png\", \"width\": 480, \"height\": 360}, $sizes {\"scene\": \"figure-panels.json\", \"out\": \"last.png\", \"width\": 480, \"height\": 360}]}"
check "letters do not depend on what was drawn before" cmp "$out/last.png" "$out/figure-panels.png"
rm -f "$out"/size-*.png

job formats.json '{"pictures": [
  {"scene": "marks.json", "out": "f.exr", "width": 200, "height": 150},
  {"scene": "marks.json", "out": "f.tif", "width": 200, "height": 150},
  {"scene": "marks.json", "out": "f.jpg", "width": 200, "height": 150}],
  "sheets": [{"title": "t", "out": "formats.png", "columns": 3, "cells": [
  {"picture": "f.exr"}, {"picture": "f.tif"}, {"picture": "f.jpg"}]}]}'
check "EXR, TIFF and JPEG are written and read back" [ "$code" = 0 -a -s "$out/formats.png" ]
check "an EXR is one" [ "$(head -c 4 "$out/f.exr" | od -An -tx1 | tr -d ' ')" = 762f3101 ]
check "a JPEG is one" [ "$(head -c 2 "$out/f.jpg" | od -An -tx1 | tr -d ' ')" = ffd8 ]

job sheets.json '{"pictures": [], "sheets": [{"title": "t", "out": {"en": "sheet.png", "es": "sheet.es.png"}, "columns": 1, "cells": [
  {"picture": "absent.png", "caption": "c"}]}]}'
check "a frame without a picture has words" [ "$code" = 0 -a -s "$out/sheet.png" -a -s "$out/sheet.es.png" ]
check "in the language of the sheet" sh -c '! cmp -s "$1" "$2"' - "$out/sheet.png" "$out/sheet.es.png"

job some.json '{"pictures": [{"scene": "absent.json", "out": "absent.png"},
  {"scene": "triangle.json", "out": "present.png", "width": 96, "height": 72}]}'
check "a scene that is absent costs only its own picture" [ "$code" = 1 -a -s "$out/present.png" ]
check "and is said in one line" [ "$(echo "$said" | wc -l)" = 1 ]

job broken.json '{"pictures": ['
check "a job that is not JSON exits with 2" [ "$code" = 2 ]

said=$(__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null build/meshgrade-render "$out/job.json" 2>&1)
code=$?
check "without OpenGL the exit code is 2" [ "$code" = 2 ]
check "and one line says so" [ "$(echo "$said" | wc -l)" = 1 ]

HOME=/nonexistent XDG_CACHE_HOME= build/meshgrade-render "$out/some.json" >/dev/null 2>&1
check "a home that cannot be written is no obstacle" [ $? = 1 ]
echo "1..$count"
