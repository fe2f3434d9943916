/* Face-edge-vertex lists as a representation; see face_edge_vertex.h. */
#include "reference/representation/face_edge_vertex.h"

#include "reference/representation/by_faces.h"
#include "reference/representation/edge_numbers.h"
#include "reference/representation/triangle_sweeps.h"

#include <stdlib.h>
#include <string.h>

/* -- life ------------------------------------------------------------------------------------- */

static void release(void *self)
{
    struct face_edge_vertex *list = self;
    free(list->positions);
    free(list->edges.table);
    free(list->starts);
    free(list->face_edges);
    *list = (struct face_edge_vertex){0};
}

/* Refuses faces of less than three sides or with a vertex twice. `last_face`: of each vertex, the
 * face that had it last; starts at -1. */
static int check_polygons(const struct listed_polygons *polygons, int32_t *last_face,
                          struct error *err)
{
    for (int32_t f = 0; f < polygons->face_count; f++) {
        if (polygons->starts[f + 1] - polygons->starts[f] < 3)
            return error_set(err, "face %d has %d corners: at least 3 are needed", f,
                             polygons->starts[f + 1] - polygons->starts[f]);
        for (int32_t i = polygons->starts[f]; i < polygons->starts[f + 1]; i++) {
            int32_t v = polygons->corners[i];
            if (v < 0 || v >= polygons->vertex_count)
                return error_set(err, "face %d names vertex %d of %d", f, v,
                                 polygons->vertex_count);
            if (last_face[v] == f)
                return error_set(err, "face %d has vertex %d twice", f, v);
            last_face[v] = f;
        }
    }
    return 0;
}

/* Numbers the edges into face_edges; the end of each side is kept in `ends`. */
static int fill_lists(struct face_edge_vertex *list, const struct listed_polygons *polygons,
                      int32_t *ends, struct error *err)
{
    int32_t side_count = polygons->starts[polygons->face_count];
    for (int32_t f = 0; f < polygons->face_count; f++)
        for (int32_t i = polygons->starts[f]; i < polygons->starts[f + 1]; i++)
            ends[i] =
                polygons->corners[i + 1 < polygons->starts[f + 1] ? i + 1 : polygons->starts[f]];
    int64_t edge_count = edge_numbers_make(polygons->corners, ends, side_count,
                                           polygons->vertex_count, list->face_edges, err);
    if (edge_count < 0)
        return -1;
    list->edges.table = malloc((size_t)edge_count * sizeof *list->edges.table + 1);
    if (!list->edges.table)
        return error_set(err, "out of memory: a list of %lld edges", (long long)edge_count);
    list->edges.count = (int32_t)edge_count;
    for (int64_t e = 0; e < edge_count; e++)
        list->edges.table[e].left = list->edges.table[e].right = -1;
    for (int32_t f = 0; f < polygons->face_count; f++)
        for (int32_t i = polygons->starts[f]; i < polygons->starts[f + 1]; i++)
            if (two_sided_edge_add(&list->edges.table[list->face_edges[i]], polygons->corners[i],
                                   ends[i], f, err))
                return -1;
    memcpy(list->starts, polygons->starts, 4 * ((size_t)polygons->face_count + 1));
    if (polygons->vertex_count > 0)
        memcpy(list->positions, polygons->positions, 12 * (size_t)polygons->vertex_count);
    return 0;
}

int face_edge_vertex_from_polygons(struct face_edge_vertex *list,
                                   const struct listed_polygons *polygons, struct error *err)
{
    size_t sides = (size_t)polygons->starts[polygons->face_count];
    size_t vertices = (size_t)polygons->vertex_count;
    *list = (struct face_edge_vertex){0};
    list->positions = malloc(12 * vertices + 1);
    list->starts = malloc(4 * ((size_t)polygons->face_count + 1));
    list->face_edges = malloc(4 * sides + 1);
    list->edges.vertex_count = polygons->vertex_count;
    list->edges.face_count = polygons->face_count;
    list->side_count = (int32_t)sides;
    int32_t *scratch = malloc(4 * (sides > vertices ? sides : vertices) + 1);
    int result = -1;
    if (list->positions && list->starts && list->face_edges && scratch) {
        memset(scratch, 0xff, 4 * vertices);
        if (check_polygons(polygons, scratch, err) == 0)
            result = fill_lists(list, polygons, scratch, err);
    } else {
        error_set(err, "out of memory: lists of %d faces", polygons->face_count);
    }
    free(scratch);
    if (result)
        release(list);
    return result;
}

static int build(void *self, const struct mesh *mesh, struct error *err)
{
    struct face_edge_vertex *list = self;
    *list = (struct face_edge_vertex){0};
    int32_t *starts = malloc(4 * ((size_t)mesh->triangle_count + 1));
    if (!starts)
        return error_set(err, "out of memory: lists of %d faces", mesh->triangle_count);
    for (int32_t f = 0; f <= mesh->triangle_count; f++)
        starts[f] = 3 * f;
    struct listed_polygons polygons = {mesh->positions, starts, mesh->triangles, mesh->vertex_count,
                                       mesh->triangle_count};
    int result = face_edge_vertex_from_polygons(self, &polygons, err);
    free(starts);
    return result;
}

int32_t face_edge_vertex_sides(const struct face_edge_vertex *list, int32_t face)
{
    return list->starts[face + 1] - list->starts[face];
}

void face_edge_vertex_corners(const struct face_edge_vertex *list, int32_t face, int32_t *corners)
{
    for (int32_t i = list->starts[face]; i < list->starts[face + 1]; i++)
        *corners++ = side_start(&list->edges.table[list->face_edges[i]], face);
}

static int32_t vertex_count(const void *self)
{
    const struct face_edge_vertex *list = self;
    return list->edges.vertex_count;
}

static int32_t face_count(const void *self)
{
    const struct face_edge_vertex *list = self;
    return list->edges.face_count;
}

static int to_mesh(const void *self, struct mesh *mesh, struct error *err)
{
    const struct face_edge_vertex *list = self;
    *mesh = (struct mesh){0};
    for (int32_t f = 0; f < list->edges.face_count; f++)
        if (face_edge_vertex_sides(list, f) != 3)
            return error_set(err, "face %d has %d sides: it is no triangle", f,
                             face_edge_vertex_sides(list, f));
    return faces_to_mesh(&representation_face_edge_vertex, self, list->positions, mesh, err);
}

static int64_t bytes(const void *self)
{
    const struct face_edge_vertex *list = self;
    return 12 * (int64_t)list->edges.vertex_count + 16 * (int64_t)list->edges.count +
           4 * ((int64_t)list->edges.face_count + 1) + 4 * (int64_t)list->side_count;
}

static int64_t formula_bytes(const struct mesh_counts *counts)
{
    return 12 * counts->vertices + 16 * counts->edges + 16 * counts->triangles + 4;
}

/* -- check ------------------------------------------------------------------------------------ */

/* Edges of face f are in range and have f at a side. */
static int check_edges_of_face(const struct face_edge_vertex *list, int32_t f, struct error *err)
{
    for (int32_t i = list->starts[f]; i < list->starts[f + 1]; i++) {
        int32_t e = list->face_edges[i];
        if (e < 0 || e >= list->edges.count)
            return error_set(err, "face %d names edge %d of %d", f, e, list->edges.count);
        const struct two_sided_edge *edge = &list->edges.table[e];
        if (edge->left != f && edge->right != f)
            return error_set(err, "face %d names edge %d, which has faces %d and %d", f, e,
                             edge->left, edge->right);
    }
    return 0;
}

/* Each edge of face f starts where the one before ends, at a vertex that the face had not yet. */
static int check_ring_of_face(const struct face_edge_vertex *list, int32_t f, int32_t *last_face,
                              struct error *err)
{
    int32_t previous = list->face_edges[list->starts[f + 1] - 1];
    for (int32_t i = list->starts[f]; i < list->starts[f + 1]; i++) {
        const struct two_sided_edge *before = &list->edges.table[previous];
        int32_t start = side_start(&list->edges.table[list->face_edges[i]], f);
        if (before->from + before->to - side_start(before, f) != start)
            return error_set(err, "face %d: edge %d does not start where edge %d ends", f,
                             list->face_edges[i], previous);
        if (last_face[start] == f)
            return error_set(err, "face %d has vertex %d twice", f, start);
        last_face[start] = f;
        previous = list->face_edges[i];
    }
    return 0;
}

static int check_faces(const struct face_edge_vertex *list, int32_t *last_face, struct error *err)
{
    int64_t sides = 0;
    for (int64_t e = 0; e < list->edges.count; e++)
        sides += 1 + (list->edges.table[e].right >= 0);
    for (int32_t f = 0; f < list->edges.face_count; f++) {
        int64_t first = list->starts[f], end = list->starts[f + 1];
        if ((f == 0 && first != 0) || end - first < 3 || end > list->side_count)
            return error_set(err, "face %d has edges %lld to %lld of %lld: at least 3 expected", f,
                             (long long)first, (long long)end - 1, (long long)list->side_count);
        if (check_edges_of_face(list, f, err) || check_ring_of_face(list, f, last_face, err))
            return -1;
    }
    if (list->starts[list->edges.face_count] != list->side_count || sides != list->side_count)
        return error_set(err, "edges have %lld sides in all, faces %d of %d", (long long)sides,
                         list->starts[list->edges.face_count], list->side_count);
    return 0;
}

static int check(const void *self, struct error *err)
{
    const struct face_edge_vertex *list = self;
    if (positions_check(list->positions, list->edges.vertex_count, err))
        return -1;
    if (two_sided_edges_check(&list->edges, err))
        return -1;
    size_t vertices = (size_t)list->edges.vertex_count;
    int32_t *last_face = malloc(4 * vertices + 1);
    if (!last_face)
        return error_set(err, "out of memory: checking %d faces", list->edges.face_count);
    memset(last_face, 0xff, 4 * vertices);
    int result = check_faces(list, last_face, err);
    free(last_face);
    return result;
}

/* -- sweeps ----------------------------------------------------------------------------------- */

static int64_t transform(void *self, const float matrix[12])
{
    struct face_edge_vertex *list = self;
    return positions_transform(list->positions, list->edges.vertex_count, matrix);
}

static double area(const void *self)
{
    const struct face_edge_vertex *list = self;
    return faces_area(&representation_face_edge_vertex, self, list->positions);
}

static void face_normals(const void *self, float *normals)
{
    const struct face_edge_vertex *list = self;
    faces_normals(&representation_face_edge_vertex, self, list->positions, normals);
}

static int vertex_normals(const void *self, float *normals, struct error *err)
{
    const struct face_edge_vertex *list = self;
    (void)err;
    faces_vertex_normals(&representation_face_edge_vertex, self, list->positions, normals);
    return 0;
}

static int64_t edges(const void *self, int32_t *pairs, struct error *err)
{
    const struct face_edge_vertex *list = self;
    (void)err;
    return two_sided_pairs(&list->edges, pairs);
}

static int32_t boundary_loops(const void *self, int32_t *vertices, int32_t *loop_starts,
                              struct error *err)
{
    const struct face_edge_vertex *list = self;
    return two_sided_boundary(&list->edges, vertices, loop_starts, err);
}

static int smooth(void *self, struct error *err)
{
    struct face_edge_vertex *list = self;
    return two_sided_smooth(&list->edges, list->positions, err);
}

/* -- queries ---------------------------------------------------------------------------------- */

static void face_vertices(const void *self, int32_t first, int32_t count, int32_t *corners)
{
    const struct face_edge_vertex *list = self;
    for (int32_t i = 0; i < count; i++)
        face_edge_vertex_corners(list, first + i, corners + 3 * (int64_t)i);
}

static int32_t face_neighbours(const void *self, int32_t face, int32_t neighbours[3])
{
    const struct face_edge_vertex *list = self;
    int32_t found = 0;
    for (int i = 0; i < 3; i++) {
        int32_t edge = list->face_edges[list->starts[face] + i];
        neighbours[i] = face_across(&list->edges.table[edge], face);
        found += neighbours[i] >= 0;
    }
    return found;
}

static int32_t faces_around_vertex(const void *self, int32_t vertex, int32_t *faces,
                                   int32_t capacity)
{
    const struct face_edge_vertex *list = self;
    return two_sided_faces_around(&list->edges, vertex, faces, capacity);
}

static int32_t vertices_around_vertex(const void *self, int32_t vertex, int32_t *vertices,
                                      int32_t capacity)
{
    const struct face_edge_vertex *list = self;
    return two_sided_vertices_around(&list->edges, vertex, vertices, capacity);
}

static bool is_edge(const void *self, int32_t u, int32_t v)
{
    const struct face_edge_vertex *list = self;
    return two_sided_is_edge(&list->edges, u, v);
}

const struct representation representation_face_edge_vertex = {
    .order = 55,
    .name = "face-edge-vertex",
    .title = "Face-edge-vertex lists",
    .documents = "001",
    .struct_bytes = sizeof(struct face_edge_vertex),
    .holds = FEATURE_BOUNDARY | FEATURE_ISOLATED_VERTEX | FEATURE_NONMANIFOLD_VERTEX,
    .cost = {[QUERY_FACE_VERTICES] = "k",
             [QUERY_FACE_NEIGHBOURS] = "k",
             [QUERY_FACES_AROUND_VERTEX] = "n",
             [QUERY_VERTICES_AROUND_VERTEX] = "n",
             [QUERY_IS_EDGE] = "n"},
    .tables = {{offsetof(struct face_edge_vertex, positions), 3 * sizeof(float)},
               {offsetof(struct face_edge_vertex, edges.table), sizeof(struct two_sided_edge)},
               {offsetof(struct face_edge_vertex, starts), sizeof(int32_t)},
               {offsetof(struct face_edge_vertex, face_edges), sizeof(int32_t)}},
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
