# Sourced by the command-line tests: TAP output, and where things stand.
cd "$(dirname "$0")/../.." || exit 1
root=$PWD
meshgrade=$root/build/meshgrade
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
tests=0
unset NO_COLOR MESHGRADE_ROOT
export LC_ALL=C.UTF-8

# The known-verdict submissions, each as a whole file, <group>/<exercise>/<kind>/<name>.c.
submissions=$scratch/submissions
[ ! -x "$meshgrade" ] || "$meshgrade" validate --expand "$submissions" || exit 1

ok() { # description, command...
    tests=$((tests + 1))
    what=$1
    shift
    if "$@"; then echo "ok $tests - $what"; else echo "not ok $tests - $what"; fi
}

skip() { # description, reason
    tests=$((tests + 1))
    echo "ok $tests - $1 # SKIP $2"
}

exits_with() { # code, command...
    expected=$1
    shift
    "$@"
    code=$?
    [ "$code" -eq "$expected" ] || { echo "# exit code $code, expected $expected: $*"; return 1; }
}

matches() { # file, extended regular expression
    grep -qE -- "$2" "$1" || { echo "# $1 does not match: $2"; sed 's/^/# /' "$1" | head -n 20; return 1; }
}

done_testing() { echo "1..$tests"; }
