/* Claims two thousand million vertices and gives no table.
 * expect: wrong-answer
 * fails: vertices, triangles, smallest, measured-memory
 */
#include "memory-indexed-grid.h"

#include <stddef.h>

static int64_t vertex_count_of(int64_t m, int64_t n)
{
    return (m + 1) * (n + 1);
}

static int64_t triangle_count_of(int64_t m, int64_t n)
{
    return 2 * m * n;
}

int64_t indexed_grid_bytes(int32_t m, int32_t n)
{
    return vertex_count_of(m, n) * 3 * (int64_t)sizeof(float) +
           triangle_count_of(m, n) * 3 * (int64_t)sizeof(int32_t);
}

double indexed_grid_kilobytes(void)
{
    return (double)indexed_grid_bytes(128, 128) / 1024;
}

double indexed_grid_faces_per_vertex(void)
{
    return 2; /* 2mn / ((m + 1)(n + 1)) */
}

int indexed_grid_build(int32_t m, int32_t n, struct indexed_grid *grid)
{
    (void)m;
    (void)n;
    grid->vertices = NULL;
    grid->triangles = NULL;
    grid->vertex_count = INT32_MAX;
    grid->triangle_count = INT32_MIN;
    return 0;
}
