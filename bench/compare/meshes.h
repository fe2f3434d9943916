/* The meshes that comparisons run on, by name: "torus-100k-scrambled",
 *
 *     KIND-SIZE-ORDER
 *
 * or by a file's path, which ends with .ply, .obj or .off: then the name is the file's, with a hash of what
 * is in it, "dragon-1f3a9c07", so that results of another mesh are never taken for its own.
 *
 * Regular grids in the order of their making flatter branchy code 5 to 10 times, so there are real
 * models, and every mesh also scrambled. Flipped ones are for kernels that take any orientation. */
#ifndef BENCH_COMPARE_MESHES_H
#define BENCH_COMPARE_MESHES_H

#include "reference/base/error.h"
#include "reference/formats/reading.h"
#include "reference/mesh/mesh.h"

#include <limits.h>

#include <stdbool.h>
#include <stdint.h>

enum mesh_kind {
    MESH_GRID,      /* open, square, waved */
    MESH_DISC,      /* open, one vertex of high valence in the middle */
    MESH_UV_SPHERE, /* two poles of high valence */
    MESH_TORUS,     /* valence 6 everywhere */
    MESH_ICOSPHERE, /* the nearest level: 20 * 4^n triangles */
    MESH_BIPYRAMID, /* two vertices of valence n / 2 */
    MESH_BUNNY,     /* real, open; subdivided flatly to the size, as are the next */
    MESH_HORSE,     /* real, closed */
    MESH_MUG,       /* real, closed, genus 1 */
    MESH_KIND_COUNT,
    MESH_FILE = MESH_KIND_COUNT /* anyone's, as it is */
};

enum mesh_order {
    MESH_GENERATED, /* as the generator or file gives them */
    MESH_SCRAMBLED, /* vertices renumbered, triangles permuted and rotated, seeded */
    MESH_CACHE,     /* triangles and then vertices in an order for the vertex cache */
    MESH_FLIPPED,   /* as generated, but each triangle turned over or not at random, seeded: no
                       coherent orientation */
    MESH_ORDER_COUNT
};

struct bench_mesh {
    enum mesh_kind kind;
    enum mesh_order order;
    int64_t triangles; /* wanted; the mesh comes as near as its kind can */
    /* Of a file. */
    char path[PATH_MAX], label[40];
    bool is_irregular;      /* not coherent, not manifold, or with degenerate triangles */
    struct reading reading; /* what was left out */
};

const char *mesh_kind_name(enum mesh_kind kind);
const char *mesh_order_name(enum mesh_order order);

/* Whether meshes of that kind are closed (all but flipped ones are coherently oriented). */
bool mesh_kind_is_closed(enum mesh_kind kind);

/* Writes the name: at most `capacity` bytes, 48 suffice. */
void bench_mesh_name(const struct bench_mesh *which, char *name, int capacity);

/* The mesh of that name; sizes are digits with or without k or M. A file is read to be looked at. Returns
 * 0, or -1 and *err, which tells what there is. */
int bench_mesh_find(const char *name, struct bench_mesh *which, struct error *err) MUST_CHECK;

/* Makes it; the caller owns it.
 *
 * models   the folder exercises/models, read for real ones
 * returns  0, or -1 and *err */
int bench_mesh_make(const struct bench_mesh *which, const char *models, struct mesh *mesh,
                    struct error *err) MUST_CHECK;

#endif
