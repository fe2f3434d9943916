#!/bin/bash
# What goes wrong on the machine is a fault or a refusal that says what to do; never a mark: a full disk, a missing
# part of the compiler, calls that fail, clocks that jump, what cannot be read, a damaged store.
. "$(dirname "$0")/tap.sh"
answer=$submissions/topology/euler-closed-mesh/right/by-faces.c
wrong=$submissions/topology/euler-closed-mesh/wrong/accepts-odd-faces.c
check() { "$meshgrade" check euler-closed-mesh --quick --json "$@"; }

# Exit code 2 and a line on the standard error, or a result that is a fault and has no score.
is_fault() { # exit code, standard output, standard error
    [ "$1" -eq 2 ] || { echo "# exit code $1, expected 2"; head -c 400 "$2" | sed 's/^/# /'; return 1; }
    grep -q '^meshgrade: .' "$3" || { python3 -c '
import json, sys
r = json.load(open(sys.argv[1]))
assert r["verdict"] == "fault" and r["score"] is None' "$2"; }
}

# -- every kind of call fails
if [ -f "$BUILD/tests/faults/inject.so" ]; then
    tests/faults/sweep "$BUILD/tests/faults/inject.so" --points 1 --submission right/by-faces.c >"$scratch/sweep"
    code=$?
    ok "one call of each kind fails: $(tail -n 1 "$scratch/sweep")" [ $code -eq 0 ]
    sed -n '$!s/^/# /p' "$scratch/sweep"
    tests/faults/sweep "$BUILD/tests/faults/inject.so" --grade --points 1 --calls malloc,write,rename,fsync,fork >"$scratch/sweep"
    code=$?
    ok "and while a class is graded, where nothing is lost: $(tail -n 1 "$scratch/sweep")" [ $code -eq 0 ]
    sed -n '$!s/^/# /p' "$scratch/sweep"
else
    skip "one call of each kind fails" "inject.so was not built"
    skip "and while a class is graded, where nothing is lost" "inject.so was not built"
fi

# -- what a whole exercise needs
mkdir -p "$scratch/two/ana" "$scratch/two/bruno"
cp "$answer" "$scratch/two/ana/euler-closed-mesh.c"
cp "$answer" "$scratch/two/bruno/euler-closed-mesh.c"
cp "$submissions/edges/edge-table-closed/right/two-passes.c" "$scratch/two/ana/edge-table-closed.c"
if [ -f "$BUILD/tests/faults/inject.so" ]; then
    LD_PRELOAD=$BUILD/tests/faults/inject.so INJECT=memfd:1 "$meshgrade" grade "$scratch/two" -o "$scratch/once" --seed 1 --no-pictures >"$scratch/out" 2>"$scratch/err"
    ok "a yardstick that fails once is made again" [ $? -eq 0 ]
else
    skip "a yardstick that fails once is made again" "inject.so was not built"
fi
mkdir -p "$scratch/tree/build"
cp -r exercises graders reference "$scratch/tree"
cp -rL build/runner "$scratch/tree/build/runner"
cp -L "$meshgrade" "$scratch/tree/build/meshgrade"
echo 'no C' >"$scratch/tree/reference/answers/topology/euler-closed-mesh.c"
"$scratch/tree/build/meshgrade" grade "$scratch/two" -o "$scratch/never" --seed 1 --no-pictures >"$scratch/out" 2>"$scratch/err"
ok "one that cannot be made is a fault" [ $? -eq 2 ]
ok "of each answer to its exercise, without a mark, and of no other answer" python3 -c '
import json, sys
def result(student, exercise):
    return json.load(open(f"{sys.argv[1]}/results/{student}/{exercise}.json"))
for student in "ana", "bruno":
    r = result(student, "euler-closed-mesh")
    assert r["verdict"] == "fault" and r["score"] is None, (student, r["verdict"], r["score"])
    assert "euler-closed-mesh" in r["summary"]["en"], r["summary"]
r = result("ana", "edge-table-closed")
assert r["verdict"] == "passed", r["verdict"]' "$scratch/never"
"$meshgrade" grade "$scratch/two" -o "$scratch/never" --seed 1 --no-pictures >"$scratch/out" 2>"$scratch/err"
ok "which the next run grades, once the cause is gone" [ $? -eq 0 ]

# -- the output
check "$answer" >/dev/full 2>"$scratch/err"
ok "a result that cannot be written is a fault" [ $? -eq 2 ]
"$meshgrade" check euler-closed-mesh --quick "$answer" >/dev/full 2>"$scratch/err"
ok "also as text" [ $? -eq 2 ]
ok "which says so" matches "$scratch/err" 'could not be written'

# -- a crash of the grader itself, as soon as it catches SIGSEGV (bit 10 of its mask)
"$meshgrade" check euler-closed-mesh --all "$answer" >"$scratch/out" 2>"$scratch/err" &
pid=$!
until [ "$(cat /proc/$pid/comm)" = meshgrade ] && grep -q '^SigCgt:.*[4-7c-f]..$' /proc/$pid/status; do :; done 2>/dev/null
kill -SEGV $pid
wait $pid
ok "a crash of the grader is a fault" [ $? -eq 2 ]
ok "which says so" matches "$scratch/err" '^meshgrade: .*crashed'

# -- what cannot be read
if [ "$(id -u)" -eq 0 ] && setpriv --reuid 65534 --regid 65534 --clear-groups test -r "$meshgrade"; then
    chmod 755 "$scratch"
    mkdir -p "$scratch/class/ana" "$scratch/class/bruno"
    cp "$answer" "$scratch/class/ana/euler-closed-mesh.c"
    cp "$answer" "$scratch/class/bruno/euler-closed-mesh.c"
    chmod 000 "$scratch/class/bruno/euler-closed-mesh.c"
    install -d -o 65534 "$scratch/marks"
    TMPDIR=/tmp setpriv --reuid 65534 --regid 65534 --clear-groups "$meshgrade" grade "$scratch/class" -o "$scratch/marks" --no-pictures >"$scratch/out" 2>"$scratch/err"
    ok "a file that may not be read is a fault" [ $? -eq 2 ]
    ok "of its student, without a mark, and is named with a remedy" python3 -c '
import json, sys
r = json.load(open(sys.argv[1] + "/results/bruno/euler-closed-mesh.json"))
assert r["verdict"] == "fault" and r["score"] is None and r["cause"] == "unreadable", (r["verdict"], r["score"], r["cause"])
told = r["summary"]["en"]
assert "euler-closed-mesh.c" in told and "make it readable" in told, told' "$scratch/marks"
    ok "the other student has their mark" python3 -c '
import json, sys
r = json.load(open(sys.argv[1] + "/results/ana/euler-closed-mesh.json"))
assert r["verdict"] == "passed" and r["score"] == r["max_score"], (r["verdict"], r["score"])' "$scratch/marks"
else
    skip "a file that may not be read is a fault, of its student alone" "needs root, and a tree that others can read"
fi

# -- a damaged store
mkdir -p "$scratch/one/ana"
cp "$wrong" "$scratch/one/ana/euler-closed-mesh.c"
"$meshgrade" grade "$scratch/one" -o "$scratch/store" --no-pictures >/dev/null 2>&1
python3 - "$scratch/store/meshgrade.sqlite" <<'P'
import sqlite3, sys
store = sqlite3.connect(sys.argv[1])
store.execute("update result set result = replace(result, 'wrong-answer', 'passed')")
store.commit()
P
"$meshgrade" grade "$scratch/one" -o "$scratch/store" --no-pictures >"$scratch/out" 2>"$scratch/err"
ok "a store with a changed mark is refused" [ $? -eq 2 ]
ok "with the remedy" matches "$scratch/err" 'move the file away'

# -- in a mount namespace of the test's own: missing tools, full disks
if unshare -m true 2>/dev/null; then
    # Boxes get /usr as it is mounted, so that a file in it must be gone from it, not hidden under another.
    mkdir -p "$scratch/layers"
    without='mount -t tmpfs none "$0" && mkdir "$0/upper" "$0/work" &&
        mount -t overlay none -o lowerdir=/usr,upperdir="$0/upper",workdir="$0/work" /usr && rm "$1" && shift && exec "$@"'
    if unshare -m sh -c "$without" "$scratch/layers" "$(readlink -f /usr/bin/objcopy)" true 2>/dev/null; then
        for tool in /usr/bin/gcc "$(gcc -print-prog-name=cc1)" /usr/bin/as /usr/bin/ld /usr/bin/objcopy; do
            unshare -m sh -c "$without" "$scratch/layers" "$(readlink -f "$tool")" \
                "$meshgrade" check euler-closed-mesh --quick --json "$answer" >"$scratch/out" 2>"$scratch/err"
            code=$?
            ok "without $(basename "$tool") nothing is marked" is_fault $code "$scratch/out" "$scratch/err"
        done
    else
        skip "without a part of the compiler nothing is marked" "no overlay file system"
    fi
    # The reference is built first: some of these disks have room for it, and not for the submission.
    bad=
    for kilobytes in 200 3000 4500 6000; do
        mkdir -p "$scratch/tiny"
        unshare -m sh -c 'mount -t tmpfs -o mode=1777,size="$1"k none "$2" && shift && TMPDIR=$1 && export TMPDIR && shift && exec "$@"' - \
            $kilobytes "$scratch/tiny" "$meshgrade" check euler-closed-mesh --quick --json "$answer" >"$scratch/out" 2>"$scratch/err"
        code=$?
        [ $code -eq 0 ] || is_fault $code "$scratch/out" "$scratch/err" || bad="$bad $kilobytes"
    done
    ok "a scratch disk that is full is a fault, however full" [ -z "$bad" ]
    bad=
    mkdir -p "$scratch/disk"
    for kilobytes in 8 40 400 8000; do
        unshare -m sh -c 'mount -t tmpfs -o size="$1"k none "$2" && shift && out=$1 && shift && "$@" -o "$out"; code=$?
            ls "$out"/results/ana/*.json >/dev/null 2>&1 && ! python3 -m json.tool "$out"/results/ana/*.json >/dev/null && code=99; exit $code' - \
            $kilobytes "$scratch/disk" "$meshgrade" grade "$scratch/one" --no-pictures >"$scratch/out" 2>"$scratch/err"
        code=$?
        [ $code -eq 1 ] || is_fault $code "$scratch/out" "$scratch/err" || bad="$bad $kilobytes"
    done
    ok "a results disk that is full is a fault, and no result is half written" [ -z "$bad" ]
else
    skip "missing tools and full disks" "no mount namespaces for the test itself"
fi
done_testing
