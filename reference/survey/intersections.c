/* Faults of triangles in space: flat ones, and those that run through each other; see faults.h. */
#include "reference/survey/crossing.h"
#include "reference/survey/exact.h"
#include "reference/survey/faults.h"

#include <stdlib.h>

static void corners_of(const struct mesh *mesh, int64_t triangle, const float *corners[3])
{
    for (int i = 0; i < 3; i++)
        corners[i] = mesh->positions + 3 * (int64_t)mesh->triangles[3 * triangle + i];
}

/* Whether the triangle names three vertices and they lie on a line. */
static bool is_flat(const struct mesh *mesh, int64_t triangle)
{
    const float *p[3];
    corners_of(mesh, triangle, p);
    return exact_on_line(p[0], p[1], p[2]);
}

int survey_find_flat(struct mesh_survey *survey, const struct mesh *mesh, struct error *err)
{
    for (int32_t t = 0; t < mesh->triangle_count; t++)
        if (!triangle_is_degenerate(mesh->triangles + 3 * (int64_t)t) && is_flat(mesh, t) &&
            survey_note(&survey->faults[SURVEY_FLAT], (struct survey_element){{t, -1, -1, -1}},
                        err))
            return -1;
    return 0;
}

/* -- crossings -------------------------------------------------------------------------------- */

struct crossing_search {
    const struct mesh *mesh;
    const int32_t *triangles; /* of each box */
    struct survey_fault *fault;
    struct error *err;
    int64_t looked, limit;
    int result;
};

static bool has_vertex(const int32_t *triangle, int32_t vertex)
{
    return triangle[0] == vertex || triangle[1] == vertex || triangle[2] == vertex;
}

/* Neither is degenerate. */
static bool same_three_vertices(const int32_t *a, const int32_t *b)
{
    return has_vertex(a, b[0]) && has_vertex(a, b[1]) && has_vertex(a, b[2]);
}

static bool look_at_pair(void *context, int32_t one_box, int32_t other_box)
{
    struct crossing_search *search = context;
    const struct mesh *mesh = search->mesh;
    int32_t one = search->triangles[one_box], other = search->triangles[other_box];
    const float *p[3], *q[3];
    corners_of(mesh, one, p);
    corners_of(mesh, other, q);
    if (triangles_cross(p, q) && !same_three_vertices(mesh->triangles + 3 * (int64_t)one,
                                                      mesh->triangles + 3 * (int64_t)other))
        search->result =
            survey_note(search->fault, (struct survey_element){{one, other, -1, -1}}, search->err);
    return search->result == 0 && ++search->looked < search->limit;
}

/* Boxes of the triangles that have an inside; `triangles` becomes their numbers. */
static int32_t fill_boxes(const struct mesh *mesh, struct bounds *boxes, int32_t *triangles)
{
    int32_t count = 0;
    for (int32_t t = 0; t < mesh->triangle_count; t++) {
        if (is_flat(mesh, t))
            continue;
        const float *p[3];
        corners_of(mesh, t, p);
        boxes[count] = bounds_empty();
        for (int i = 0; i < 3; i++)
            bounds_include(&boxes[count], p[i]);
        triangles[count++] = t;
    }
    return count;
}

int survey_find_crossings(struct mesh_survey *survey, const struct mesh *mesh, int64_t pair_limit,
                          struct error *err)
{
    size_t room = (size_t)mesh->triangle_count + 1;
    struct bounds *boxes = malloc(room * sizeof *boxes);
    int32_t *triangles = malloc(room * sizeof *triangles);
    struct box_tree tree = {0};
    int result = boxes && triangles ? 0 : error_set(err, "out of memory: boxes of triangles");
    if (result == 0)
        result = box_tree_build(&tree, boxes, fill_boxes(mesh, boxes, triangles), err);
    free(boxes);
    if (result == 0) {
        struct crossing_search search = {.mesh = mesh,
                                         .triangles = triangles,
                                         .fault = &survey->faults[SURVEY_CROSSING],
                                         .err = err,
                                         .limit = pair_limit};
        box_tree_find_pairs(&tree, look_at_pair, &search);
        survey->is_cut[SURVEY_CROSSING] = search.looked >= search.limit;
        survey->crossings_were_searched = true;
        result = search.result;
    }
    box_tree_release(&tree);
    free(triangles);
    return result;
}
