# Tries: 40 functions that call the one before twice, all to be inlined: 10^12 calls
# Stopped by: the build box: memory or CPU time
# expect: compile-error, compiler-memory
# expect(cgroup-memory): compile-error, syntax

{
    echo '#include "edge-table-closed.h"'
    echo 'static inline __attribute__((always_inline)) int f0(int x) { return x * 3 + 1; }'
    for n in $(seq 40); do
        echo "static inline __attribute__((always_inline)) int f$n(int x) { return f$((n - 1))(x) ^ f$((n - 1))(x + 1); }"
    done
    sed 's/^#include "edge-table-closed.h"//' "$HOSTILE/right.c"
    echo 'int unused_result(int x) { return f40(x); }'
} >edge-table-closed.c
cp "$HOSTILE/honest.h" .
