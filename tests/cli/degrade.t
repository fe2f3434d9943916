#!/bin/bash
# What is missing on a machine gives a clear line and no mark: valgrind, GL, cgroups, user namespaces,
# root. Each absence is made for real in a mount namespace of the test's own.
. "$(dirname "$0")/tap.sh"
answer=$submissions/edges/edge-table-any/right/sort.c

if ! unshare -m true 2>/dev/null; then
    echo "1..0 # skip no mount namespaces for the test itself"
    exit 0
fi

without() { # path, command...: runs with a path hidden by /dev/null
    unshare -m sh -c 'mount --bind /dev/null "$0" && exec "$@"' "$@"
}

without /usr/bin/valgrind "$meshgrade" check edge-table-any --all --json "$answer" >"$scratch/no-valgrind.json"
ok "without valgrind nothing rests on counts" python3 - "$scratch/no-valgrind.json" <<'P'
import json, sys
r = json.load(open(sys.argv[1]))
checks = {c["name"]: c for c in r["checks"]}
assert checks["growth"]["verdict"] == "not-measured" and checks["growth"]["points"] == 0
assert checks["work"]["verdict"] == "not-measured" and checks["work"]["points"] == 0
assert "growth" not in r["measures"] and r["not_measured"][0]["reason"]["es"].startswith("valgrind no est")
assert "valgrind no est" in checks["growth"]["message"]["es"]
assert r["verdict"] == "passed"
P
without /usr/bin/valgrind "$meshgrade" doctor >"$scratch/doctor"
ok "doctor says what to install" matches "$scratch/doctor" 'apt-get install valgrind'

if [ -x /usr/bin/ld.gold ]; then
    without "$(readlink -f /usr/bin/ld.gold)" "$meshgrade" check edge-table-any --all --json "$answer" >"$scratch/no-gold.json"
    ok "without the gold linker the other one serves" python3 - "$scratch/no-gold.json" <<'P'
import json, sys
r = json.load(open(sys.argv[1]))
assert r["verdict"] == "passed" and r["score"] == r["max_score"] and r["build"]["diagnostics"] == ""
P
else
    skip "without the gold linker the other one serves" "there is none"
fi

mkdir "$scratch/class" "$scratch/class/a"
cp "$submissions/edges/edge-table-any/wrong/boundary-lost.c" "$scratch/class/a/edge-table-any.c"
__EGL_VENDOR_LIBRARY_DIRS=/nonexistent "$meshgrade" grade "$scratch/class" -o "$scratch/out" >/dev/null 2>"$scratch/talk"
ok "without GL there is a report" [ -s "$scratch/out/index.html" ]
ok "and a line that says why it has no pictures" matches "$scratch/talk" '[Pp]icture'

unshare -m sh -c 'mount -t tmpfs -o ro none /sys/fs/cgroup && exec "$@"' - "$meshgrade" check edge-table-any --quick --json "$answer" >"$scratch/no-cgroup.json"
ok "without cgroups it is graded, and the result says so" python3 - "$scratch/no-cgroup.json" <<'P'
import json, sys
r = json.load(open(sys.argv[1]))
assert r["verdict"] == "passed" and "cgroup-memory" in r["protections"]["inactive"]
P

unshare -U -r -m sh -c 'echo 0 >/proc/sys/user/max_user_namespaces && exec "$@"' - "$meshgrade" check edge-table-any --quick --json "$answer" >"$scratch/no-namespaces.json" 2>"$scratch/talk"
code=$?
if [ $code -eq 0 ]; then
    ok "without user namespaces it is graded, and the result says so" python3 -c '
import json, sys
assert "user-namespace" in json.load(open(sys.argv[1]))["protections"]["inactive"]' "$scratch/no-namespaces.json"
else
    ok "without user namespaces it is refused with one clear line" [ "$code" -eq 2 -a "$(wc -l <"$scratch/talk")" -eq 1 ]
fi

# As root in a container: no namespaces, and the box's user is another one, which reaches files by the host's names.
if [ "$(id -u)" -eq 0 ]; then
    chmod 755 "$scratch"
    mkdir -p "$scratch/right/ana" "$scratch/closed"
    cp "$answer" "$scratch/right/ana/edge-table-any.c"
    chmod 700 "$scratch/closed"
    for layer in mount-namespace pid-namespace private-root other-user; do
        "$meshgrade" grade "$scratch/right" --without $layer -o "$scratch/open-$layer" --no-pictures >/dev/null 2>"$scratch/talk"
        ok "root without $layer gives full marks, counts included" python3 -c '
import json, sys
r = json.load(open(sys.argv[1]))
assert r["verdict"] == "passed" and r["score"] == r["max_score"] and not r["not_measured"], (r["verdict"], r["score"])
assert r["protections"]["inactive"][sys.argv[2]]["es"], r["protections"]
assert r["build"]["diagnostics"] == "", r["build"]["diagnostics"]' "$scratch/open-$layer/results/ana/edge-table-any.json" $layer
    done
    "$meshgrade" grade "$scratch/right" --without private-root -o "$scratch/closed/marks" --no-pictures >/dev/null 2>"$scratch/talk"
    ok "a folder that the box's user cannot pass is a fault" [ $? -eq 2 ]
    ok "which names it and the remedy" matches "$scratch/talk" "$scratch/closed: .*chmod o.x"
    ok "never a mark" python3 -c '
import json, sys
r = json.load(open(sys.argv[1]))
assert r["verdict"] == "fault" and r["score"] is None, (r["verdict"], r["score"])' "$scratch/closed/marks/results/ana/edge-table-any.json"
else
    skip "root without namespaces gives full marks" "needs root"
fi

if [ "$(id -u)" -eq 0 ]; then
    cp "$answer" "$scratch/answer.c"
    TMPDIR=/tmp setpriv --reuid 65534 --regid 65534 --clear-groups "$meshgrade" check edge-table-any --all --json "$scratch/answer.c" >"$scratch/nobody.json" 2>"$scratch/talk"
    code=$?
    if [ $code -eq 2 ] && ! setpriv --reuid 65534 --regid 65534 --clear-groups test -r "$meshgrade"; then
        skip "a plain user gets the same marks" "the tree is not readable for others"
    else
        ok "a plain user gets the same marks" python3 -c '
import json, sys
r = json.load(open(sys.argv[1]))
assert r["verdict"] == "passed" and r["score"] == 10' "$scratch/nobody.json"
    fi
else
    skip "a plain user gets the same marks" "the tests run as a plain user already"
fi
done_testing
