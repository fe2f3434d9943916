/* Problem 4.4: numbers of vertices, edges and faces of a closed mesh.
 *
 * The mesh is a polyhedron with triangular faces, closed and simply connected: it can be deformed
 * into a sphere, and every edge belongs to exactly two faces. Then each of the three numbers
 * determines the other two.
 *
 * You write the one function. The file needs nothing but this header and the C library. */
#ifndef EULER_CLOSED_MESH_H
#define EULER_CLOSED_MESH_H

#include <stdint.h>

/* Which of the three numbers is known. */
enum euler_given { GIVEN_VERTICES, GIVEN_EDGES, GIVEN_FACES };

/* What the function returns when there is no such mesh. */
enum { IMPOSSIBLE = -1 };

struct euler_counts {
    int64_t vertices;
    int64_t edges;
    int64_t faces;
};

/* The numbers of vertices, edges and faces of a mesh of which one is known.
 *
 * given    which number is known
 * count    that number; may be any int64_t
 * counts   gets all three numbers, the known one too; when the result is IMPOSSIBLE it does not
 * matter what it holds returns  0, or IMPOSSIBLE when no such mesh has this count (the smallest is
 * the tetrahedron), or when one of the other numbers does not fit into an int64_t
 *
 * The time must not depend on the count. */
int euler_counts_from(enum euler_given given, int64_t count, struct euler_counts *counts);

#endif
