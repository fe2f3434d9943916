/* Faults of triangles in space: flat ones, and those that run through each other; see faults.h. */
#include "reference/survey/crossing.h"
#include "reference/survey/exact.h"
#include "reference/survey/faults.h"

#include <stdlib.h>
#include <string.h>

static const float *corner_of(const struct mesh *mesh, int64_t triangle, int i)
{
    return mesh->positions + 3 * (int64_t)mesh->triangles[3 * triangle + i];
}

/* Whether the three corners of the triangle lie on a line. */
static bool is_flat(const struct mesh *mesh, int64_t triangle)
{
    return exact_on_line(corner_of(mesh, triangle, 0), corner_of(mesh, triangle, 1),
                         corner_of(mesh, triangle, 2));
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

/* Triangles by their places on the tree's curve, so that neighbours lie together whatever the numbering
 * is. */
struct placed_triangle {
    float corner[3][3];
    int32_t number;
};

struct crossing_search {
    const struct mesh *mesh;
    const struct placed_triangle *placed;
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
static bool same_three_vertices(const struct mesh *mesh, int32_t one, int32_t other)
{
    const int32_t *a = mesh->triangles + 3 * (int64_t)one;
    const int32_t *b = mesh->triangles + 3 * (int64_t)other;
    return has_vertex(a, b[0]) && has_vertex(a, b[1]) && has_vertex(a, b[2]);
}

static bool look_at_pair(void *context, int32_t one_place, int32_t other_place)
{
    struct crossing_search *search = context;
    const struct placed_triangle *a = &search->placed[one_place];
    const struct placed_triangle *b = &search->placed[other_place];
    const float *p[3] = {a->corner[0], a->corner[1], a->corner[2]};
    const float *q[3] = {b->corner[0], b->corner[1], b->corner[2]};
    int32_t low = a->number < b->number ? a->number : b->number;
    int32_t high = a->number < b->number ? b->number : a->number;
    if (triangles_cross(p, q) && !same_three_vertices(search->mesh, low, high))
        search->result =
            survey_note(search->fault, (struct survey_element){{low, high, -1, -1}}, search->err);
    return search->result == 0 && ++search->looked < search->limit;
}

/* Boxes of the triangles that have an inside; `triangles` becomes their numbers. */
static int32_t fill_boxes(const struct mesh *mesh, struct bounds *boxes, int32_t *triangles)
{
    int32_t count = 0;
    for (int32_t t = 0; t < mesh->triangle_count; t++) {
        if (is_flat(mesh, t))
            continue;
        boxes[count] = bounds_empty();
        for (int i = 0; i < 3; i++)
            bounds_include(&boxes[count], corner_of(mesh, t, i));
        triangles[count++] = t;
    }
    return count;
}

static int build_tree(struct box_tree *tree, const struct mesh *mesh, int32_t *triangles,
                      struct error *err)
{
    struct bounds *boxes = malloc(((size_t)mesh->triangle_count + 1) * sizeof *boxes);
    if (!boxes)
        return error_set(err, "out of memory: boxes of triangles");
    int result = box_tree_build(tree, boxes, fill_boxes(mesh, boxes, triangles), err);
    free(boxes);
    return result;
}

static void place_triangles(const struct box_tree *tree, const struct mesh *mesh,
                            const int32_t *triangles, struct placed_triangle *placed)
{
    for (int32_t place = 0; place < tree->count; place++) {
        placed[place].number = triangles[tree->items[place]];
        for (int i = 0; i < 3; i++)
            memcpy(placed[place].corner[i], corner_of(mesh, placed[place].number, i),
                   sizeof placed[place].corner[i]);
    }
}

int survey_find_crossings(struct mesh_survey *survey, const struct mesh *mesh, int64_t pair_limit,
                          struct error *err)
{
    size_t room = (size_t)mesh->triangle_count + 1;
    int32_t *triangles = malloc(room * sizeof *triangles);
    struct placed_triangle *placed = malloc(room * sizeof *placed);
    struct box_tree tree = {0};
    int result =
        triangles && placed ? 0 : error_set(err, "out of memory: triangles by their places");
    if (result == 0)
        result = build_tree(&tree, mesh, triangles, err);
    if (result == 0) {
        place_triangles(&tree, mesh, triangles, placed);
        struct crossing_search search = {.mesh = mesh,
                                         .placed = placed,
                                         .fault = &survey->faults[SURVEY_CROSSING],
                                         .err = err,
                                         .limit = pair_limit};
        box_tree_find_pairs(&tree, look_at_pair, &search);
        survey->is_cut[SURVEY_CROSSING] = search.looked >= search.limit;
        survey->crossings_were_searched = true;
        result = search.result;
    }
    box_tree_release(&tree);
    free(placed);
    free(triangles);
    return result;
}
