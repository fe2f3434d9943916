/* Edge list as a representation; see edge_list.h. */
#include "reference/representation/edge_list.h"

#include "reference/representation/boundary_chain.h"
#include "reference/representation/by_faces.h"
#include "reference/representation/edge_numbers.h"
#include "reference/representation/smoother.h"
#include "reference/representation/triangle_sweeps.h"

#include <stdlib.h>
#include <string.h>

/* -- life ------------------------------------------------------------------------------------- */

static void release(void *self)
{
    struct triangle_edge_list *list = self;
    free(list->positions);
    free(list->ends);
    free(list->edges);
    *list = (struct triangle_edge_list){0};
}

static int build(void *self, const struct mesh *mesh, struct error *err)
{
    struct triangle_edge_list *list = self;
    *list = (struct triangle_edge_list){0};
    int64_t edge_count = edge_numbers_of_mesh(mesh, &list->edges, err);
    if (edge_count < 0)
        return -1;
    list->positions = malloc(12 * (size_t)mesh->vertex_count + 1);
    list->ends = malloc(8 * (size_t)edge_count + 1);
    if (!list->positions || !list->ends) {
        release(self);
        return error_set(err, "out of memory: a list of %lld edges", (long long)edge_count);
    }
    list->vertex_count = mesh->vertex_count;
    list->face_count = mesh->triangle_count;
    if (mesh->vertex_count > 0)
        memcpy(list->positions, mesh->positions, 12 * (size_t)mesh->vertex_count);
    for (int64_t side = 0; side < 3 * (int64_t)mesh->triangle_count; side++) {
        int32_t edge = list->edges[side];
        if (edge < list->edge_count)
            continue; /* not its first side */
        list->ends[2 * (int64_t)edge] = mesh->triangles[side];
        list->ends[2 * (int64_t)edge + 1] = mesh->triangles[side % 3 == 2 ? side - 2 : side + 1];
        list->edge_count++;
    }
    return 0;
}

static int32_t vertex_count(const void *self)
{
    const struct triangle_edge_list *list = self;
    return list->vertex_count;
}

static int32_t face_count(const void *self)
{
    const struct triangle_edge_list *list = self;
    return list->face_count;
}

static int to_mesh(const void *self, struct mesh *mesh, struct error *err)
{
    const struct triangle_edge_list *list = self;
    return faces_to_mesh(&representation_edge_list, self, list->positions, mesh, err);
}

static int64_t bytes(const void *self)
{
    const struct triangle_edge_list *list = self;
    return 12 * (int64_t)list->vertex_count + 8 * (int64_t)list->edge_count +
           12 * (int64_t)list->face_count;
}

static int64_t formula_bytes(const struct mesh_counts *counts)
{
    return 12 * counts->vertices + 8 * counts->edges + 12 * counts->triangles;
}

/* The vertex that two edges share, -1 when they share none. */
static int32_t shared_vertex(const struct triangle_edge_list *list, int32_t d, int32_t e)
{
    const int32_t *a = list->ends + 2 * (int64_t)d, *b = list->ends + 2 * (int64_t)e;
    if (a[0] == b[0] || a[0] == b[1])
        return a[0];
    return a[1] == b[0] || a[1] == b[1] ? a[1] : -1;
}

static void corners_of(const struct triangle_edge_list *list, int64_t face, int32_t corners[3])
{
    const int32_t *edge = list->edges + 3 * face;
    for (int i = 0; i < 3; i++)
        corners[i] = shared_vertex(list, edge[(i + 2) % 3], edge[i]);
}

/* -- check ------------------------------------------------------------------------------------ */

static int check_tables(const struct triangle_edge_list *list, struct error *err)
{
    if (positions_check(list->positions, list->vertex_count, err))
        return -1;
    for (int64_t e = 0; e < list->edge_count; e++) {
        int32_t u = list->ends[2 * e], v = list->ends[2 * e + 1];
        if (u < 0 || u >= list->vertex_count || v < 0 || v >= list->vertex_count || u == v)
            return error_set(err, "edge %lld joins vertices %d and %d of %d", (long long)e, u, v,
                             list->vertex_count);
    }
    for (int64_t f = 0; f < list->face_count; f++) {
        int32_t corner[3];
        for (int i = 0; i < 3; i++)
            if (list->edges[3 * f + i] < 0 || list->edges[3 * f + i] >= list->edge_count)
                return error_set(err, "face %lld names edge %d of %d", (long long)f,
                                 list->edges[3 * f + i], list->edge_count);
        corners_of(list, f, corner);
        if (corner[0] < 0 || corner[1] < 0 || corner[2] < 0 || triangle_is_degenerate(corner))
            return error_set(err, "face %lld: its edges %d, %d, %d are no ring", (long long)f,
                             list->edges[3 * f], list->edges[3 * f + 1], list->edges[3 * f + 2]);
    }
    return edge_numbers_check(list->ends, 2, list->edge_count, list->vertex_count, err);
}

/* Faces at each edge, up to 3; the caller frees the table. NULL when memory runs out. */
static uint8_t *count_faces(const struct triangle_edge_list *list, struct error *err)
{
    uint8_t *counts = calloc((size_t)list->edge_count + 1, 1);
    if (!counts) {
        error_set(err, "out of memory: counting the faces of %d edges", list->edge_count);
        return NULL;
    }
    for (int64_t i = 0; i < 3 * (int64_t)list->face_count; i++)
        if (counts[list->edges[i]] < 3)
            counts[list->edges[i]]++;
    return counts;
}

static int check(const void *self, struct error *err)
{
    const struct triangle_edge_list *list = self;
    if (check_tables(list, err))
        return -1;
    uint8_t *counts = count_faces(list, err);
    if (!counts)
        return -1;
    int result = 0;
    for (int64_t e = 0; e < list->edge_count && result == 0; e++)
        if (counts[e] == 0)
            result = error_set(err, "edge %lld is in no face", (long long)e);
    free(counts);
    return result;
}

/* -- sweeps ----------------------------------------------------------------------------------- */

static int64_t transform(void *self, const float matrix[12])
{
    struct triangle_edge_list *list = self;
    return positions_transform(list->positions, list->vertex_count, matrix);
}

static double area(const void *self)
{
    const struct triangle_edge_list *list = self;
    return faces_area(&representation_edge_list, self, list->positions);
}

static void face_normals(const void *self, float *normals)
{
    const struct triangle_edge_list *list = self;
    faces_normals(&representation_edge_list, self, list->positions, normals);
}

static int vertex_normals(const void *self, float *normals, struct error *err)
{
    const struct triangle_edge_list *list = self;
    (void)err;
    faces_vertex_normals(&representation_edge_list, self, list->positions, normals);
    return 0;
}

static int64_t edges(const void *self, int32_t *pairs, struct error *err)
{
    const struct triangle_edge_list *list = self;
    (void)err;
    for (int64_t e = 0; e < list->edge_count; e++) {
        int32_t u = list->ends[2 * e], v = list->ends[2 * e + 1];
        pairs[2 * e] = u < v ? u : v;
        pairs[2 * e + 1] = u < v ? v : u;
    }
    return list->edge_count;
}

/* Sides on edges of one face, from and to; returns how many, or -1 and *err naming an edge that has
 * more than two. */
static int64_t collect_boundary(const struct triangle_edge_list *list, const uint8_t *counts,
                                int32_t *sides, struct error *err)
{
    int64_t count = 0;
    for (int64_t side = 0; side < 3 * (int64_t)list->face_count; side++) {
        int32_t edge = list->edges[side];
        if (counts[edge] > 2)
            return error_set(err, "edge {%d,%d} has more than two faces: no boundary loops",
                             list->ends[2 * (int64_t)edge], list->ends[2 * (int64_t)edge + 1]);
        if (counts[edge] != 1)
            continue;
        int32_t corners[3] = {0};
        corners_of(list, side / 3, corners);
        sides[2 * count] = corners[side % 3];
        sides[2 * count + 1] = corners[(side + 1) % 3];
        count++;
    }
    return count;
}

static int32_t boundary_loops(const void *self, int32_t *vertices, int32_t *loop_starts,
                              struct error *err)
{
    const struct triangle_edge_list *list = self;
    uint8_t *counts = count_faces(list, err);
    if (!counts)
        return -1;
    int32_t loops = -1;
    int32_t *sides = malloc(2 * (size_t)list->edge_count * sizeof *sides + 1);
    if (!sides)
        error_set(err, "out of memory: collecting boundary edges");
    int64_t count = sides ? collect_boundary(list, counts, sides, err) : -1;
    if (count >= 0)
        loops = boundary_chain(sides, count, list->vertex_count, vertices, loop_starts, err);
    free(sides);
    free(counts);
    return loops;
}

static int smooth(void *self, struct error *err)
{
    struct triangle_edge_list *list = self;
    struct smoother smoother;
    uint8_t *counts = count_faces(list, err);
    int result = counts ? smoother_init(&smoother, list->vertex_count, err) : -1;
    if (result == 0) {
        for (int64_t e = 0; e < list->edge_count; e++) {
            const int32_t *end = list->ends + 2 * e;
            smoother_add_edge(&smoother, list->positions, end[0], end[1]);
            if (counts[e] == 1) {
                smoother_fix(&smoother, end[0]);
                smoother_fix(&smoother, end[1]);
            }
        }
        smoother_apply(&smoother, list->positions);
        smoother_release(&smoother);
    }
    free(counts);
    return result;
}

/* -- queries ---------------------------------------------------------------------------------- */

static void face_vertices(const void *self, int32_t first, int32_t count, int32_t *corners)
{
    const struct triangle_edge_list *list = self;
    for (int32_t i = 0; i < count; i++)
        corners_of(list, (int64_t)first + i, corners + 3 * (int64_t)i);
}

static int32_t face_neighbours(const void *self, int32_t face, int32_t neighbours[3])
{
    const struct triangle_edge_list *list = self;
    const int32_t *own = list->edges + 3 * (int64_t)face;
    int32_t found = 0;
    neighbours[0] = neighbours[1] = neighbours[2] = -1;
    for (int32_t f = 0; f < list->face_count && found < 3; f++)
        for (int i = 0; i < 9 && f != face; i++)
            if (neighbours[i % 3] < 0 && own[i % 3] == list->edges[3 * (int64_t)f + i / 3]) {
                neighbours[i % 3] = f;
                found++;
            }
    return found;
}

static int32_t faces_around_vertex(const void *self, int32_t vertex, int32_t *faces,
                                   int32_t capacity)
{
    return faces_search_faces_around(&representation_edge_list, self, NULL, vertex, faces,
                                     capacity);
}

static int32_t vertices_around_vertex(const void *self, int32_t vertex, int32_t *vertices,
                                      int32_t capacity)
{
    const struct triangle_edge_list *list = self;
    int32_t found = 0;
    for (int64_t e = 0; e < list->edge_count; e++) {
        const int32_t *end = list->ends + 2 * e;
        if (end[0] != vertex && end[1] != vertex)
            continue;
        if (found < capacity)
            vertices[found] = end[0] == vertex ? end[1] : end[0];
        found++;
    }
    return found;
}

static bool is_edge(const void *self, int32_t u, int32_t v)
{
    const struct triangle_edge_list *list = self;
    for (int64_t e = 0; e < list->edge_count; e++) {
        const int32_t *end = list->ends + 2 * e;
        if ((end[0] == u && end[1] == v) || (end[0] == v && end[1] == u))
            return true;
    }
    return false;
}

const struct representation representation_edge_list = {
    .order = 60,
    .name = "edge-list",
    .title = "Edge list",
    .documents = "001, 004",
    .struct_bytes = sizeof(struct triangle_edge_list),
    .holds = FEATURE_ALL & ~(unsigned)FEATURE_DEGENERATE_TRIANGLE,
    .cost = {[QUERY_FACE_VERTICES] = "1",
             [QUERY_FACE_NEIGHBOURS] = "n",
             [QUERY_FACES_AROUND_VERTEX] = "n",
             [QUERY_VERTICES_AROUND_VERTEX] = "n",
             [QUERY_IS_EDGE] = "n"},
    .tables = {{offsetof(struct triangle_edge_list, positions), 3 * sizeof(float)},
               {offsetof(struct triangle_edge_list, ends), 2 * sizeof(int32_t)},
               {offsetof(struct triangle_edge_list, edges), 3 * sizeof(int32_t)}},
    .build = build,
    .release = release,
    .check = check,
    .to_mesh = to_mesh,
    .vertex_count = vertex_count,
    .face_count = face_count,
    .bytes = bytes,
    .formula_bytes = formula_bytes,
    .transform = transform,
    .area = area,
    .face_normals = face_normals,
    .vertex_normals = vertex_normals,
    .edges = edges,
    .boundary_loops = boundary_loops,
    .smooth = smooth,
    .face_vertices = face_vertices,
    .face_neighbours = face_neighbours,
    .faces_around_vertex = faces_around_vertex,
    .vertices_around_vertex = vertices_around_vertex,
    .is_edge = is_edge,
};
