/* Every triangle begins as a ring of three sides. Gluing two triangles at their common edge takes
 * its two sides out and joins, or parts, the rings. The rings that stay are the boundary. */
#include "boundary-loops.h"

#include <stdlib.h>

struct rings {
    int32_t *next, *previous; /* for each side; next -1: taken out, or listed */
};

static int32_t after(int32_t s)
{
    return s % 3 == 2 ? s - 2 : s + 1;
}

static void link_sides(struct rings *rings, int32_t s, int32_t t)
{
    rings->next[s] = t;
    rings->previous[t] = s;
}

static void glue(struct rings *rings, int32_t s, int32_t t)
{
    link_sides(rings, rings->previous[s], rings->next[t]);
    link_sides(rings, rings->previous[t], rings->next[s]);
    rings->next[s] = rings->next[t] = -1;
}

/* Sides of every vertex, by counting: those of v are order[start[v]] ... order[start[v + 1] - 1].
 */
static void sort_sides(const int32_t *triangles, int32_t side_count, int32_t vertex_count,
                       int32_t *start, int32_t *order)
{
    for (int32_t s = 0; s < side_count; s++)
        start[triangles[s] + 1]++;
    for (int32_t v = 0; v < vertex_count; v++)
        start[v + 1] += start[v];
    for (int32_t s = side_count - 1; s >= 0; s--)
        order[--start[triangles[s] + 1]] = s;
    /* Now start[v + 1] is where the sides of v begin. */
}

static void glue_all(const int32_t *triangles, int32_t side_count, const int32_t *start,
                     const int32_t *order, struct rings *rings)
{
    for (int32_t s = 0; s < side_count; s++)
        link_sides(rings, s, after(s));
    for (int32_t s = 0; s < side_count; s++) {
        int32_t i = triangles[s], j = triangles[after(s)];
        for (int32_t k = start[j + 1]; i < j && k < side_count && triangles[order[k]] == j; k++)
            if (triangles[after(order[k])] == i) {
                glue(rings, s, order[k]);
                break;
            }
    }
}

static int32_t list_rings(const int32_t *triangles, int32_t side_count, struct rings *rings,
                          int32_t *first, int32_t *vertices)
{
    int32_t loops = 0, length = 0;
    first[0] = 0;
    for (int32_t begin = 0; begin < side_count; begin++) {
        if (rings->next[begin] < 0)
            continue;
        for (int32_t s = begin; rings->next[s] >= 0;) {
            int32_t next = rings->next[s];
            vertices[length++] = triangles[s];
            rings->next[s] = -1;
            s = next;
        }
        first[++loops] = length;
    }
    return loops;
}

int32_t boundary_loops(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **first, int32_t **vertices)
{
    int32_t side_count = 3 * triangle_count, loops = OUT_OF_MEMORY;
    size_t side_bytes = (size_t)side_count * sizeof(int32_t);
    struct rings rings = {malloc(side_bytes + 1), malloc(side_bytes + 1)};
    int32_t *start = calloc((size_t)vertex_count + 1, sizeof *start);
    int32_t *order = malloc(side_bytes + 1);
    *first = malloc(((size_t)triangle_count + 1) * sizeof **first);
    *vertices = malloc(side_bytes + 1);
    if (rings.next && rings.previous && start && order && *first && *vertices) {
        sort_sides(triangles, side_count, vertex_count, start, order);
        glue_all(triangles, side_count, start, order, &rings);
        loops = list_rings(triangles, side_count, &rings, *first, *vertices);
    } else {
        free(*first);
        free(*vertices);
    }
    free(rings.next);
    free(rings.previous);
    free(start);
    free(order);
    return loops;
}
