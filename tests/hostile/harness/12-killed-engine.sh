# Tries: an engine that is killed while a submission runs for ever
# Stopped by: the box dies with the engine; the next engine removes its control groups
# expect: nothing left

. "$HOSTILE/scene.sh"
cp "$HOSTILE"/runtime/*-endless-loop.c class/ana/edge-table-closed.c
cp "$HOSTILE/honest.h" class/ana
setsid "$MESHGRADE" grade class -o out --no-pictures -j 1 >/dev/null 2>&1 &
engine=$! started=no
for _ in $(seq 600); do # until the submission is at work below the engine
    ps -o args= -s "$engine" | grep -qx submission && started=yes && break
    sleep 0.1
done
kill -9 "$engine"
for _ in $(seq 100); do
    ps -o stat= -s "$engine" | grep -qv Z || break
    sleep 0.1
done
left=$(ps -o stat= -s "$engine" | grep -v Z)
"$MESHGRADE" check edge-table-closed --quick class/ana/edge-table-closed.c class/ana/honest.h >/dev/null 2>&1
if [ "$started" = no ]; then
    echo "the submission never ran"
elif [ -n "$left" ]; then
    echo "something left"
else
    echo "nothing left"
fi
