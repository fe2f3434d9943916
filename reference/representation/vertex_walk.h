/* Sweeps over vertices that all linked representations make in the same way, each with its own
 * steps. Everything is inline and called with the names of functions, so that a step costs in each
 * representation what it costs there, and comparisons between them stay fair. */
#ifndef REFERENCE_REPRESENTATION_VERTEX_WALK_H
#define REFERENCE_REPRESENTATION_VERTEX_WALK_H

#include "reference/base/error.h"
#include "reference/representation/vector.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define WALK_INLINE static inline __attribute__((always_inline))

/* Lists the boundary loops as representation.h says.
 *
 * on_boundary  whether the vertex lies on the boundary; false where no face meets
 * next         the next vertex of its loop, the way the faces run; asked of boundary vertices only
 * returns      loops, or -1 and *err
 * Cost: O(V), a byte a vertex */
WALK_INLINE int32_t walk_boundary_loops(const void *self, int32_t vertex_count,
                                        bool (*on_boundary)(const void *self, int32_t vertex),
                                        int32_t (*next)(const void *self, int32_t vertex),
                                        int32_t *vertices, int32_t *loop_starts, struct error *err)
{
    uint8_t *visited = calloc((size_t)vertex_count + 1, 1);
    if (!visited)
        return error_set(err, "out of memory: boundary loops of %d vertices", vertex_count);
    int32_t count = 0, loops = 0;
    for (int32_t first = 0; first < vertex_count; first++) {
        if (visited[first] || !on_boundary(self, first))
            continue;
        loop_starts[loops++] = count;
        for (int32_t v = first; !visited[v]; v = next(self, v)) {
            visited[v] = 1;
            vertices[count++] = v;
        }
    }
    loop_starts[loops] = count;
    free(visited);
    return loops;
}

/* One step of uniform Laplacian smoothing: each vertex inside moves to the mean of its neighbours.
 *
 * positions    three floats a vertex
 * is_inside    whether faces meet at the vertex and it is not on the boundary
 * mean_around  of such a vertex's neighbours
 * returns      0, or -1 and *err
 * Cost: O(E), twelve bytes a vertex */
WALK_INLINE int walk_smooth(const void *self, float *positions, int32_t vertex_count,
                            bool (*is_inside)(const void *self, int32_t vertex),
                            struct vector (*mean_around)(const void *self, int32_t vertex),
                            struct error *err)
{
    size_t size = 3 * (size_t)vertex_count * sizeof *positions;
    float *moved = malloc(size + 1);
    if (!moved)
        return error_set(err, "out of memory: smoothing %d vertices", vertex_count);
    for (int32_t v = 0; v < vertex_count; v++)
        vector_put(moved, v, is_inside(self, v) ? mean_around(self, v) : vector_at(positions, v));
    if (vertex_count > 0)
        memcpy(positions, moved, size);
    free(moved);
    return 0;
}

#endif
