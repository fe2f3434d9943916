# Tries: an engine that is killed while a submission runs for ever
# Stopped by: the box dies with the engine
# expect: nothing left

. "$HOSTILE/scene.sh"
cp "$HOSTILE"/runtime/*-endless-loop.c class/ana/edge-table-closed.c
cp "$HOSTILE/honest.h" class/ana
setsid "$MESHGRADE" grade class -o out --no-pictures -j 1 >/dev/null 2>&1 &
engine=$!
for _ in $(seq 600); do # until the submission is at work below the engine
    pgrep -f '^submission$' -s "$engine" >/dev/null && break
    sleep 0.1
done
kill -9 "$engine"
for _ in $(seq 100); do
    pgrep -s "$engine" >/dev/null || break
    sleep 0.1
done
if pgrep -s "$engine" >/dev/null; then echo "something left"; else echo "nothing left"; fi
