/* Problem 4.4: Euler's formula V - E + F = 2 with 3F = 2E, since every face has three edges and
 * every edge two faces. */
#include "euler-closed-mesh.h"

enum { TETRAHEDRON_VERTICES = 4, TETRAHEDRON_EDGES = 6, TETRAHEDRON_FACES = 4 };

/* All three numbers from the number of vertices, or IMPOSSIBLE. */
static int from_vertices(int64_t vertices, struct euler_counts *counts)
{
    if (vertices < TETRAHEDRON_VERTICES || vertices - 2 > INT64_MAX / 3)
        return IMPOSSIBLE;
    counts->vertices = vertices;
    counts->edges = 3 * (vertices - 2);
    counts->faces = 2 * (vertices - 2);
    return 0;
}

int euler_counts_from(enum euler_given given, int64_t count, struct euler_counts *counts)
{
    switch (given) {
    case GIVEN_VERTICES:
        return from_vertices(count, counts);
    case GIVEN_EDGES:
        if (count < TETRAHEDRON_EDGES || count % 3 != 0)
            return IMPOSSIBLE;
        return from_vertices(count / 3 + 2, counts);
    case GIVEN_FACES:
        if (count < TETRAHEDRON_FACES || count % 2 != 0)
            return IMPOSSIBLE;
        return from_vertices(count / 2 + 2, counts);
    }
    return IMPOSSIBLE;
}
