# Tries: compiler options of its own, in a header that gcc takes for a system header
# Stopped by: the policy: a system header is what lies below /usr/include, whatever the marker says
# expect: compile-error, forbidden-include
# expect(private-root): compile-error, syntax

{
    echo '#include <linux/../../../work/x.h>'
    cat "$HOSTILE/right.c"
} >edge-table-closed.c
cp "$HOSTILE/honest.h" .
echo '#pragma GCC target("avx512f")' >x.h
mkdir edge-table-closed
mv edge-table-closed.c honest.h x.h edge-table-closed
