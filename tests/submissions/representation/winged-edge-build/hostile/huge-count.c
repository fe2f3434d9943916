/* Returns more edges than there can be.
 * expect: wrong-answer */
#include "winged-edge-build.h"

#include <stdlib.h>

int32_t winged_edge_build(const int32_t *first_corner, const int32_t *corners, int32_t face_count,
                          int32_t vertex_count, struct winged_edge **edges, int32_t *vertex_edge,
                          int32_t *face_edge)
{
    (void)first_corner;
    (void)corners;
    for (int32_t v = 0; v < vertex_count; v++)
        vertex_edge[v] = NONE;
    for (int32_t f = 0; f < face_count; f++)
        face_edge[f] = NONE;
    *edges = calloc(1, sizeof **edges);
    return *edges ? INT32_MAX : OUT_OF_MEMORY;
}
