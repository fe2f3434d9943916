#!/bin/bash
# Arranges known submissions as a class would hand them in: folders, a .zip, a .tar.gz and a Moodle
# bulk download.
#
#   tests/demo-class.sh FOLDER [EXERCISE...]
#
# Twelve students answer the exercises, without names every one; who hands in what follows from fixed lists, so the class is
# the same every time.
set -eu
to=$1
shift
from=$(mktemp -d)
trap 'rm -rf "$from"' EXIT
meshgrade=$(dirname "$0")/../build/meshgrade
[ $# -gt 0 ] || set -- $("$meshgrade" list | awk '{print $1}')
for exercise; do "$meshgrade" validate "$exercise" --expand "$from"; done
rm -rf "$to"
mkdir -p "$to/folders" "$to/zip" "$to/tar" "$to/moodle"
to=$(cd "$to" && pwd)

# Of an exercise's submissions of some kinds, the n-th (from 0, around).
pick() { # exercise folder, n, kinds...
    local folder=$1 n=$2 files=()
    shift 2
    for kind in "$@"; do
        for file in "$folder/$kind"/*.c; do [ -e "$file" ] && files+=("$file"); done
    done
    [ ${#files[@]} -gt 0 ] || files=("$folder"/right/*.c)
    echo "${files[n % ${#files[@]}]}"
}

# One student: where to, habits (a kind for each exercise in turn, repeated), number.
hand_in() { # folder, n, kinds...
    local folder=$1 n=$2 index=0 kinds
    shift 2
    kinds=("$@")
    mkdir -p "$folder"
    for exercise in "$from"/*/*/; do
        kind=${kinds[index % ${#kinds[@]}]}
        cp "$(pick "${exercise%/}" "$n" $kind)" "$folder/$(basename "$exercise").c"
        index=$((index + 1))
    done
}

hand_in "$to/folders/Ana García" 0 right
hand_in "$to/folders/Bruno Ferrari" 1 right right wrong
hand_in "$to/folders/Carla Puig" 2 right wrong
hand_in "$to/folders/David O'Neill" 0 wrong
hand_in "$to/folders/Elena Muñoz" 1 slow right greedy right
hand_in "$to/zip/Giulia Rossi" 3 wrong right leak
hand_in "$to/zip/Hugo Martín" 0 crash wrong right
hand_in "$to/tar/Inés Vidal" 2 right
hand_in "$to/tar/Jordi Serra" 5 wrong
hand_in "$to/moodle/Karim Ben Salah_20311_assignsubmission_file_" 4 right wrong slow
hand_in "$to/moodle/Laura Gómez_20312_assignsubmission_file_" 1 leak wrong right
hand_in "$to/moodle/Mallory Smith_20313_assignsubmission_file_" 0 hostile

(cd "$to/zip" && zip -qr ../group-b.zip .)
tar -czf "$to/group-c.tar.gz" -C "$to/tar" .
(cd "$to/moodle" && zip -qr "../CG1-Meshes-20311.zip" .)
rm -r "$to/zip" "$to/tar" "$to/moodle"
