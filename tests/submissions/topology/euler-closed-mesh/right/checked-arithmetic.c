/* A function for each known number; the compiler's checked arithmetic finds what does not fit. */
#include "euler-closed-mesh.h"

static int by_vertices(int64_t v, struct euler_counts *counts)
{
    int64_t edges, faces;
    if (v < 4 || __builtin_mul_overflow(v - 2, 3, &edges) ||
        __builtin_mul_overflow(v - 2, 2, &faces))
        return IMPOSSIBLE;
    counts->vertices = v;
    counts->edges = edges;
    counts->faces = faces;
    return 0;
}

static int by_edges(int64_t e, struct euler_counts *counts)
{
    if (e < 6 || e % 3 != 0)
        return IMPOSSIBLE;
    counts->vertices = e / 3 + 2;
    counts->edges = e;
    counts->faces = e / 3 * 2;
    return 0;
}

static int by_faces(int64_t f, struct euler_counts *counts)
{
    int64_t edges;
    if (f < 4 || f % 2 != 0 || __builtin_mul_overflow(f / 2, 3, &edges))
        return IMPOSSIBLE;
    counts->vertices = f / 2 + 2;
    counts->edges = edges;
    counts->faces = f;
    return 0;
}

int euler_counts_from(enum euler_given given, int64_t count, struct euler_counts *counts)
{
    if (given == GIVEN_VERTICES)
        return by_vertices(count, counts);
    return given == GIVEN_EDGES ? by_edges(count, counts) : by_faces(count, counts);
}
