/* Extended edge list as a representation; see extended_edge_list.h. */
#include "reference/representation/extended_edge_list.h"

#include "reference/representation/by_faces.h"
#include "reference/representation/edge_numbers.h"
#include "reference/representation/triangle_sweeps.h"

#include <stdlib.h>
#include <string.h>

/* -- life ------------------------------------------------------------------------------------- */

static void release(void *self)
{
    struct extended_edge_list *list = self;
    free(list->positions);
    free(list->edges.table);
    free(list->face_edges);
    *list = (struct extended_edge_list){0};
}

/* Gives every side of the mesh to its edge. */
static int fill_edges(struct extended_edge_list *list, const struct mesh *mesh, struct error *err)
{
    for (int64_t e = 0; e < list->edges.count; e++)
        list->edges.table[e].left = list->edges.table[e].right = -1;
    for (int64_t side = 0; side < 3 * (int64_t)mesh->triangle_count; side++) {
        int32_t to = mesh->triangles[side % 3 == 2 ? side - 2 : side + 1];
        if (two_sided_edge_add(&list->edges.table[list->face_edges[side]], mesh->triangles[side],
                               to, (int32_t)(side / 3), err))
            return -1;
    }
    return 0;
}

static int build(void *self, const struct mesh *mesh, struct error *err)
{
    struct extended_edge_list *list = self;
    *list = (struct extended_edge_list){0};
    int64_t edge_count = edge_numbers_of_mesh(mesh, &list->face_edges, err);
    if (edge_count < 0)
        return -1;
    list->positions = malloc(12 * (size_t)mesh->vertex_count + 1);
    list->edges.table = malloc((size_t)edge_count * sizeof *list->edges.table + 1);
    list->edges.count = (int32_t)edge_count;
    list->edges.vertex_count = mesh->vertex_count;
    list->edges.face_count = mesh->triangle_count;
    if (!list->positions || !list->edges.table) {
        release(self);
        return error_set(err, "out of memory: a list of %lld edges", (long long)edge_count);
    }
    if (mesh->vertex_count > 0)
        memcpy(list->positions, mesh->positions, 12 * (size_t)mesh->vertex_count);
    if (fill_edges(list, mesh, err) == 0)
        return 0;
    release(self);
    return -1;
}

static int32_t vertex_count(const void *self)
{
    const struct extended_edge_list *list = self;
    return list->edges.vertex_count;
}

static int32_t face_count(const void *self)
{
    const struct extended_edge_list *list = self;
    return list->edges.face_count;
}

static int to_mesh(const void *self, struct mesh *mesh, struct error *err)
{
    const struct extended_edge_list *list = self;
    return faces_to_mesh(&representation_extended_edge_list, self, list->positions, mesh, err);
}

static int64_t bytes(const void *self)
{
    const struct extended_edge_list *list = self;
    return 12 * (int64_t)list->edges.vertex_count + 16 * (int64_t)list->edges.count +
           12 * (int64_t)list->edges.face_count;
}

static int64_t formula_bytes(const struct mesh_counts *counts)
{
    return 12 * counts->vertices + 16 * counts->edges + 12 * counts->triangles;
}

/* Edges of face f are in range, have f at a side, and each starts where the one before ends. */
static int check_face(const struct extended_edge_list *list, int64_t f, struct error *err)
{
    const int32_t *own = list->face_edges + 3 * f;
    for (int i = 0; i < 3; i++) {
        if (own[i] < 0 || own[i] >= list->edges.count)
            return error_set(err, "face %lld names edge %d of %d", (long long)f, own[i],
                             list->edges.count);
        const struct two_sided_edge *edge = &list->edges.table[own[i]];
        if (edge->left != f && edge->right != f)
            return error_set(err, "face %lld names edge %d, which has faces %d and %d",
                             (long long)f, own[i], edge->left, edge->right);
    }
    for (int i = 0; i < 3; i++) {
        const struct two_sided_edge *edge = &list->edges.table[own[i]];
        int32_t start = side_start(edge, (int32_t)f), end = edge->from + edge->to - start;
        if (end != side_start(&list->edges.table[own[(i + 1) % 3]], (int32_t)f))
            return error_set(err, "face %lld: edge %d does not start where edge %d ends",
                             (long long)f, own[(i + 1) % 3], own[i]);
    }
    return 0;
}

static int check(const void *self, struct error *err)
{
    const struct extended_edge_list *list = self;
    if (positions_check(list->positions, list->edges.vertex_count, err))
        return -1;
    if (two_sided_edges_check(&list->edges, err))
        return -1;
    int64_t sides = 0;
    for (int64_t e = 0; e < list->edges.count; e++)
        sides += 1 + (list->edges.table[e].right >= 0);
    for (int64_t f = 0; f < list->edges.face_count; f++)
        if (check_face(list, f, err))
            return -1;
    if (sides != 3 * (int64_t)list->edges.face_count)
        return error_set(err, "edges have %lld sides in all, %d faces have three each",
                         (long long)sides, list->edges.face_count);
    return 0;
}

/* -- sweeps ----------------------------------------------------------------------------------- */

static int64_t transform(void *self, const float matrix[12])
{
    struct extended_edge_list *list = self;
    return positions_transform(list->positions, list->edges.vertex_count, matrix);
}

static double area(const void *self)
{
    const struct extended_edge_list *list = self;
    return faces_area(&representation_extended_edge_list, self, list->positions);
}

static void face_normals(const void *self, float *normals)
{
    const struct extended_edge_list *list = self;
    faces_normals(&representation_extended_edge_list, self, list->positions, normals);
}

static int vertex_normals(const void *self, float *normals, struct error *err)
{
    const struct extended_edge_list *list = self;
    (void)err;
    faces_vertex_normals(&representation_extended_edge_list, self, list->positions, normals);
    return 0;
}

static int64_t edges(const void *self, int32_t *pairs, struct error *err)
{
    const struct extended_edge_list *list = self;
    (void)err;
    return two_sided_pairs(&list->edges, pairs);
}

static int32_t boundary_loops(const void *self, int32_t *vertices, int32_t *loop_starts,
                              struct error *err)
{
    const struct extended_edge_list *list = self;
    return two_sided_boundary(&list->edges, vertices, loop_starts, err);
}

static int smooth(void *self, struct error *err)
{
    struct extended_edge_list *list = self;
    return two_sided_smooth(&list->edges, list->positions, err);
}

/* -- queries ---------------------------------------------------------------------------------- */

static void face_vertices(const void *self, int32_t first, int32_t count, int32_t *corners)
{
    const struct extended_edge_list *list = self;
    for (int32_t f = first; f < first + count; f++)
        for (int i = 0; i < 3; i++)
            *corners++ = side_start(&list->edges.table[list->face_edges[3 * (int64_t)f + i]], f);
}

static int32_t face_neighbours(const void *self, int32_t face, int32_t neighbours[3])
{
    const struct extended_edge_list *list = self;
    int32_t found = 0;
    for (int i = 0; i < 3; i++) {
        neighbours[i] =
            face_across(&list->edges.table[list->face_edges[3 * (int64_t)face + i]], face);
        found += neighbours[i] >= 0;
    }
    return found;
}

static int32_t faces_around_vertex(const void *self, int32_t vertex, int32_t *faces,
                                   int32_t capacity)
{
    const struct extended_edge_list *list = self;
    return two_sided_faces_around(&list->edges, vertex, faces, capacity);
}

static int32_t vertices_around_vertex(const void *self, int32_t vertex, int32_t *vertices,
                                      int32_t capacity)
{
    const struct extended_edge_list *list = self;
    return two_sided_vertices_around(&list->edges, vertex, vertices, capacity);
}

static bool is_edge(const void *self, int32_t u, int32_t v)
{
    const struct extended_edge_list *list = self;
    return two_sided_is_edge(&list->edges, u, v);
}

const struct representation representation_extended_edge_list = {
    .order = 70,
    .name = "extended-edge-list",
    .title = "Extended edge list",
    .documents = "004",
    .struct_bytes = sizeof(struct extended_edge_list),
    .holds = FEATURE_BOUNDARY | FEATURE_ISOLATED_VERTEX | FEATURE_NONMANIFOLD_VERTEX,
    .cost = {[QUERY_FACE_VERTICES] = "1",
             [QUERY_FACE_NEIGHBOURS] = "1",
             [QUERY_FACES_AROUND_VERTEX] = "n",
             [QUERY_VERTICES_AROUND_VERTEX] = "n",
             [QUERY_IS_EDGE] = "n"},
    .tables = {{offsetof(struct extended_edge_list, positions), 3 * sizeof(float)},
               {offsetof(struct extended_edge_list, edges.table), sizeof(struct two_sided_edge)},
               {offsetof(struct extended_edge_list, face_edges), 3 * sizeof(int32_t)}},
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
