# Tries: a protection left out unseen
# Stopped by: every result names what was not active
# expect: switched off

. "$HOSTILE/scene.sh"
grade --without landlock
python3 -c 'import glob, json; print(json.load(open(glob.glob("out/results/*/*.json")[0]))["protections"]["inactive"]["landlock"]["en"])'
