# Tries: an own stdlib.h beside the answer, which changes malloc
# Stopped by: nothing needs to: it is the student's own text; their function calls what they say
# expect: passed
echo '#include_next <stdlib.h>' >stdlib.h
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
