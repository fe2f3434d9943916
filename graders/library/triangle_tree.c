/* Triangles in a tree of boxes, sorted along a curve that fills space (Morton 1966); see
 * distance.h. */
#include "graders/library/distance.h"

#include "graders/library/sorting.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

/* ------------------------------------------------------------------------------- points, triangles
 */

static double dot(const double u[3], const double v[3])
{
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

static void subtract(const double u[3], const double v[3], double result[3])
{
    result[0] = u[0] - v[0];
    result[1] = u[1] - v[1];
    result[2] = u[2] - v[2];
}

static double distance_of(const double p[3], const double q[3])
{
    double d[3];
    subtract(p, q, d);
    return sqrt(dot(d, d));
}

/* The point of the segment from a along d (of any length, 0 too) that is nearest to p. */
static double nearest_of_segment(const double p[3], const double a[3], const double b[3],
                                 double nearest[3])
{
    double d[3], to_p[3];
    subtract(b, a, d);
    subtract(p, a, to_p);
    double square = dot(d, d), along = square > 0 ? dot(to_p, d) / square : 0;
    along = along > 0 ? (along < 1 ? along : 1) : 0;
    nearest[0] = a[0] + along * d[0];
    nearest[1] = a[1] + along * d[1];
    nearest[2] = a[2] + along * d[2];
    return distance_of(p, nearest);
}

double distance_point_triangle(const double p[3], const double a[3], const double b[3],
                               const double c[3], double nearest[3])
{
    const double *corner[3] = {a, b, c};
    double best = INFINITY, point[3] = {a[0], a[1], a[2]}, q[3];
    double ab[3], ac[3], ap[3];
    subtract(b, a, ab);
    subtract(c, a, ac);
    subtract(p, a, ap);
    double d00 = dot(ab, ab), d01 = dot(ab, ac), d11 = dot(ac, ac);
    double d20 = dot(ap, ab), d21 = dot(ap, ac), area = d00 * d11 - d01 * d01;
    double v = d11 * d20 - d01 * d21, w = d00 * d21 - d01 * d20;
    if (area > 0 && v >= 0 && w >= 0 && v + w <= area) {
        for (int axis = 0; axis < 3; axis++)
            point[axis] = a[axis] + (v * ab[axis] + w * ac[axis]) / area;
        best = distance_of(p, point);
    }
    /* The sides too: where the area is lost in rounding, they are what counts. */
    for (int side = 0; side < 3; side++) {
        double distance = nearest_of_segment(p, corner[side], corner[(side + 1) % 3], q);
        if (!(distance < best))
            continue;
        best = distance;
        for (int axis = 0; axis < 3; axis++)
            point[axis] = q[axis];
    }
    for (int axis = 0; nearest && axis < 3; axis++)
        nearest[axis] = point[axis];
    return best;
}

static const float *corner_of(const struct surface_mesh *mesh, int64_t triangle, int c)
{
    return mesh->positions + 3 * (int64_t)mesh->triangles[3 * triangle + c];
}

static double distance_to(const struct triangle_tree *tree, int32_t triangle, const double p[3])
{
    double corner[3][3];
    for (int c = 0; c < 3; c++)
        for (int axis = 0; axis < 3; axis++)
            corner[c][axis] = (double)corner_of(tree->mesh, triangle, c)[axis];
    return distance_point_triangle(p, corner[0], corner[1], corner[2], NULL);
}

/* -------------------------------------------------------------------------------------- building
 */

enum { LEAF = 4, AXIS_BITS = 21 };

/* Lists the triangles that can be searched. */
static void list_triangles(struct triangle_tree *tree)
{
    const struct surface_mesh *mesh = tree->mesh;
    for (int64_t t = 0; t < mesh->triangle_count; t++) {
        bool is_fine = true;
        for (int c = 0; c < 3; c++) {
            int32_t v = mesh->triangles[3 * t + c];
            bool is_vertex = v >= 0 && v < mesh->vertex_count;
            const float *p = is_vertex ? corner_of(mesh, t, c) : NULL;
            if (p && isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2]))
                continue;
            is_fine = false;
            if (tree->bad_corner_count++ == 0)
                tree->bad_corner = 3 * t + c;
        }
        if (is_fine)
            tree->order[tree->count++] = (int32_t)t;
    }
}

/* The place of a triangle's middle in a box, along the curve; what lies outside is drawn in. */
static uint64_t place_on_curve(const struct surface_mesh *mesh, int32_t triangle,
                               const double low[3], const double high[3])
{
    uint64_t place = 0, cell[3];
    for (int axis = 0; axis < 3; axis++) {
        double middle = 0, size = high[axis] - low[axis];
        for (int c = 0; c < 3; c++)
            middle += (double)corner_of(mesh, triangle, c)[axis] / 3;
        double share = size > 0 ? (middle - low[axis]) / size : 0;
        share = share > 0 ? (share < 1 ? share : 1) : 0;
        cell[axis] = (uint64_t)(share * ((1 << AXIS_BITS) - 1));
    }
    for (int bit = AXIS_BITS - 1; bit >= 0; bit--)
        for (int axis = 0; axis < 3; axis++)
            place = place << 1 | (cell[axis] >> bit & 1);
    return place;
}

static int compare_places(int64_t a, int64_t b, const void *context)
{
    const uint64_t *place = context;
    return (place[a] > place[b]) - (place[a] < place[b]);
}

static void grow(double *box, const double *low, const double *high)
{
    for (int axis = 0; axis < 3; axis++) {
        box[axis] = low[axis] < box[axis] ? low[axis] : box[axis];
        box[3 + axis] = high[axis] > box[3 + axis] ? high[axis] : box[3 + axis];
    }
}

/* Fills the box of a node that holds order[first] ... order[end - 1], and those below it. As deep
 * as the logarithm of the count. */
static void fill_boxes(struct triangle_tree *tree, int64_t node, int32_t first, int32_t end)
{
    double *box = tree->boxes + 6 * node;
    for (int axis = 0; axis < 3; axis++) {
        box[axis] = INFINITY;
        box[3 + axis] = -INFINITY;
    }
    if (end - first > LEAF) {
        int32_t middle = first + (end - first) / 2;
        fill_boxes(tree, 2 * node + 1, first, middle);
        fill_boxes(tree, 2 * node + 2, middle, end);
        for (int child = 1; child <= 2; child++) {
            const double *below = tree->boxes + 6 * (2 * node + child);
            grow(box, below, below + 3);
        }
        return;
    }
    for (int32_t i = first; i < end; i++)
        for (int c = 0; c < 3; c++) {
            const float *corner = corner_of(tree->mesh, tree->order[i], c);
            const double p[3] = {(double)corner[0], (double)corner[1], (double)corner[2]};
            grow(box, p, p);
        }
}

/* Sorts the triangles along the curve. */
static bool sort_triangles(struct triangle_tree *tree, const double low[3], const double high[3])
{
    size_t room = (size_t)tree->count + 1;
    uint64_t *place = calloc(room, sizeof *place);
    int64_t *order = calloc(room, sizeof *order), *spare = calloc(room, sizeof *spare);
    int32_t *triangles = calloc(room, sizeof *triangles);
    bool has_memory = place && order && spare && triangles;
    for (int32_t i = 0; has_memory && i < tree->count; i++) {
        place[i] = place_on_curve(tree->mesh, tree->order[i], low, high);
        order[i] = i;
        triangles[i] = tree->order[i];
    }
    if (has_memory)
        sort_order(order, spare, tree->count, compare_places, place);
    for (int32_t i = 0; has_memory && i < tree->count; i++)
        tree->order[i] = triangles[order[i]];
    free(place);
    free(order);
    free(spare);
    free(triangles);
    return has_memory;
}

int triangle_tree_build(struct triangle_tree *tree, const struct surface_mesh *mesh,
                        const double low[3], const double high[3], struct error *err)
{
    *tree = (struct triangle_tree){.mesh = mesh, .bad_corner = -1};
    if (mesh->triangle_count < 0 || mesh->triangle_count > INT32_MAX / 4 || mesh->vertex_count < 0)
        return error_set(err, "%" PRId64 " triangles cannot be searched", mesh->triangle_count);
    tree->order = calloc((size_t)mesh->triangle_count + 1, sizeof *tree->order);
    /* Only what holds more than LEAF triangles is split: fewer nodes than triangles, and the root.
     */
    tree->boxes = calloc(6 * ((size_t)mesh->triangle_count + 1), sizeof *tree->boxes);
    bool has_memory = tree->order && tree->boxes;
    if (has_memory) {
        list_triangles(tree);
        has_memory = sort_triangles(tree, low, high);
    }
    if (!has_memory) {
        triangle_tree_release(tree);
        return error_set(err, "out of memory: a tree of %" PRId64 " triangles",
                         mesh->triangle_count);
    }
    fill_boxes(tree, 0, 0, tree->count);
    return 0;
}

void triangle_tree_release(struct triangle_tree *tree)
{
    free(tree->order);
    free(tree->boxes);
    *tree = (struct triangle_tree){0};
}

/* ------------------------------------------------------------------------------------- searching
 */

struct quest {
    const double *p;
    double best, enough;
    int32_t triangle;
};

/* How near a box can be. */
static double box_distance(const double *box, const double p[3])
{
    double square = 0;
    for (int axis = 0; axis < 3; axis++) {
        double below = box[axis] - p[axis], above = p[axis] - box[3 + axis];
        double off = below > 0 ? below : above > 0 ? above : 0;
        square += off * off;
    }
    return sqrt(square);
}

static void search(const struct triangle_tree *tree, int64_t node, int32_t first, int32_t end,
                   struct quest *quest)
{
    if (end - first <= LEAF) {
        for (int32_t i = first; i < end && quest->best > quest->enough; i++) {
            double distance = distance_to(tree, tree->order[i], quest->p);
            if (distance < quest->best) {
                quest->best = distance;
                quest->triangle = tree->order[i];
            }
        }
        return;
    }
    int32_t middle = first + (end - first) / 2;
    double left = box_distance(tree->boxes + 6 * (2 * node + 1), quest->p);
    double right = box_distance(tree->boxes + 6 * (2 * node + 2), quest->p);
    for (int turn = 0; turn < 2; turn++) {
        bool is_left = (turn == 0) == (left <= right);
        if (quest->best <= quest->enough || (is_left ? left : right) >= quest->best)
            continue;
        if (is_left)
            search(tree, 2 * node + 1, first, middle, quest);
        else
            search(tree, 2 * node + 2, middle, end, quest);
    }
}

double triangle_tree_distance(const struct triangle_tree *tree, const double p[3], double enough,
                              int32_t *triangle)
{
    struct quest quest = {p, INFINITY, enough, -1};
    bool is_finite = isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2]);
    if (is_finite && *triangle >= 0) {
        quest.triangle = *triangle;
        quest.best = distance_to(tree, *triangle, p);
    }
    if (is_finite && !(quest.best <= enough))
        search(tree, 0, 0, tree->count, &quest);
    *triangle = quest.triangle;
    return quest.best;
}
