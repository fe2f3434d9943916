# Tries: a file that gcc would take instead of the public header
# Stopped by: the upload: only .c and .h are taken
# expect: passed
echo 'gpch.014 rubbish' >edge-table-closed.h.gch
echo '--error-exitcode=0' >.valgrindrc
echo 'all:; touch /tmp/made' >Makefile
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
