/* Meshes as inputs of cases: made from the numbers in a case, written as a packet, read back.
 *
 * Shared by the judges whose exercises take an indexed mesh. Packet:
 *
 *     int vertex_count, int triangle_count, float positions[3V], int32 triangles[3F] */
#ifndef GRADERS_LIBRARY_MESH_CASE_H
#define GRADERS_LIBRARY_MESH_CASE_H

#include "graders/judges/judge.h"

/* A case's parameter[0]; a and b are its parameter[1] and parameter[2]. */
enum mesh_shape {
    SHAPE_EMPTY,
    SHAPE_ONE_TRIANGLE,
    SHAPE_TETRAHEDRON,
    SHAPE_CUBE,
    SHAPE_GRID,            /* a rows, b columns */
    SHAPE_UV_SPHERE,       /* a meridians, b parallels */
    SHAPE_ICO,             /* a levels */
    SHAPE_TORUS,           /* genus a, about b triangles */
    SHAPE_DISC,            /* a rings, b sectors */
    SHAPE_FAN,             /* a triangles */
    SHAPE_BIPYRAMID,       /* valence a */
    SHAPE_MOEBIUS,         /* a quads */
    SHAPE_TWO_CONES,       /* a sectors */
    SHAPE_TWO_CUBES,       /* which share an edge */
    SHAPE_ROUND_AN_EDGE,   /* a closed tetrahedra that all share one edge */
    SHAPE_NEEDLES,         /* a triangles, as high as the base / 10^b */
    SHAPE_ISOLATED,        /* a vertices and no triangle */
    SHAPE_POINT_TRIANGLES, /* a triangles (v,v,v) on as many vertices */
    SHAPE_BUNNY,           /* models that come with the project: open, two boundary loops */
    SHAPE_HORSE,           /* closed, no handle */
    SHAPE_MUG              /* closed, one handle */
};

/* A case's parameter[3]: what is done to the shape, in this order. Numbers of elements are a
 * fraction of the mesh's, at least one. */
enum mesh_change {
    WITH_HOLES = 1 << 0,      /* 1/16 of the triangles removed */
    WITH_COMPONENTS = 1 << 1, /* a tetrahedron, a cube and an icosphere appended */
    WITH_ISOLATED = 1 << 2,   /* a quarter more vertices */
    WITH_DUPLICATES = 1 << 3, /* 1/8 of the triangles listed twice */
    WITH_DEGENERATE = 1 << 4, /* 1/8 more, on edges that are there already */
    WITH_COLLINEAR = 1 << 5,  /* 1/8 more (a,m,b), m a new vertex halfway from a to b */
    WITH_SPIKES = 1 << 6,     /* 1/8 more (a,a,b), each with an edge of its own */
    FLIPPED = 1 << 7,         /* each triangle reversed with probability 1/2 */
    REVERSED = 1 << 8,
    TILTED = 1 << 9,     /* turned by 1 radian around (1,2,3), so that no side lies along an axis */
    TINY = 1 << 10,      /* scaled by 2^-40, about 10^-12 */
    HUGE_SIZE = 1 << 11, /* scaled by 2^40 */
    FAR = 1 << 12,       /* scaled by 32 and moved by (10^6, -10^6, 10^6) */
    SCRAMBLED = 1 << 13,
    ADVERSARIAL = 1 << 14,
    HIGH_NUMBERS = 1 << 15 /* 66,000 unused vertices before all others: a part of a large mesh */
};

/* Makes the mesh of a case.
 *
 * mesh      on success the caller owns it
 * models    folder with the models; NULL when the shape is none of them
 * returns   0, or -1 and *err */
int mesh_case_make(const struct judge_case *c, const char *models, struct mesh *mesh,
                   struct error *err) MUST_CHECK;

/* Writes a mesh as a packet. Returns 0, or -1 and *err when memory ran out. */
int mesh_case_write(const struct mesh *mesh, struct writer *input, struct error *err) MUST_CHECK;

/* mesh_case_make and mesh_case_write in one: what many judges have as `make`. */
int mesh_case_write_input(const struct judge_case *c, const char *models, struct writer *input,
                          struct error *err);

/* A mesh in a packet, in place. */
struct mesh_view {
    const float *positions;
    const int32_t *triangles;
    int32_t vertex_count;
    int32_t triangle_count;
};

/* Reads a packet that mesh_case_write wrote; borrowed from it. */
struct mesh_view mesh_case_read(struct span input);

/* Makes the mesh of a scene. Returns 0, or -1 and *err. */
int mesh_case_show(const struct mesh_view *view, struct scene *scene, struct error *err);

#endif
