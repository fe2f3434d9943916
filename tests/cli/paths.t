#!/bin/bash
# A path is a path: folders whose names a shell, glob() or printf would take for patterns.
. "$(dirname "$0")/tap.sh"
euler=$submissions/topology/euler-closed-mesh
mkdir -p "$scratch/class/ana" "$scratch/class/bruno"
cp "$euler/right/by-faces.c" "$scratch/class/ana/euler-closed-mesh.c"
cp "$euler/wrong/accepts-odd-faces.c" "$scratch/class/bruno/euler-closed-mesh.c"
cd "$scratch" || exit 1

# -- the folder of results
"$meshgrade" grade class -o marks1 --seed 7 --no-pictures >plain 2>talk
cp -r marks1/results before
names() { (cd "$1" && find . -type f | sort); }
for out in 'marks[12]' 'marks [2026]' 'ma%prks*?' "it's, {a,b} \\ \$HOME"; do
    "$meshgrade" grade class -o "$out" --seed 7 --no-pictures >marks 2>talk
    ok "grading into '$out' tells that not all passed" [ $? -eq 1 ]
    ok "the class has its marks" cmp plain marks
    ok "and just its results" [ "$(names "$out/results")" = "$(names before)" ]
    ok "'marks1' beside it is as it was" diff -r before marks1/results
done
rm -rf class/bruno
"$meshgrade" grade class -o 'marks[12]' --seed 7 --no-pictures >marks 2>talk
ok "a result of a row that is gone is removed from a folder with brackets" [ ! -e 'marks[12]/results/bruno/euler-closed-mesh.json' ]
"$meshgrade" report 'marks [2026]' --json >report.json 2>talk
ok "report tells that not all of it passed" [ $? -eq 1 ]
ok "and has both results" python3 -c 'import json, sys; assert len(json.load(open(sys.argv[1]))) == 2' report.json

# -- the tree itself
tree="it's tree[1]"
mkdir "$tree" && cd "$tree" || exit 1
mkdir build
cp -rL "$root/build/runner" build/runner
cp -L "$meshgrade" build/meshgrade
[ ! -x "$root/build/meshgrade-render" ] || cp -L "$root/build/meshgrade-render" build/meshgrade-render
cp -r "$root/exercises" "$root/reference" "$root/graders" .
cd "$scratch" || exit 1
"$tree/build/meshgrade" list >list
ok "a clone in \"$tree\" has its exercises" [ $? -eq 0 -a "$(cat list)" = "$("$meshgrade" list)" ]
"$tree/build/meshgrade" check euler-closed-mesh --quick "$euler/right/by-faces.c" >check
ok "and checks an answer" [ $? -eq 0 ]
"$tree/build/meshgrade" doctor --json >doctor.json 2>talk
"$meshgrade" doctor --json >doctor-here.json 2>talk
ok "doctor finds there what it finds here" cmp doctor.json doctor-here.json
done_testing
