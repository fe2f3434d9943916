#!/bin/bash
# The grader grades itself: every known-verdict submission gets its verdict, one test an exercise;
# and it turns red when a judge is broken on purpose.
. "$(dirname "$0")/tap.sh"

# One exercise on each core, those with most submissions first. Of wrong answers only what decides their verdict is
# run; `make validate` runs the rest, too.
list=$(for folder in tests/submissions/*/*/; do echo "$(find "$folder" -type f | wc -l) $(basename "$folder")"; done | sort -rn | cut -d' ' -f2)
export meshgrade scratch
echo "$list" | xargs -P "$(nproc)" -I{} sh -c '"$meshgrade" validate {} --brief -j 1 >"$scratch/{}" 2>&1; echo $? >"$scratch/{}.code"'
ok "every exercise has known-verdict submissions" [ "$("$meshgrade" list | awk '{print $1}' | sort)" = "$(echo "$list" | sort)" ]
for exercise in $list; do
    ok "$exercise: $(tail -n 1 "$scratch/$exercise")" [ "$(cat "$scratch/$exercise.code")" -eq 0 ]
    [ "$(cat "$scratch/$exercise.code")" -eq 0 ] || sed 's/^/# /' "$scratch/$exercise"
done

# What was graded in brief is not remembered; what was graded whole and did not change is not graded again, what is
# asked for by name is, and what is unknown refused.
one=wrong/exchanged
rm -rf build/validated/euler-closed-mesh
"$meshgrade" validate euler-closed-mesh --brief --only "$one,right/by-faces" >"$scratch/brief" 2>&1
ok "--brief grades" [ "$(cat "$scratch/brief")" = '2 submissions as expected, 0 not' ]
"$meshgrade" validate euler-closed-mesh --only "$one,right/by-faces" >"$scratch/whole" 2>&1
ok "a wrong answer graded in brief is not remembered, a right one is" \
    [ "$(head -n 1 "$scratch/whole")" = '1 of 2 as before; --again grades all' ]
"$meshgrade" validate euler-closed-mesh --only "$one" >"$scratch/before" 2>&1
ok "what did not change is as before" matches "$scratch/before" '^1 of 1 as before; --again grades all$'
"$meshgrade" validate euler-closed-mesh --only "$one,right/by-faces.c" --again -v >"$scratch/again" 2>&1
ok "--again grades it" [ "$(grep -c '^as expected: ' "$scratch/again")" -eq 2 ]
"$meshgrade" validate euler-closed-mesh --only "$one,wrong/none" >"$scratch/none" 2>&1
ok "--only with an unknown name ends with 64" [ $? -eq 64 ]
ok "and says which, in one line" [ "$(cat "$scratch/none")" = "meshgrade: --only wrong/none: no such submission; name it as wrong/FILE.c" ]
"$meshgrade" validate euler-closed-mesh --compiler ../gcc >"$scratch/compiler" 2>&1
ok "--compiler takes a gcc of this machine only" [ $? -eq 64 ]
ok "and says which it does not find" matches "$scratch/compiler" '^meshgrade: --compiler: ../gcc: no such compiler; '
"$meshgrade" validate euler-closed-mesh --only "$one" --again --compiler "gcc-$(gcc -dumpversion)" >"$scratch/compiler" 2>&1
ok "a gcc can be named" [ "$(cat "$scratch/compiler")" = '1 submission as expected, 0 not' ]
ok "--only needs the exercise" exits_with 64 "$meshgrade" validate --only "$one" 2>/dev/null

# A set of submissions that cannot tell judges apart is not as expected. The tree is this one, but for the submissions;
# what was graded above is as before.
tree=$scratch/tree
mkdir -p "$tree/tests"
ln -s "$root"/{exercises,graders,reference,build} "$tree"
cp -r tests/submissions "$tree/tests/submissions"
rm "$(grep -l 'fails: isolated-vertices\b' "$tree"/tests/submissions/edges/edge-table-closed/wrong/*)" "$tree"/tests/submissions/edges/edge-table-closed/{slow/*,right/{growing-table,hash-table,neighbour-lists}.c}
MESHGRADE_ROOT=$tree "$meshgrade" validate edge-table-closed >"$scratch/set" 2>&1
ok "a set that lacks something is red" [ $? -eq 1 ]
where='^not as expected: tests/submissions/edges/edge-table-closed: '
ok "without a submission that fails just a class" matches "$scratch/set" "${where}no submission fails just class isolated-vertices; write one in wrong/$"
ok "without a slow one where growth is judged" matches "$scratch/set" "${where}growth is judged and nothing is slow; write one in slow/$"
ok "with fewer than three right ones" matches "$scratch/set" "${where}2 right answers; write 3 by different methods in right/$"

# A copy of the program whose judge of euler-closed-mesh accepts everything.
broken=$scratch/broken
mkdir -p "$broken"
judge=graders/judges/topology/euler-closed-mesh.c
sed 's/judge_reject(/if (0) judge_reject(/' "$judge" >"$broken/judge.c"
sed -i 's/\.judge = \([a-z_]*\)/.judge = accept_everything/' "$broken/judge.c"
sed -i 's/^const struct judge judge_/static int accept_everything(const struct task *t, struct judgement *o, struct error *e)\n{\n    (void)t; (void)e;\n    judge_accept(o);\n    return 0;\n}\n&/' "$broken/judge.c"
objects=$(for source in graders/commands/*.c; do echo "$BUILD/${source%.c}.o"; done)
if cc -w -std=c17 -D_GNU_SOURCE -I. -O1 "$broken/judge.c" "$BUILD/graders/meshgrade.o" $objects "$BUILD/libmeshgrade.a" \
    -o "$broken/meshgrade" $(pkg-config --libs jansson sqlite3 libarchive libseccomp nettle) -lm -Wl,--allow-multiple-definition 2>"$scratch/cc"; then
    MESHGRADE_ROOT=$root "$broken/meshgrade" validate euler-closed-mesh --only "$one" >"$scratch/red" 2>&1
    ok "validate is red when a judge accepts everything" [ $? -eq 1 ]
    ok "and names what is not as expected" matches "$scratch/red" '^not as expected: euler-closed-mesh wrong/'
else
    sed 's/^/# /' "$scratch/cc"
    ok "the broken judge builds" false
fi
done_testing
