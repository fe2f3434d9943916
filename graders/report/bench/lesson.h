/* What the pictures that teach share: scenes of kind "diagram" and points in space. */
#ifndef GRADERS_REPORT_BENCH_LESSON_H
#define GRADERS_REPORT_BENCH_LESSON_H

#include "graders/report/bench/figures.h"

#include "reference/mesh/mesh.h"

struct place {
    double x, y, z;
};

/* A vertex of a table of positions. */
struct place lesson_vertex(const float *positions, int32_t vertex);

/* a + t (b - a). */
struct place lesson_between(struct place a, struct place b, double t);

/* A scene that shows the mesh, with empty "faces", "arrows" and "labels"; NULL: out of memory. */
json_t *lesson_diagram(const struct mesh *mesh, const char *title, const char *subtitle);

/* Add to it. The label may be "". */
void lesson_face(json_t *scene, int32_t triangle, enum look look);
void lesson_arrow(json_t *scene, struct place from, struct place to, enum look look,
                  const char *label, bool dashed);
void lesson_label(json_t *scene, struct place at, enum look look, const char *text);

/* Two rings of triangles around a vertex with `sectors` edges, domed, in scrambled order: a
 * neighbourhood to draw in. The caller owns it. Returns 0, or -1 when memory runs out. */
int lesson_dome(struct mesh *mesh, int sectors);

/* The vertex in its middle. */
int32_t lesson_middle(const struct mesh *dome);

#endif
