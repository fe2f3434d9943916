/* Tries: to leave the call by a jump into a frame that is gone
 * Stopped by: a process of its own: nothing but itself breaks
 * expect: crash, segmentation-fault */
#include "edge-table-closed.h"

#include <setjmp.h>

static jmp_buf place;

static int remember(void)
{
    return setjmp(place);
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)triangles, (void)triangle_count, (void)vertex_count, (void)edges;
    if (remember() == 0)
        longjmp(place, 1);
    return 0;
}
