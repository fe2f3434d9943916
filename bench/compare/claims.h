/* What the course's documents say about meshes and their representations, against measurement:
 *
 *  - F is about 2 V, E about 3 V, and a vertex has about 6 neighbours (000, 001, 002);
 *  - isolated triangles process each vertex about 6 times, strips close to 2 times, an indexed mesh
 *    once (000, 002); for large grids an indexed mesh takes 3/2 of the memory of strips, and strips
 *    process twice as many vertices (problem 4.3);
 *  - the bytes of spheres and grids that problems 4.1 to 4.3 ask for, measured on built ones;
 *  - to ask an indexed mesh whether two vertices are adjacent is to look at all triangles (000,
 * 002);
 *  - the accesses of the queries on winged edges (001), counted (counted_winged_edge.h).
 *
 * "About" and "close to" hold within a tenth. A claim of so many accesses is a bound, and holds
 * when no more are counted, leaving out up to two rows that only say where the walk starts. A claim
 * that does not hold is no mistake of ours: it is what the table is for. */
#ifndef BENCH_COMPARE_CLAIMS_H
#define BENCH_COMPARE_CLAIMS_H

#include "reference/mesh/mesh.h"
#include "reference/representation/sides.h"

#include <jansson.h>
#include <stdbool.h>

struct claim {
    const char *name;   /* "edges-are-three-times-vertices": static */
    const char *source; /* documents and problem: "000, 002" */
    const char *text;   /* "E is about 3 V" */
    char mesh[32];
    double claimed, measured; /* means over the elements of the mesh where they differ */
    bool holds;
};

struct claims {
    struct claim *rows;
    int count;
    int capacity;
};

/* Adds all claims on all meshes: the real models, generated ones, and polyhedra with large faces
 * and large valences. Start with {0}; the caller owns the rows (claims_release), also after an
 * error.
 *
 * models   the folder exercises/models
 * returns  0, or -1 and *err: a model cannot be read, out of memory
 * cost     a few tenths of a second */
int claims_collect(struct claims *claims, const char *models, struct error *err) MUST_CHECK;
void claims_release(struct claims *claims);

/* The parts: ratios and vertices processed of a mesh without isolated vertices; accesses on winged
 * edges of a manifold of any polygons. Each adds its rows. Return 0, or -1 and *err. */
int claims_about_mesh(struct claims *claims, const char *name, const struct mesh *mesh,
                      struct error *err) MUST_CHECK;
int claims_about_accesses(struct claims *claims, const char *name, const struct polygons *polygons,
                          struct error *err) MUST_CHECK;

/* The sizes of problems 4.1 to 4.3, in KB of 1024 bytes, and the k from which on a mesh of the
 * sphere takes less than its voxels. Builds them; some tenths of a second. Returns 0, or -1 and
 * *err. */
int claims_about_sizes(struct claims *claims, struct error *err) MUST_CHECK;

/* The rows as in bench.json (README.md). The caller owns the array. NULL: out of memory. */
json_t *claims_to_json(const struct claims *claims);

#endif
