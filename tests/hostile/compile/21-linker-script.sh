# Tries: a linker script named like an object file, which names files of the host
# Stopped by: the upload: only .c and .h are taken
# expect: passed
echo 'INPUT(/etc/passwd)' >evil.o
echo 'INPUT(/etc/passwd)' >libm.a
cp "$HOSTILE/honest.h" .
cat >edge-table-closed.c <<'C'
#include "edge-table-closed.h"
#include "honest.h"
int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
C
