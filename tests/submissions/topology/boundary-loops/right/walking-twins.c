/* Finds the twin of every side. From a boundary side the next one is reached by going round the
 * vertex where it ends, from triangle to triangle. */
#include "boundary-loops.h"

#include <stdlib.h>

enum { NO_TWIN = -1, TAKEN = -2 };

static int32_t next_in_triangle(int32_t s)
{
    return s % 3 == 2 ? s - 2 : s + 1;
}

/* Sides wait in a list at the vertex where they end until their twin comes and begins there. */
static void find_twins(const int32_t *triangles, int32_t side_count, int32_t *waiting,
                       int32_t *next, int32_t *twin)
{
    for (int32_t s = 0; s < side_count; s++) {
        int32_t i = triangles[s], j = triangles[next_in_triangle(s)];
        int32_t other = waiting[i];
        while (other >= 0 && triangles[other] != j)
            other = next[other];
        twin[s] = other >= 0 ? other : NO_TWIN;
        if (other >= 0)
            twin[other] = s;
        next[s] = waiting[j];
        waiting[j] = s;
    }
}

static int32_t walk(const int32_t *triangles, int32_t side_count, int32_t *twin, int32_t *first,
                    int32_t *vertices)
{
    int32_t loops = 0, length = 0;
    first[0] = 0;
    for (int32_t start = 0; start < side_count; start++) {
        if (twin[start] != NO_TWIN)
            continue;
        int32_t s = start;
        do {
            vertices[length++] = triangles[s];
            twin[s] = TAKEN;
            s = next_in_triangle(s);
            while (twin[s] >= 0)
                s = next_in_triangle(twin[s]);
        } while (s != start);
        first[++loops] = length;
    }
    return loops;
}

int32_t boundary_loops(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **first, int32_t **vertices)
{
    int32_t side_count = 3 * triangle_count, loops = OUT_OF_MEMORY;
    size_t side_bytes = (size_t)side_count * sizeof(int32_t);
    int32_t *waiting = malloc((size_t)vertex_count * sizeof *waiting + 1);
    int32_t *next = malloc(side_bytes + 1), *twin = malloc(side_bytes + 1);
    *first = malloc(((size_t)triangle_count + 1) * sizeof **first);
    *vertices = malloc(side_bytes + 1);
    if (waiting && next && twin && *first && *vertices) {
        for (int32_t v = 0; v < vertex_count; v++)
            waiting[v] = -1;
        find_twins(triangles, side_count, waiting, next, twin);
        loops = walk(triangles, side_count, twin, *first, *vertices);
    } else {
        free(*first);
        free(*vertices);
    }
    free(waiting);
    free(next);
    free(twin);
    return loops;
}
