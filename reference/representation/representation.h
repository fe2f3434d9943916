/* One mesh representation as tests and comparisons see it: what it is called, what it can hold,
 * what it costs, and a function for each operation. Every representation stands in a pair of files
 * of its own name here; its header is the lesson, its .c defines one of these:
 *
 *     const struct representation representation_half_edge = {
 *         .order = 90,
 *         ...
 *
 * and the build collects them, by these two lines, into representation_table: adding a
 * representation adds its two files and edits none.
 *
 * `self` is always the representation's own struct (struct half_edge), as its header shows it,
 * which `build` has filled. No function but `build` and `transform`, `smooth` changes it.
 *
 * Faces are numbered from 0 to face_count - 1 and vertices from 0 to vertex_count - 1; to_mesh
 * keeps both numberings. Only where vertices are not shared (vertex_names is not NULL) one vertex
 * of to_mesh's mesh has several numbers here: arguments may be any of them, answers are the lowest
 * (but face_vertices gives the face's own).
 *
 * An edge is a pair of different vertices that follow each other in a face; a side is an
 * edge as one face runs through it. A degenerate face (two corners the same vertex) has no sides
 * ("of the surface" in reference/mesh/edges.h). A boundary edge has one side.
 *
 * Where a structure lacks the link that a query wants, the query is done by search, as the course
 * does it, and `cost` says so. Operations return what stands with them; those with an `err` return
 * -1 and *err when memory runs out. Output tables are the caller's. */
#ifndef REFERENCE_REPRESENTATION_REPRESENTATION_H
#define REFERENCE_REPRESENTATION_REPRESENTATION_H

#include "reference/mesh/check.h"
#include "reference/mesh/mesh.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What a mesh may have and a representation may be unable to hold: `build` refuses what is not in
 * `holds`. Duplicate triangles count as what they make of their edges. */
enum mesh_feature {
    FEATURE_BOUNDARY = 1,            /* an edge with one side */
    FEATURE_ISOLATED_VERTEX = 2,     /* in no triangle */
    FEATURE_DEGENERATE_TRIANGLE = 4, /* two corners are the same vertex */
    FEATURE_INCOHERENT_EDGE = 8,     /* its two sides run the same way */
    FEATURE_NONMANIFOLD_EDGE = 16,   /* more than two sides */
    FEATURE_NONMANIFOLD_VERTEX = 32, /* its faces are more than one fan or umbrella */
    FEATURE_ALL = 63
};

/* Queries about one element, for `cost`. */
enum query {
    QUERY_FACE_VERTICES,
    QUERY_FACE_NEIGHBOURS,
    QUERY_FACES_AROUND_VERTEX,
    QUERY_VERTICES_AROUND_VERTEX,
    QUERY_IS_EDGE,
    QUERY_COUNT
};

/* The numbers that the bytes of a representation depend on. */
struct mesh_counts {
    int64_t vertices, edges, triangles;
    int64_t boundary_edges;
    int64_t strips;         /* strips or fans; 0 where there are none */
    int64_t strip_vertices; /* entries of all of them */
};

/* A table of a representation: where in its struct the pointer to it stands, and what a row of it
 * takes. A row is what one access reads (a half edge, a triangle's corners, a position). */
struct table_place {
    size_t offset, row_bytes;
};
enum { REPRESENTATION_TABLES_MAX = 4 };

struct representation {
    int order;             /* place in the table, by the course's order: 10, 20, ... */
    const char *name;      /* "half-edge": for options and file names */
    const char *title;     /* "Half edge" */
    const char *documents; /* course documents that define it: "000, 004", or "-" */
    size_t struct_bytes;   /* sizeof its struct */
    unsigned holds;        /* enum mesh_feature bits */

    /* Accesses that each query takes: "1", "k" (valence of the vertex, or sides of the face),
     * "k^2", "lg s" (s strips), "n" (all faces or all edges are looked at). */
    const char *cost[QUERY_COUNT];

    /* All its tables, for those who count accesses (bench/compare/counted_reads.h); the rest of the
     * entries are 0. */
    struct table_place tables[REPRESENTATION_TABLES_MAX];

    /* faces_around_vertex and vertices_around_vertex go around the vertex counter-clockwise; where
     * there is a boundary, from its one end to the other. Otherwise: any order. */
    bool rings_in_order;

    /* -- life -------------------------------------------------------------------------------- */

    /* Makes it from a valid mesh (mesh_check). Old contents of *self are not looked at. Expected
     * linear time. Returns 0, or -1 and *err (naming the vertex, edge or triangle that cannot be
     * held); then *self is as after release. */
    int (*build)(void *self, const struct mesh *mesh, struct error *err);

    /* Frees its tables and leaves it zeroed. A zeroed one may be released, any number of times. */
    void (*release)(void *self);

    /* Its invariants, for any contents of its tables (of the right lengths). Returns 0, or -1 and
     * *err naming the element at fault. */
    int (*check)(const void *self, struct error *err);

    /* The indexed mesh; the caller owns it. Corner order: face_vertices. Returns 0, or -1 and *err.
     */
    int (*to_mesh)(const void *self, struct mesh *mesh, struct error *err);

    /* -- size -------------------------------------------------------------------------------- */

    int32_t (*vertex_count)(const void *self);
    int32_t (*face_count)(const void *self);

    /* Bytes of its tables, as they are; and the same by formula, linear in the counts. */
    int64_t (*bytes)(const void *self);
    int64_t (*formula_bytes)(const struct mesh_counts *counts);

    /* Fills strips and strip_vertices. NULL: it has neither strips nor fans. */
    void (*count_strips)(const void *self, struct mesh_counts *counts);

    /* Lowest number here of each vertex of `mesh`, which to_mesh made; mesh->vertex_count entries.
     * NULL: numbers are the same. Returns 0, or -1 and *err. */
    int (*vertex_names)(const void *self, const struct mesh *mesh, int32_t *names,
                        struct error *err);

    /* -- sweeps ------------------------------------------------------------------------------ */

    /* p becomes A p + b for every position; matrix holds the rows (A | b), 3 x 4. Returns how many
     * positions were processed: where vertices are not shared, more than the mesh has. */
    int64_t (*transform)(void *self, const float matrix[12]);

    /* Sum of the areas, added in double. */
    double (*area)(const void *self);

    /* Unit normal of each face, 3 floats each; zero where a face has no area. */
    void (*face_normals)(const void *self, float *normals);

    /* Unit normal of each vertex: direction of the sum of its faces' area vectors; zero where that
     * sum is zero. 3 * vertex_count floats. Returns 0, or -1 and *err. */
    int (*vertex_normals)(const void *self, float *normals, struct error *err);

    /* Every edge once, in any order, smaller number first; room for 2 * 3 * face_count numbers
     * suffices. Returns how many, or -1 and *err. */
    int64_t (*edges)(const void *self, int32_t *pairs, struct error *err);

    /* The boundary edges as closed walks, each edge once, the way its face runs (as far as faces
     * are coherent). Loop i is vertices[loop_starts[i]] ... vertices[loop_starts[i + 1] - 1]. Loops
     * that touch in a vertex may come as one.
     *
     * vertices     room for as many numbers as there are boundary edges
     * loop_starts  room for one more than that
     * returns      number of loops, or -1 and *err, also when an edge has more than two sides: then
     *              the boundary edges need not close */
    int32_t (*boundary_loops)(const void *self, int32_t *vertices, int32_t *loop_starts,
                              struct error *err);

    /* One step of uniform Laplacian smoothing: each vertex moves to the mean of the vertices that
     * share an edge with it, all at once. Ends of boundary edges and isolated vertices stay.
     * Returns 0, or -1 and *err. */
    int (*smooth)(void *self, struct error *err);

    /* -- queries ----------------------------------------------------------------------------- */

    /* Corners, 3 each and counter-clockwise, of the `count` faces from `first` on. */
    void (*face_vertices)(const void *self, int32_t first, int32_t count, int32_t *corners);

    /* neighbours[i]: a face on the other side of the edge from corner i to corner i + 1, the lowest
     * when there are several; -1 where there is none. Returns how many sides have one. */
    int32_t (*face_neighbours)(const void *self, int32_t face, int32_t neighbours[3]);

    /* Faces that have the vertex as a corner, each once; degenerate ones too. Writes at most
     * `capacity` and returns how many there are. */
    int32_t (*faces_around_vertex)(const void *self, int32_t vertex, int32_t *faces,
                                   int32_t capacity);

    /* Vertices that share an edge with the vertex, each once. Writes at most `capacity` and returns
     * how many there are, or -1 when memory for a search runs out. */
    int32_t (*vertices_around_vertex)(const void *self, int32_t vertex, int32_t *vertices,
                                      int32_t capacity);

    /* Whether u and v share an edge. */
    bool (*is_edge)(const void *self, int32_t u, int32_t v);
};

/* All of them, by order; ends with NULL. Made by the build from what stands in this folder. */
extern const struct representation *const representation_table[];

/* The one of that name, or NULL. */
const struct representation *representation_find(const char *name);

/* Builds into memory of its own, which the caller owns (representation_delete). Returns 0, or -1,
 * *err and *self NULL. */
int representation_new(const struct representation *kind, void **self, const struct mesh *mesh,
                       struct error *err) MUST_CHECK;
void representation_delete(const struct representation *kind, void *self); /* NULL allowed */

/* Features of a mesh, from its topology (mesh_topology): it can be held when `holds` has them all. */
unsigned mesh_features(const struct topology *topology);

/* Counts of a mesh from its topology; strips and strip_vertices from `self` when it has any. */
struct mesh_counts representation_counts(const struct representation *kind, const void *self,
                                         const struct topology *topology);

/* Writes the memory formula as text, such as "12 V + 12 F", with V vertices, E edges, F triangles,
 * B boundary edges, S strips or fans, N entries of them. `capacity` bytes, cut when too short. */
void representation_formula(const struct representation *kind, char *text, size_t capacity);

#endif
