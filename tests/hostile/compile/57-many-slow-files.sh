# Tries: nineteen files, each of which the compiler works on for seconds, and none for too long
# Stopped by: the build box: the CPU time of all its processes together
# expect: compile-error, compiler-time

mkdir edge-table-closed
cd edge-table-closed
cp "$HOSTILE/right.c" answer.c
cp "$HOSTILE/honest.h" .
for file in $(seq 18); do
    {
        echo "unsigned slow$file(unsigned x, unsigned y, unsigned *a)"
        echo '{'
        for k in $(seq 800); do
            echo "    if (x & $((k % 31 + 1))) { x = x * $((2 * k + 3))u + y; y ^= x >> $((k % 13 + 1)); }"
            echo "    else { y += a[x % $((k + 2))] * x; a[y % $((k + 3))] = x; }"
        done
        echo '    return x + y;'
        echo '}'
    } >"slow$file.c"
done
