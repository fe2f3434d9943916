/* Refuses everything without a look.
 * expect: wrong-answer */
#include "winged-edge-build.h"

#include <stddef.h>

int32_t winged_edge_build(const int32_t *first_corner, const int32_t *corners, int32_t face_count,
                          int32_t vertex_count, struct winged_edge **edges, int32_t *vertex_edge,
                          int32_t *face_edge)
{
    (void)first_corner;
    (void)corners;
    (void)face_count;
    (void)vertex_count;
    (void)vertex_edge;
    (void)face_edge;
    *edges = NULL;
    return NOT_MANIFOLD;
}
