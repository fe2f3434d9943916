/* Whether a mesh lists its triangles so that neighbours in the table are neighbours on the surface.
 */
#ifndef REFERENCE_KERNELS_ORDER_H
#define REFERENCE_KERNELS_ORDER_H

#include "reference/mesh/mesh.h"

#include <stdbool.h>
#include <stddef.h>

/* Looks at a few hundred places of the triangle table. True means that tables of some 16 bytes a
 * vertex outgrow a core's cache and that triangles in a row name vertices from all over them, so
 * that kernels do well to prefetch. It is only about speed: no output depends on it. */
bool order_is_scattered(const struct mesh *mesh);

/* Whether the mesh is scattered and so large that rows of a cache line a vertex outgrow even the
 * caches behind the core's own: sorting by ranges of vertices first then costs less than missing.
 */
bool order_is_worth_parting(const struct mesh *mesh);

/* How many triangles before its turn a triangle's corners are asked for in a scattered mesh. */
enum { CORNERS_AHEAD = 16 };

/* Asks for the positions of a triangle's corners. */
static inline void prefetch_corners(const float *positions, const int32_t t[3])
{
    for (int corner = 0; corner < 3; corner++)
        __builtin_prefetch(positions + 3 * (size_t)t[corner]);
}

/* The corners of a triangle in ascending order. */
struct sorted {
    int32_t low, middle, high;
};

static inline struct sorted sort_corners(const int32_t t[3])
{
    int32_t less = t[0] < t[1] ? t[0] : t[1], more = t[0] < t[1] ? t[1] : t[0];
    int32_t rest = less < t[2] ? t[2] : less;
    return (struct sorted){less < t[2] ? less : t[2], rest < more ? rest : more,
                           rest < more ? more : rest};
}

#endif
