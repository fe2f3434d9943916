#!/bin/bash
# Builds the golden tools and draws the golden scenes: tests/golden/make.sh FOLDER
set -euo pipefail
cd "$(dirname "$0")/../.."
out=$1
mkdir -p "$out"
${CC:-cc} -std=c17 -D_GNU_SOURCE -I. -O1 -Wall -Wextra tests/golden/*.c graders/scene/*.c \
    reference/mesh/mesh.c reference/base/{error,phrase}.c $(pkg-config --cflags --libs jansson) -lm -o "$out/scenes"
${CXX:-c++} -std=c++17 -O1 -Wall -Wextra tests/golden/compare.cpp \
    $(pkg-config --cflags --libs OpenImageIO) -o "$out/compare"
"$out/scenes" "$out"
build/meshgrade-render "$out/job.json"
tests/golden/figures.sh "$out"
build/meshgrade-render "$out/figures.json"
# What `meshgrade mesh` draws; 1: the mesh has faults.
build/meshgrade mesh --picture "$out/mesh-faults.png" tests/golden/meshes/faults.off >/dev/null || [ $? -eq 1 ]
