#!/bin/bash
# The grader grades itself: every known-verdict submission gets its verdict, one test an exercise;
# and it turns red when a judge is broken on purpose.
. "$(dirname "$0")/tap.sh"
for exercise in $("$meshgrade" list | awk '{print $1}'); do
    "$meshgrade" validate "$exercise" >"$scratch/$exercise" 2>&1
    code=$?
    ok "$exercise: $(tail -n 1 "$scratch/$exercise")" [ "$code" -eq 0 ]
    [ "$code" -eq 0 ] || sed 's/^/# /' "$scratch/$exercise"
done

# A copy of the program whose judge of euler-closed-mesh accepts everything.
broken=$scratch/broken
mkdir -p "$broken"
judge=graders/judges/topology/euler-closed-mesh.c
sed 's/judge_reject(/if (0) judge_reject(/' "$judge" >"$broken/judge.c"
sed -i 's/\.judge = \([a-z_]*\)/.judge = accept_everything/' "$broken/judge.c"
sed -i 's/^const struct judge judge_/static int accept_everything(const struct task *t, struct judgement *o, struct error *e)\n{\n    (void)t; (void)e;\n    judge_accept(o);\n    return 0;\n}\n&/' "$broken/judge.c"
objects=$(find "$BUILD/graders/commands" -name '*.o')
if cc -w -std=c17 -D_GNU_SOURCE -I. -O1 "$broken/judge.c" "$BUILD/graders/meshgrade.o" $objects "$BUILD/libmeshgrade.a" \
    -o "$broken/meshgrade" $(pkg-config --libs jansson sqlite3 libarchive libseccomp nettle) -lm -Wl,--allow-multiple-definition 2>"$scratch/cc"; then
    MESHGRADE_ROOT=$root "$broken/meshgrade" validate euler-closed-mesh >"$scratch/red" 2>&1
    ok "validate is red when a judge accepts everything" [ $? -eq 1 ]
    ok "and names what is not as expected" matches "$scratch/red" '^not as expected: euler-closed-mesh wrong/'
else
    sed 's/^/# /' "$scratch/cc"
    ok "the broken judge builds" false
fi
done_testing
