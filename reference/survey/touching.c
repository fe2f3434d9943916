/* Faults of the boundary in space: cracks, and vertices on edges; see faults.h. */
#include "reference/survey/faults.h"

#include <math.h>
#include <stdlib.h>

/* The boundary edges of a mesh, by their indices in list->edges. */
struct boundary {
    const struct mesh *mesh;
    const struct edge_list *list;
    int64_t *edges;
    int64_t count;
};

static int collect_boundary(struct boundary *boundary, const struct mesh *mesh,
                            const struct edge_list *list, int64_t count, struct error *err)
{
    *boundary = (struct boundary){mesh, list, malloc(((size_t)count + 1) * sizeof(int64_t)), 0};
    if (!boundary->edges)
        return error_set(err, "out of memory: %lld boundary edges", (long long)count);
    for (int64_t e = 0; e < list->edge_count; e++)
        if (edge_use_count(&list->edges[e]) == 1)
            boundary->edges[boundary->count++] = e;
    return 0;
}

static const struct edge *boundary_edge(const struct boundary *boundary, int64_t i)
{
    return &boundary->list->edges[boundary->edges[i]];
}

static const float *point_of(const struct boundary *boundary, int32_t vertex)
{
    return boundary->mesh->positions + 3 * (int64_t)vertex;
}

/* -- cracks ----------------------------------------------------------------------------------- */

/* An edge by the places of its ends, the lesser place first. */
struct placed_edge {
    float end[6];
    int32_t low, high; /* its vertices */
};

/* As numbers: 0 and -0 are equal. */
static int compare_places(const float *a, const float *b, int count)
{
    for (int i = 0; i < count; i++)
        if (a[i] != b[i])
            return a[i] < b[i] ? -1 : 1;
    return 0;
}

static int by_places(const void *left, const void *right)
{
    const struct placed_edge *a = left, *b = right;
    int order = compare_places(a->end, b->end, 6);
    if (order == 0)
        order = (a->low > b->low) - (a->low < b->low);
    return order != 0 ? order : (a->high > b->high) - (a->high < b->high);
}

static struct placed_edge place_edge(const struct boundary *boundary, int64_t i)
{
    const struct edge *edge = boundary_edge(boundary, i);
    const float *a = point_of(boundary, edge->low), *b = point_of(boundary, edge->high);
    struct placed_edge placed = {.low = edge->low, .high = edge->high};
    bool is_turned = compare_places(a, b, 3) > 0;
    for (int axis = 0; axis < 3; axis++) {
        placed.end[axis] = is_turned ? b[axis] : a[axis];
        placed.end[3 + axis] = is_turned ? a[axis] : b[axis];
    }
    return placed;
}

/* Each edge of a group of one place is told with the next one, the last with the first. */
static int note_cracks(struct survey_fault *fault, const struct placed_edge *group, int64_t count,
                       struct error *err)
{
    bool has_length = compare_places(group->end, group->end + 3, 3) != 0;
    for (int64_t i = 0; has_length && count > 1 && i < count; i++) {
        const struct placed_edge *other = &group[(i + 1) % count];
        if (survey_note(
                fault,
                (struct survey_element){{group[i].low, group[i].high, other->low, other->high}},
                err))
            return -1;
    }
    return 0;
}

static int note_groups(struct survey_fault *fault, const struct placed_edge *edges, int64_t count,
                       struct error *err)
{
    for (int64_t first = 0, next; first < count; first = next) {
        for (next = first + 1; next < count; next++)
            if (compare_places(edges[first].end, edges[next].end, 6) != 0)
                break;
        if (note_cracks(fault, edges + first, next - first, err))
            return -1;
    }
    return 0;
}

int survey_find_cracks(struct mesh_survey *survey, const struct mesh *mesh,
                       const struct edge_list *list, struct error *err)
{
    struct boundary boundary;
    if (collect_boundary(&boundary, mesh, list, survey->topology.boundary.count, err))
        return -1;
    struct placed_edge *edges = malloc(((size_t)boundary.count + 1) * sizeof *edges);
    int result = edges ? 0 : error_set(err, "out of memory: places of edges");
    if (edges) {
        for (int64_t i = 0; i < boundary.count; i++)
            edges[i] = place_edge(&boundary, i);
        qsort(edges, (size_t)boundary.count, sizeof *edges, by_places);
        result = note_groups(&survey->faults[SURVEY_CRACK], edges, boundary.count, err);
    }
    free(edges);
    free(boundary.edges);
    return result;
}

/* -- T-vertices ------------------------------------------------------------------------------- */

/* The search for the edge on which a vertex lies. */
struct t_search {
    const struct boundary *boundary;
    double tolerance;
    int32_t vertex;
    int64_t found; /* the first such edge, an index into boundary->edges; -1: none */
    int64_t looked, limit;
};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Whether p lies within the tolerance of the segment, and farther from both ends. */
static bool is_between(const float *p, const float *a, const float *b, double tolerance)
{
    double along[3], to[3], from[3];
    for (int axis = 0; axis < 3; axis++) {
        along[axis] = (double)b[axis] - (double)a[axis];
        to[axis] = (double)p[axis] - (double)a[axis];
        from[axis] = (double)p[axis] - (double)b[axis];
    }
    double square = tolerance * tolerance, length = dot(along, along), share = dot(along, to);
    if (share <= 0 || share >= length || dot(to, to) <= square || dot(from, from) <= square)
        return false;
    for (int axis = 0; axis < 3; axis++)
        to[axis] -= along[axis] * (share / length);
    return dot(to, to) <= square;
}

static bool look_at_edge(void *context, int32_t item)
{
    struct t_search *search = context;
    const struct boundary *boundary = search->boundary;
    const struct edge *edge = boundary_edge(boundary, item);
    int32_t side = boundary->list->uses[edge->first_use];
    const int32_t *corner = boundary->mesh->triangles + (side - side % 3);
    bool is_own =
        corner[0] == search->vertex || corner[1] == search->vertex || corner[2] == search->vertex;
    if (!is_own && (search->found < 0 || item < search->found) &&
        is_between(point_of(boundary, search->vertex), point_of(boundary, edge->low),
                   point_of(boundary, edge->high), search->tolerance))
        search->found = item;
    return ++search->looked < search->limit;
}

/* A coordinate moved away by the tolerance, and by no less than to the next float. */
static float widened(float coordinate, double by)
{
    float moved = (float)((double)coordinate + by);
    return nextafterf(moved, by < 0 ? -INFINITY : INFINITY);
}

static struct bounds box_around(const float *point, double tolerance)
{
    struct bounds box;
    for (int axis = 0; axis < 3; axis++) {
        box.low[axis] = widened(point[axis], -tolerance);
        box.high[axis] = widened(point[axis], tolerance);
    }
    return box;
}

static int search_vertices(struct mesh_survey *survey, const struct box_tree *tree,
                           struct t_search *search, const uint8_t *is_boundary, struct error *err)
{
    const struct mesh *mesh = search->boundary->mesh;
    for (int32_t v = 0; v < mesh->vertex_count && search->looked < search->limit; v++) {
        if (!is_boundary[v])
            continue;
        struct bounds box = box_around(point_of(search->boundary, v), search->tolerance);
        search->vertex = v;
        search->found = -1;
        box_tree_find(tree, &box, look_at_edge, search);
        if (search->found < 0)
            continue;
        const struct edge *edge = boundary_edge(search->boundary, search->found);
        if (survey_note(&survey->faults[SURVEY_T_VERTEX],
                        (struct survey_element){{v, edge->low, edge->high, -1}}, err))
            return -1;
    }
    survey->is_cut[SURVEY_T_VERTEX] = search->looked >= search->limit;
    return 0;
}

static int search_with_room(struct mesh_survey *survey, const struct boundary *boundary,
                            struct bounds *boxes, uint8_t *is_boundary, int64_t limit,
                            struct error *err)
{
    for (int64_t i = 0; i < boundary->count; i++) {
        const struct edge *edge = boundary_edge(boundary, i);
        boxes[i] = bounds_empty();
        bounds_include(&boxes[i], point_of(boundary, edge->low));
        bounds_include(&boxes[i], point_of(boundary, edge->high));
        is_boundary[edge->low] = is_boundary[edge->high] = 1;
    }
    struct box_tree tree;
    if (box_tree_build(&tree, boxes, (int32_t)boundary->count, err))
        return -1;
    struct t_search search = {.boundary = boundary, .tolerance = survey->tolerance, .limit = limit};
    int result = search_vertices(survey, &tree, &search, is_boundary, err);
    box_tree_release(&tree);
    return result;
}

int survey_find_t_vertices(struct mesh_survey *survey, const struct mesh *mesh,
                           const struct edge_list *list, int64_t pair_limit, struct error *err)
{
    struct boundary boundary;
    if (collect_boundary(&boundary, mesh, list, survey->topology.boundary.count, err))
        return -1;
    struct bounds *boxes = malloc(((size_t)boundary.count + 1) * sizeof *boxes);
    uint8_t *is_boundary = calloc((size_t)mesh->vertex_count + 1, 1);
    int result = boxes && is_boundary
                     ? search_with_room(survey, &boundary, boxes, is_boundary, pair_limit, err)
                     : error_set(err, "out of memory: boxes of boundary edges");
    free(is_boundary);
    free(boxes);
    free(boundary.edges);
    return result;
}
