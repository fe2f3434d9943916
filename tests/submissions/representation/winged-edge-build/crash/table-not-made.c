/* Writes into the table without making it. */
#include "winged-edge-build.h"

#include <stddef.h>

int32_t winged_edge_build(const int32_t *first_corner, const int32_t *corners, int32_t face_count,
                          int32_t vertex_count, struct winged_edge **edges, int32_t *vertex_edge,
                          int32_t *face_edge)
{
    (void)first_corner;
    (void)vertex_count;
    *edges = NULL;
    for (int32_t f = 0; f < face_count; f++) {
        (*edges)[f].vi = corners[f];
        vertex_edge[0] = face_edge[f] = f;
    }
    return face_count;
}
