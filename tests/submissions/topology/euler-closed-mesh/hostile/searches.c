/* Tries one number of vertices after the other until the edges or faces agree.
 * expect: cpu-time
 */
#include "euler-closed-mesh.h"

enum { TETRAHEDRON_VERTICES = 4 };

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
    if (given == GIVEN_VERTICES)
        return from_vertices(count, counts);
    for (volatile int64_t vertices = TETRAHEDRON_VERTICES;; vertices++) {
        if (from_vertices(vertices, counts) == IMPOSSIBLE)
            return IMPOSSIBLE;
        int64_t reached = given == GIVEN_EDGES ? counts->edges : counts->faces;
        if (reached >= count)
            return reached == count ? 0 : IMPOSSIBLE;
    }
}
