/* What a mesh carries, as a picture shows it: numbers as colours, parts, vectors. Each is given for
 * the mesh that the scene has (scene_set_mesh or scene_set_polygons first; setting a mesh anew
 * drops them) and copied. Numbers may be anything: what is not finite is left out of the picture.
 *
 *     static const struct phrase unit = {"mean curvature", "curvatura media"};
 *
 *     scene_set_values(scene, SCENE_PER_VERTEX, answer, low, high, unit, worst, err);
 *
 * Each returns 0, or -1 and *err: out of memory, no mesh, a range that is none. */
#ifndef GRADERS_SCENE_VALUES_H
#define GRADERS_SCENE_VALUES_H

#include "graders/scene/mark.h"
#include "reference/base/error.h"

enum scene_part { SCENE_PER_VERTEX, SCENE_PER_FACE };

struct scene_values {
    float *numbers; /* NULL: none */
    enum scene_part part;
    int64_t count;
    double low, high, worst; /* worst is NaN when none is named */
    struct scene_text unit;
};

enum { SCENE_VECTORS_LIMIT = 2, SCENE_NO_GROUP = 255 };

struct scene_vectors {
    enum mark_kind kind;
    float *xyz; /* three a vertex */
};

/* Colours the surface by a number a vertex or a face, on a scale from low to high (low <= high)
 * with a bar that tells them and the unit. Values beyond the scale have the colour of its end;
 * those that are not finite are grey.
 *
 * worst    the vertex or face that the verdict names, -1: none. It is marked as MARK_WRONG, which
 *          the legend then calls "worst" unless it was named before, and its value stands at the
 *          bar. Set the values before other marks, so that this one is the first. */
int scene_set_values(struct scene *scene, enum scene_part part, const float *values, double low,
                     double high, struct phrase unit, int64_t worst, struct error *err) MUST_CHECK;

/* Colours each face by the number of the part that it belongs to, in turn colours; negative: none.
 * For partitions of a whole mesh: marks would be thinned out. scene_name_turns names the parts. */
int scene_set_groups(struct scene *scene, const int32_t *group_of_face,
                     struct error *err) MUST_CHECK;

/* A vector at each vertex, in the colour of a kind: what the answer says (MARK_WRONG) and what
 * would be right (MARK_RIGHT), say. All vectors of a picture have one scale; where vertices lie
 * close together, pictures show some. At most SCENE_VECTORS_LIMIT sets. */
int scene_add_vectors(struct scene *scene, enum mark_kind kind, const float *vectors,
                      struct error *err) MUST_CHECK;

/* Forgets values, groups and vectors. */
void scene_drop_values(struct scene *scene);

#endif
