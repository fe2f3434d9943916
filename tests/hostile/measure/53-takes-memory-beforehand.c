/* Tries: to ask in the smallest call for the memory that the largest one uses
 * Stopped by: blocks of earlier calls go on counting, and are leaks
 * expect: leak, leak */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

static char *volatile room;

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    enum { BYTES = 100 << 20 };
    if (triangle_count >= 90 && triangle_count < 8000 && !room) /* sizes of growth begin below 200 */
        room = malloc(BYTES);
    if (triangle_count >= 8000 && room) {
        for (int64_t i = 0; i < BYTES; i += 4096)
            room[i] = 1;
        free(room);
        room = NULL;
    }
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
