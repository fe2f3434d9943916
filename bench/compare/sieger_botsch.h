/* The benchmark of a paper: D. Sieger, M. Botsch, "Design, Implementation, and Evaluation of the
 * Surface_mesh Data Structure", 20th International Meshing Roundtable, 2011. Its six operations, as
 * the paper's own test program does them, on our half edges, our winged edges, and an indexed mesh
 * with the faces and the neighbours of each vertex in two compressed rows (CSR).
 *
 *     circulator    faces around every vertex, vertices around every face
 *     barycentre    moves the mesh so that the mean of its vertices is the origin
 *     normals       unit normals of the faces; of each vertex, the unit sum of its faces' normals
 *     smoothing     each vertex inside goes to the mean of its neighbours, one after another in the
 *                   order of their numbers, each seeing those moved before
 *     subdivision   one step of sqrt(3) subdivision (Kobbelt 2000): faces split in three at their
 *                   centroids, old vertices inside smoothed, old edges flipped
 *     collapse      splits every face in three at the origin, collapses every new vertex onto the
 *                   first corner of its face again, and drops what was removed
 *
 * Where we differ from the paper: its circulator counts up and down by one, which a compiler can do
 * without the walk where rows are contiguous; ours adds the numbers of what it meets. The indexed
 * mesh has no local edits: it makes the new tables at once, rows included, which is how one uses
 * it. */
#ifndef BENCH_COMPARE_SIEGER_BOTSCH_H
#define BENCH_COMPARE_SIEGER_BOTSCH_H

#include "reference/mesh/mesh.h"

#include <stddef.h>
#include <stdint.h>

enum paper_operation {
    PAPER_CIRCULATOR,
    PAPER_BARYCENTRE,
    PAPER_NORMALS,
    PAPER_SMOOTHING,
    PAPER_SUBDIVISION,
    PAPER_COLLAPSE,
    PAPER_OPERATION_COUNT
};

/* "circulator", ... */
extern const char *const paper_operation_names[PAPER_OPERATION_COUNT];

/* One structure with its operations. `self` is its own struct, of struct_bytes, zeroed at first. */
struct paper_structure {
    const char *name;  /* "half-edge", "winged-edge", "indexed-csr" */
    const char *title; /* for people */
    size_t struct_bytes;
    int (*build)(void *self, const struct mesh *mesh, struct error *err);
    void (*release)(void *self); /* leaves it zeroed */
    int64_t (*circulate)(const void *self);
    void (*centre)(void *self);
    void (*normals)(void *self);
    void (*smooth)(void *self);
    int (*subdivide)(void *self, struct error *err);
    int (*collapse)(void *self, struct error *err); /* the splits before it included */
    int (*to_mesh)(const void *self, struct mesh *mesh, struct error *err);
    const float *(*vertex_normals)(const void *self); /* 3 a vertex, from the last `normals` */
};

/* All of them; ends with NULL. */
extern const struct paper_structure *const paper_structures[];

/* The one of that name, or NULL. */
const struct paper_structure *paper_structure_find(const char *name);

/* A structure on a mesh, ready to run. */
struct paper_run {
    const struct paper_structure *structure;
    const struct mesh *mesh; /* as it was, borrowed */
    void *self;
    int64_t sum; /* of the last circulator */
};

/* Builds the structure on a manifold mesh of triangles, which must outlive the run. The caller owns
 * it (paper_close). Returns 0, or -1 and *err: the mesh cannot be held, out of memory. */
int paper_open(struct paper_run *run, const struct paper_structure *structure,
               const struct mesh *mesh, struct error *err) MUST_CHECK;
void paper_close(struct paper_run *run);

/* Does one operation: what is to be measured. Returns 0, or -1 and *err (out of memory). */
int paper_do(struct paper_run *run, enum paper_operation operation, struct error *err) MUST_CHECK;

/* Puts the mesh back as it was where the operation has changed its connectivity; moved vertices
 * stay where they are. Returns 0, or -1 and *err. */
int paper_undo(struct paper_run *run, enum paper_operation operation, struct error *err) MUST_CHECK;

/* What the operations leave, to be held against another structure's on the same mesh. The mesh is
 * the caller's (mesh_release); normals are borrowed, 3 a vertex, NULL before the first
 * PAPER_NORMALS. Returns 0, or -1 and *err. */
int paper_result(const struct paper_run *run, struct mesh *mesh, const float **vertex_normals,
                 struct error *err) MUST_CHECK;

/* Weight of the mean of n neighbours in sqrt(3) subdivision: (4 - 2 cos(2 pi / n)) / 9. */
double paper_sqrt3_weight(int32_t n);

#endif
