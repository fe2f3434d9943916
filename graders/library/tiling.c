/* Triangles that tile a polygon; see tiling.h. */
#include "graders/library/tiling.h"

#include "graders/library/topology.h"

#include <inttypes.h>
#include <stdlib.h>

const struct cause tiling_bad_index = {"index-out-of-range",
                                       {"index out of range", "índice fuera de rango"}};
const struct cause tiling_no_area = {"triangle-without-area",
                                     {"triangle without area", "triángulo sin área"}};
const struct cause tiling_flipped = {"flipped-triangle",
                                     {"flipped triangle", "triángulo al revés"}};
const struct cause tiling_gap = {"outline-not-covered",
                                 {"outline not covered", "contorno sin cubrir"}};
const struct cause tiling_loose = {"overlap-or-hole", {"overlap or hole", "solapamiento o hueco"}};

const struct cause *tiling_fault_cause(const struct tiling_fault *fault)
{
    if (fault->bad_corner_count)
        return &tiling_bad_index;
    if (fault->no_area_count)
        return &tiling_no_area;
    if (fault->flipped_count)
        return &tiling_flipped;
    if (fault->gap_count)
        return &tiling_gap;
    return fault->loose_count ? &tiling_loose : NULL;
}

void tiling_fault_release(struct tiling_fault *fault)
{
    free(fault->marks);
    *fault = (struct tiling_fault){0};
}

static void note(int64_t *first, int64_t *count, int64_t element)
{
    if ((*count)++ == 0)
        *first = element;
}

static void mark(struct tiling_fault *fault, int64_t triangle, enum tiling_mark mark)
{
    if (fault->marks[triangle] == TILING_FINE)
        fault->marks[triangle] = (uint8_t)mark;
}

static void look_at_triangles(const struct plane_point *points, int32_t point_count,
                              const int32_t *triangles, int64_t triangle_count,
                              struct tiling_fault *fault)
{
    for (int64_t t = 0; t < triangle_count; t++) {
        const int32_t *v = triangles + 3 * t;
        bool is_named = true;
        for (int c = 0; c < 3; c++)
            if (v[c] < 0 || v[c] >= point_count) {
                is_named = false;
                note(&fault->bad_corner, &fault->bad_corner_count, 3 * t + c);
                mark(fault, t, TILING_BAD_INDEX);
            }
        if (!is_named)
            continue;
        int64_t twice = plane_twice_area(points[v[0]], points[v[1]], points[v[2]]);
        fault->area += (double)twice / 2;
        if (twice == 0) {
            note(&fault->no_area, &fault->no_area_count, t);
            mark(fault, t, TILING_NO_AREA);
        } else if (twice < 0) {
            note(&fault->flipped, &fault->flipped_count, t);
            mark(fault, t, TILING_FLIPPED);
        }
    }
}

static double area_of(const struct plane_point *points, const struct tiling_outline *outline)
{
    const struct plane_point origin = {0, 0};
    double twice = 0;
    for (int64_t chain = 0; chain < outline->count; chain++) {
        int32_t first = outline->first[chain], end = outline->first[chain + 1];
        for (int32_t i = first; i < end; i++) {
            int32_t next = i + 1 == end ? first : i + 1;
            twice += (double)plane_twice_area(origin, points[outline->vertices[i]],
                                              points[outline->vertices[next]]);
        }
    }
    return twice / 2;
}

/* How often each edge is run upwards more than downwards, the outline taken away. A step of the
 * outline that no triangle has, or has only backwards, is a gap. */
static void subtract_outline(const struct face_topology *t, const struct tiling_outline *outline,
                             int64_t *surplus, struct tiling_fault *fault)
{
    for (int64_t e = 0; e < t->edge_count; e++)
        surplus[e] = (int64_t)t->edges[e].up_count - t->edges[e].down_count;
    for (int64_t chain = 0; chain < outline->count; chain++) {
        int32_t first = outline->first[chain], end = outline->first[chain + 1];
        for (int32_t i = first; i < end; i++) {
            int32_t a = outline->vertices[i];
            int32_t b = outline->vertices[i + 1 == end ? first : i + 1];
            int64_t e = topology_find_edge(t, a, b);
            bool is_run = e >= 0 && (a < b ? t->edges[e].up_count : t->edges[e].down_count) > 0;
            if (!is_run)
                note(&fault->gap, &fault->gap_count, i);
            if (e >= 0)
                surplus[e] -= a < b ? 1 : -1;
        }
    }
}

/* Of an edge that is run too often one way, the sides that run it so. */
static void look_at_sides(const struct face_topology *t, const int64_t *surplus,
                          struct tiling_fault *fault)
{
    for (int64_t c = 0; c < t->table.corner_count; c++) {
        if (t->side_edge[c] < 0)
            continue;
        int64_t extra = surplus[t->side_edge[c]];
        bool is_up = t->table.corners[c] < t->table.corners[topology_next(t, c)];
        if (is_up ? extra > 0 : extra < 0) {
            note(&fault->loose, &fault->loose_count, c);
            mark(fault, t->corner_face[c], TILING_LOOSE);
        }
    }
}

static struct face_table table_of(const int32_t *triangles, int64_t triangle_count,
                                  int32_t point_count)
{
    return (struct face_table){.corners = triangles,
                               .face_count = triangle_count,
                               .corner_count = 3 * triangle_count,
                               .vertex_count = point_count};
}

int tiling_check(const struct plane_point *points, int32_t point_count,
                 const struct tiling_outline *outline, const int32_t *triangles,
                 int64_t triangle_count, struct tiling_fault *fault, struct error *err)
{
    *fault = (struct tiling_fault){
        .bad_corner = -1, .no_area = -1, .flipped = -1, .gap = -1, .loose = -1};
    struct face_topology t;
    if (triangle_count < 0 || triangle_count > INT32_MAX / 3)
        return error_set(err, "%" PRId64 " triangles cannot be checked: look at the count first",
                         triangle_count);
    struct face_table table = table_of(triangles, triangle_count, point_count);
    if (topology_build(&table, &t, err))
        return -1;
    int64_t *surplus = calloc((size_t)t.edge_count + 1, sizeof *surplus);
    fault->marks = calloc((size_t)triangle_count + 1, 1);
    bool has_memory = surplus && fault->marks;
    if (has_memory) {
        look_at_triangles(points, point_count, triangles, triangle_count, fault);
        subtract_outline(&t, outline, surplus, fault);
        look_at_sides(&t, surplus, fault);
        fault->right_area = area_of(points, outline);
    } else {
        tiling_fault_release(fault);
    }
    free(surplus);
    topology_release(&t);
    return has_memory ? 0
                      : error_set(err, "out of memory: the sides of %" PRId64 " triangles",
                                  triangle_count);
}

int tiling_find_not_delaunay(const struct plane_point *points, int32_t point_count,
                             const int32_t *triangles, int64_t triangle_count, int64_t *corner,
                             int32_t *inside, struct error *err)
{
    *corner = *inside = -1;
    struct face_topology t;
    if (triangle_count < 0 || triangle_count > INT32_MAX / 3)
        return error_set(err, "%" PRId64 " triangles cannot be checked", triangle_count);
    struct face_table table = table_of(triangles, triangle_count, point_count);
    if (topology_build(&table, &t, err))
        return -1;
    for (int64_t c = 0; c < 3 * triangle_count && *corner < 0; c++) {
        int64_t twin = t.side_edge[c] < 0 ? -1 : topology_twin(&t, c);
        if (twin < 0)
            continue;
        const int32_t *v = triangles + c - c % 3;
        int32_t opposite = triangles[topology_previous(&t, twin)];
        if (plane_in_circle(points[v[0]], points[v[1]], points[v[2]], points[opposite]) > 0) {
            *corner = c;
            *inside = opposite;
        }
    }
    topology_release(&t);
    return 0;
}
