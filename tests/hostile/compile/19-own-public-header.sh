# Tries: an own edge-table-closed.h with another type
# Stopped by: the build: the exercise's header is written last
# expect: passed
echo 'typedef char int32_t; this is no C' >edge-table-closed.h
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
