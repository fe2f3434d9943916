#!/bin/bash
# What the caller asked for and is not there is wrong usage: exit code 64, one line that says what and where.
. "$(dirname "$0")/tap.sh"
answer=$submissions/topology/euler-closed-mesh/right/by-faces.c
mkdir -p "$scratch/class/Ana García" "$scratch/class/bruno" "$scratch/class/carla" "$scratch/empty"
for student in "Ana García" bruno carla; do cp "$answer" "$scratch/class/$student/euler-closed-mesh.c"; done
echo text >"$scratch/notes.txt"
cd "$scratch" || exit 1

refused() { # regular expression, arguments...
    expected=$1
    shift
    "$meshgrade" "$@" >stdout 2>stderr
    code=$?
    [ $code -eq 64 ] || { echo "# exit code $code, expected 64: $*"; sed 's/^/# /' stderr; return 1; }
    [ ! -s stdout ] || { echo "# printed all the same"; return 1; }
    [ "$(wc -l <stderr)" -eq 1 ] || { echo "# not one line:"; sed 's/^/# /' stderr; return 1; }
    ! grep -q 'meshgrade: meshgrade:' stderr && matches stderr "^meshgrade: .*$expected"
}

# -- files and folders that are not there, or are something else
ok "check: a missing file" refused 'absent\.c' check euler-closed-mesh absent.c
ok "check: a file below a file" refused 'notes\.txt/x\.c' check euler-closed-mesh notes.txt/x.c
ok "check: a file that is no source" refused 'notes\.txt: not a \.c or \.h file' check euler-closed-mesh notes.txt
ok "check: a folder" refused 'class: not a \.c or \.h file' check euler-closed-mesh class
ok "grade: a missing folder" refused 'absent' grade absent -o out
ok "grade: a file that is no submission" refused 'notes\.txt: neither a folder, an archive' grade notes.txt -o out
ok "grade: results into a file" refused 'notes\.txt' grade class -o notes.txt
ok "report: a missing folder" refused 'absent.*meshgrade grade' report absent
ok "which is not made" [ ! -e absent ]
ok "report: a folder without a class" refused 'empty.*meshgrade grade' report empty
ok "which stays empty" [ -z "$(ls -A empty)" ]
ok "export: a missing folder" refused 'absent.*meshgrade grade' export absent --format csv
ok "bench: a missing page" refused 'absent' bench --page absent

# -- names that nobody has
ok "an unknown exercise, with the nearest" refused '"edge-table".*edge-table-any' check edge-table "$answer"
ok "also when grading" refused '"euler".*euler-closed-mesh' grade class -o out --exercise euler
ok "and when starting" refused '"mesh-aera".*mesh-area' start mesh-aera
ok "an unknown case" refused 'no case "cub"' check euler-closed-mesh "$answer" --case cub
ok "an unknown student, with the nearest" refused '"brno".*bruno' grade class -o out --only brno
ok "nearest also without the accent" refused '"Ana Garcia Lopez".*Ana-Garcia' grade class -o out --only 'Ana Garcia Lopez'
ok "or by a part of the name" refused '"garcia".*Ana-Garcia' grade class -o out --only garcia
ok "a student like nobody" refused '"zzz".*3 students' grade class -o out --only zzz
ok "nothing of this made a folder of results" [ ! -e out/results ]

# -- options
ok "check: a language that it does not speak" refused '--lang fr: .*en or es' check euler-closed-mesh "$answer" --lang fr
ok "export: a language that it does not speak" refused '--lang fr: .*en or es' export empty --format csv --lang fr
ok "export: an unknown format" refused 'excel.*gradescope' export empty --format excel
ok "--apply alone" refused '--apply.*--rejudge' grade class -o out --apply

# -- one program's name a line
cp -L "$meshgrade" meshgrade-alone
./meshgrade-alone list >stdout 2>stderr
ok "a program without its tree is a fault" [ $? -eq 2 ]
ok "with one line that names the remedy" matches stderr '^meshgrade: exercises/ and graders/ .*MESHGRADE_ROOT'

# -- a student's name that is there
"$meshgrade" grade class -o out --only 'Ana García' --no-pictures >stdout 2>stderr
ok "one student alone, by name" [ $? -eq 0 -a "$(ls out/results)" = Ana-Garcia ]
"$meshgrade" grade class -o out --only bruno --no-pictures >stdout 2>stderr
ok "and by folder" [ $? -eq 0 -a "$(ls out/results | tr '\n' ' ')" = 'Ana-Garcia bruno ' ]
ok "export: an unknown student" refused 'no student is named "carla"' export out --format vpl --student carla
done_testing
