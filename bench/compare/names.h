/* Names of a representation's vertices and faces that do not depend on how it numbers them, so that
 * answers of different representations of one mesh can be compared: see answers.h. */
#ifndef BENCH_COMPARE_NAMES_H
#define BENCH_COMPARE_NAMES_H

#include "reference/representation/representation.h"

struct names {
    struct mesh mesh;   /* of to_mesh */
    uint64_t *points;   /* name of each of its vertices, by its position */
    int32_t *numbers;   /* number here of each of its vertices */
    uint64_t *vertices; /* name of each number here; 0: another number stands for the vertex */
    uint64_t *faces;    /* name of each face, by its corners' names */
    int32_t vertex_count, face_count; /* here */
};

/* Fills them; the caller owns them (names_release). Returns 0, or -1 and *err: out of memory. */
int names_of(struct names *names, const struct representation *kind, const void *self,
             struct error *err) MUST_CHECK;
void names_release(struct names *names); /* a zeroed one may be released */

/* The number here of the vertex or face of that name, -1 when there is none. Cost: linear. */
int32_t names_vertex(const struct names *names, uint64_t name);
int32_t names_face(const struct names *names, uint64_t name);

/* The name of a triangle of a mesh. */
uint64_t names_triangle(const struct mesh *mesh, int32_t triangle);

#endif
