/* Comparing meshes as oriented surfaces; see surface.h. */
#include "graders/library/surface.h"

#include "graders/library/near_points.h"
#include "graders/library/tuples.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

const struct cause surface_bad_index = {"index-out-of-range",
                                        {"index out of range", "índice fuera de rango"}};
const struct cause surface_stray = {"misplaced-vertex",
                                    {"misplaced vertex", "vértice fuera de su sitio"}};
const struct cause surface_doubled = {"doubled-vertex", {"doubled vertex", "vértice duplicado"}};
const struct cause surface_lost = {"missing-vertex", {"missing vertex", "falta un vértice"}};
const struct cause surface_repeated = {"duplicate-triangle",
                                       {"duplicate triangle", "triángulo repetido"}};
const struct cause surface_extra = {"extra-triangle", {"extra triangle", "sobra un triángulo"}};
const struct cause surface_flipped = {"flipped-triangle",
                                      {"flipped triangle", "triángulo al revés"}};
const struct cause surface_missing = {"missing-triangle",
                                      {"missing triangle", "falta un triángulo"}};

const struct cause *surface_fault_cause_of_triangles(const struct surface_fault *fault)
{
    if (fault->bad_corner_count)
        return &surface_bad_index;
    if (fault->stray_count)
        return &surface_stray;
    if (fault->triangles.repeated_count)
        return &surface_repeated;
    if (fault->triangles.extra_count)
        return &surface_extra;
    if (fault->triangles.reversed_count)
        return &surface_flipped;
    return fault->triangles.missing_count ? &surface_missing : NULL;
}

const struct cause *surface_fault_cause(const struct surface_fault *fault)
{
    bool is_later = !fault->bad_corner_count && !fault->stray_count;
    if (is_later && fault->doubled_count)
        return &surface_doubled;
    if (is_later && fault->lost_count)
        return &surface_lost;
    return surface_fault_cause_of_triangles(fault);
}

void surface_fault_release(struct surface_fault *fault)
{
    set_fault_release(&fault->triangles);
    free(fault->right_of);
    *fault = (struct surface_fault){0};
}

static void note(int64_t *first, int64_t *count, int64_t element)
{
    if ((*count)++ == 0)
        *first = element;
}

static void note_stray(struct surface_fault *fault, int64_t vertex, double distance)
{
    if (fault->stray_count == 0)
        fault->stray_distance = distance;
    note(&fault->stray, &fault->stray_count, vertex);
}

/* Finds right vertices for which several stand, or none. `first` has an entry for each. */
static void look_at_vertices(const struct surface_mesh *answer, const struct surface_mesh *right,
                             int32_t *first, struct surface_fault *fault)
{
    for (int32_t v = 0; v < right->vertex_count; v++)
        first[v] = -1;
    for (int32_t v = 0; v < answer->vertex_count; v++) {
        int32_t stands_for = fault->right_of[v];
        if (stands_for < 0)
            continue;
        if (first[stands_for] < 0) {
            first[stands_for] = v;
            continue;
        }
        if (fault->doubled_count == 0)
            fault->doubled_of = first[stands_for];
        note(&fault->doubled, &fault->doubled_count, v);
    }
    for (int32_t v = 0; v < right->vertex_count; v++)
        if (first[v] < 0)
            note(&fault->lost, &fault->lost_count, v);
}

/* The answer's triangles between right vertices; -1, which no right triangle has, for others. */
static void rename_corners(const struct surface_mesh *answer, int32_t *renamed,
                           struct surface_fault *fault)
{
    for (int64_t c = 0; c < 3 * answer->triangle_count; c++) {
        int32_t v = answer->triangles[c];
        bool is_vertex = v >= 0 && v < answer->vertex_count;
        renamed[c] = is_vertex ? fault->right_of[v] : -1;
        if (!is_vertex)
            note(&fault->bad_corner, &fault->bad_corner_count, c);
    }
}

static int compare_triangles(const struct surface_mesh *answer, const struct surface_mesh *right,
                             struct surface_fault *fault, struct error *err)
{
    int32_t *renamed = calloc(3 * (size_t)answer->triangle_count + 1, sizeof *renamed);
    int32_t *first = calloc((size_t)right->vertex_count + 1, sizeof *first);
    int failed;
    if (renamed && first) {
        look_at_vertices(answer, right, first, fault);
        rename_corners(answer, renamed, fault);
        failed = tuples_compare(renamed, answer->triangle_count, right->triangles,
                                right->triangle_count, 3, TUPLES_ROTATED, &fault->triangles, err);
    } else {
        failed = error_set(err, "out of memory: comparing %" PRId64 " triangles",
                           answer->triangle_count);
    }
    free(renamed);
    free(first);
    return failed;
}

static int begin(const struct surface_mesh *answer, const struct surface_mesh *right,
                 struct surface_fault *fault, struct error *err)
{
    *fault = (struct surface_fault){
        .bad_corner = -1, .stray = -1, .doubled_of = -1, .doubled = -1, .lost = -1};
    if (answer->vertex_count < 0 || answer->triangle_count < 0 || right->vertex_count < 0 ||
        right->triangle_count < 0 || answer->triangle_count > INT32_MAX)
        return error_set(err, "a mesh of %d vertices and %" PRId64 " triangles cannot be compared",
                         answer->vertex_count, answer->triangle_count);
    fault->right_of = calloc((size_t)answer->vertex_count + 1, sizeof *fault->right_of);
    if (!fault->right_of)
        return error_set(err, "out of memory: comparing %d vertices", answer->vertex_count);
    return 0;
}

int surface_compare_mapped(const struct surface_mesh *answer, const int32_t *origin,
                           const struct surface_mesh *right, struct surface_fault *fault,
                           struct error *err)
{
    if (begin(answer, right, fault, err))
        return -1;
    for (int32_t v = 0; v < answer->vertex_count; v++) {
        bool is_right = origin[v] >= 0 && origin[v] < right->vertex_count;
        fault->right_of[v] = is_right ? origin[v] : -1;
        if (!is_right)
            note_stray(fault, v, INFINITY);
    }
    if (!compare_triangles(answer, right, fault, err))
        return 0;
    surface_fault_release(fault);
    return -1;
}

int surface_compare_places(const struct surface_mesh *answer, const struct surface_mesh *right,
                           double tolerance, double reach, struct surface_fault *fault,
                           struct error *err)
{
    struct near_points tree;
    if (begin(answer, right, fault, err))
        return -1;
    if (near_points_build(&tree, right->positions, right->vertex_count, err)) {
        surface_fault_release(fault);
        return -1;
    }
    for (int32_t v = 0; v < answer->vertex_count; v++) {
        const float *p = answer->positions + 3 * (int64_t)v;
        int32_t near = near_points_find(&tree, p, reach > tolerance ? reach : tolerance);
        fault->right_of[v] = near;
        double distance = near < 0 ? (double)INFINITY
                                   : near_points_distance(p, right->positions + 3 * (int64_t)near);
        if (!(distance <= tolerance))
            note_stray(fault, v, distance);
    }
    near_points_release(&tree);
    if (!compare_triangles(answer, right, fault, err))
        return 0;
    surface_fault_release(fault);
    return -1;
}
