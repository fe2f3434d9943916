/* The topology of faces that may be anything: an answer's triangles or polygons, or an input's.
 *
 * A face is a cyclic sequence of vertices. It is *broken* when it names a vertex out of range, when
 * its offsets are wrong or it has fewer than 3 corners; broken faces are left out of everything. It
 * is *degenerate* when it names a vertex twice; such a face has no sides (reference/mesh/edges.h),
 * but it uses its vertices. The others are *proper*.
 *
 *     struct face_table faces = {NULL, triangles, triangle_count, 3 * triangle_count,
 *                                vertex_count};
 *     struct face_topology t;
 *     if (topology_build(&faces, &t, err))
 *         return -1;
 *     if (t.broken.count > 0)
 *         ... face t.broken.first, t.flaw says why ...
 *     else if (t.nonmanifold_edge.count > 0)
 *         ... t.edges[t.nonmanifold_edge.first].low and .high ...
 *     topology_release(&t);
 *
 * A corner is a place of the table of corners. A side is the step from a corner to the next one of
 * its face, and has the number of that corner. Everything is built at once: O(n log n) for n
 * corners, whatever the numbers of vertices are (66,000 unused ones cost nothing). */
#ifndef GRADERS_LIBRARY_TOPOLOGY_H
#define GRADERS_LIBRARY_TOPOLOGY_H

#include "reference/mesh/check.h"

#include <stdbool.h>
#include <stdint.h>

/* Faces as they came, borrowed. */
struct face_table {
    const int32_t *starts; /* face f: corners[starts[f]] ... corners[starts[f + 1] - 1];
                              face_count + 1 offsets; NULL: triangles, 3f ... 3f + 2 */
    const int32_t *corners;
    int64_t face_count;
    int64_t corner_count; /* numbers that `corners` really has; up to INT32_MAX */
    int32_t vertex_count; /* indices are 0 ... vertex_count - 1 */
};

/* What breaks a face. */
enum face_flaw { FACE_FINE, FACE_BAD_OFFSETS, FACE_TOO_FEW_CORNERS, FACE_INDEX_OUT_OF_RANGE };

/* An edge of proper faces, with its sides: uses[first_use] ... uses[first_use + up_count +
 * down_count - 1], by number. */
struct face_edge {
    int32_t low, high; /* low < high */
    int32_t up_count;  /* sides that run from low to high */
    int32_t down_count;
    int64_t first_use;
};

/* A vertex that some face uses, which may be degenerate. */
struct face_vertex {
    int32_t vertex;         /* its number */
    int32_t component;      /* of the faces at it; see below */
    int32_t face_count;     /* proper faces at it */
    int32_t fan_count;      /* groups of these that hang together by edges at the vertex */
    int32_t sheet_count;    /* the same by edges of just two sides: what it takes to part them */
    int32_t boundary_count; /* edges at it with one side. Without edges of more than two sides half
                               of it are open fans, and the other fans are umbrellas */
    bool is_manifold;       /* at most one fan, and no edge at it of more than two sides */
};

/* Findings (check.h) are a count and the first element. Tables may be read, not changed. */
struct face_topology {
    struct face_table table;
    enum face_flaw flaw;               /* of the first broken face */
    int64_t flaw_corner;               /* of FACE_INDEX_OUT_OF_RANGE: the corner; else -1 */
    struct finding broken;             /* faces */
    struct finding degenerate;         /* faces */
    int64_t proper_count;              /* faces */
    int32_t *corner_face;              /* of each corner: its face, if that is proper; else -1 */
    struct face_vertex *vertices;      /* by number */
    int64_t used_count;                /* of vertices[] */
    struct face_edge *edges;           /* by low, then by high */
    int64_t edge_count;                /* of edges[] */
    int32_t *uses;                     /* sides, edge after edge */
    int32_t *side_edge;                /* of each side: its edge, or -1 */
    struct finding boundary;           /* edges with one side */
    struct finding nonmanifold_edge;   /* edges with more than two */
    struct finding incoherent;         /* edges with two that run the same way */
    struct finding nonmanifold_vertex; /* `first` is an index into vertices[] */
    int32_t *component;      /* of each face, from 0 in order of their first faces: what hangs
                                together by vertices; degenerate faces join theirs. Broken: -1 */
    int64_t component_count; /* isolated vertices are none */
    int32_t *patch;          /* the same, hanging together by edges; only proper faces, else -1 */
    int64_t patch_count;
    int64_t loop_count;  /* boundary loops; see below */
    int32_t *loop_first; /* loop_count + 1 offsets into loop_vertices; NULL: see below */
    int32_t *loop_vertices;
    struct finding unorientable; /* edges that no choice of windings makes coherent, given the faces
                                    before: count 0 if the faces are orientable. Edges of more than
                                    two sides are not looked at */
};

/* Builds it all. Broken faces are no error.
 *
 * faces    counts are those of tables that are really there; NULL tables are allowed when empty
 * t        on success the caller owns it (topology_release); `faces` must outlive it
 * returns  0, or -1 and *err (out of memory, or a negative count) */
int topology_build(const struct face_table *faces, struct face_topology *t,
                   struct error *err) MUST_CHECK;

/* Frees the tables. The zero value may be released, and releasing twice does no harm. */
void topology_release(struct face_topology *t);

/* -- the whole ------------------------------------------------------------------------------ */

/* No edge of more than two sides, and at every vertex one fan or one umbrella. */
bool topology_is_manifold(const struct face_topology *t);

/* Used vertices - edges + proper faces. */
int64_t topology_euler(const struct face_topology *t);

/* Sum of the genus over the components, by V - E + F = 2 (S - G) - B; -1 where it has no meaning:
 * faces that are broken, degenerate, non-manifold or not orientable. */
int64_t topology_genus(const struct face_topology *t);

/* -- elements --------------------------------------------------------------------------------- */

/* The index of the edge {a,b}, or -1; of a used vertex, or -1. Any numbers may be asked. O(log n).
 */
int64_t topology_find_edge(const struct face_topology *t, int32_t a, int32_t b);
int64_t topology_find_vertex(const struct face_topology *t, int32_t vertex);

/* The corners of a face that is not broken: corners[first] and count - 1 more. Returns the first.
 */
int64_t topology_face(const struct face_topology *t, int64_t face, int64_t *count);

/* The next and the previous corner in a proper face; the next one is where the corner's side ends.
 */
int64_t topology_next(const struct face_topology *t, int64_t corner);
int64_t topology_previous(const struct face_topology *t, int64_t corner);

/* The other side of a side whose edge has just two; else -1. */
int64_t topology_twin(const struct face_topology *t, int64_t side);

/* Number of sides of an edge, and the face of its i-th side. */
static inline int64_t topology_side_count(const struct face_edge *edge)
{
    return (int64_t)edge->up_count + edge->down_count;
}
int32_t topology_edge_face(const struct face_topology *t, int64_t edge, int64_t i);

/* -- boundary loops ----------------------------------------------------------------------------
 *
 * A boundary edge goes on in the edge at which its fan ends on the other side, so that two fans
 * that meet at a vertex are two pieces of boundary (where more cuts into loops exist, this is one
 * of them). Each loop runs as the faces do, the surface to its left, where these are coherent, and
 * begins with the first side by number. With an edge of more than two sides there is no such order:
 * then loops are counted as groups of boundary edges that share a fan, and loop_first is NULL. */

#endif
