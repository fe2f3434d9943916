/* Indexed strips as a representation; see indexed_strips.h. */
#include "reference/representation/indexed_strips.h"

#include "reference/mesh/strips.h"
#include "reference/representation/by_faces.h"
#include "reference/representation/by_mesh.h"
#include "reference/representation/strip_faces.h"
#include "reference/representation/triangle_sweeps.h"

#include <stdlib.h>
#include <string.h>

/* -- life ------------------------------------------------------------------------------------- */

static void release(void *self)
{
    struct indexed_strips *strips = self;
    free(strips->positions);
    free(strips->starts);
    free(strips->indices);
    *strips = (struct indexed_strips){0};
}

static int build(void *self, const struct mesh *mesh, struct error *err)
{
    struct indexed_strips *strips = self;
    *strips = (struct indexed_strips){0};
    struct strip_numbers numbers;
    if (strip_numbers_from_mesh(&numbers, mesh, err))
        return -1;
    size_t indices = (size_t)numbers.index_count;
    strips->positions = malloc(12 * (size_t)mesh->vertex_count + 1);
    strips->starts = malloc(4 * ((size_t)numbers.strip_count + 1));
    strips->indices = malloc(4 * indices + 1);
    bool ok = strips->positions && strips->starts && strips->indices;
    if (ok) {
        strips->vertex_count = mesh->vertex_count;
        strips->strip_count = numbers.strip_count;
        strips->index_count = (int32_t)indices;
        if (mesh->vertex_count > 0)
            memcpy(strips->positions, mesh->positions, 12 * (size_t)mesh->vertex_count);
        memcpy(strips->indices, numbers.indices, 4 * indices);
        strips->starts[0] = 0;
        for (int64_t s = 0; s < numbers.strip_count; s++)
            strips->starts[s + 1] = strips->starts[s] + numbers.lengths[s];
    }
    strip_numbers_release(&numbers);
    if (ok)
        return 0;
    release(self);
    return error_set(err, "out of memory: strips of %zu indices", indices);
}

static int check(const void *self, struct error *err)
{
    const struct indexed_strips *strips = self;
    if (positions_check(strips->positions, strips->vertex_count, err))
        return -1;
    for (int64_t s = 0; s < strips->strip_count; s++) {
        int64_t first = strips->starts[s], end = strips->starts[s + 1];
        if ((s == 0 && first != 0) || end > strips->index_count || end - first < 3)
            return error_set(err, "strip %lld has entries %lld to %lld of %d: at least 3 expected",
                             (long long)s, (long long)first, (long long)end - 1,
                             strips->index_count);
        for (int64_t i = first; i < end; i++)
            if (strips->indices[i] < 0 || strips->indices[i] >= strips->vertex_count)
                return error_set(err, "strip %lld names vertex %d of %d", (long long)s,
                                 strips->indices[i], strips->vertex_count);
    }
    if (strips->starts[strips->strip_count] != strips->index_count)
        return error_set(err, "the strips end at entry %d of %d",
                         strips->starts[strips->strip_count], strips->index_count);
    return 0;
}

static int32_t vertex_count(const void *self)
{
    const struct indexed_strips *strips = self;
    return strips->vertex_count;
}

static int32_t face_count(const void *self)
{
    const struct indexed_strips *strips = self;
    return strips->index_count - 2 * strips->strip_count;
}

static int to_mesh(const void *self, struct mesh *mesh, struct error *err)
{
    const struct indexed_strips *strips = self;
    return faces_to_mesh(&representation_indexed_strips, self, strips->positions, mesh, err);
}

static void count_strips(const void *self, struct mesh_counts *counts)
{
    const struct indexed_strips *strips = self;
    counts->strips = strips->strip_count;
    counts->strip_vertices = strips->index_count;
}

static int64_t formula_bytes(const struct mesh_counts *counts)
{
    return 12 * counts->vertices + 4 * counts->strips + 4 * counts->strip_vertices + 4;
}

static int64_t bytes(const void *self)
{
    struct mesh_counts counts = {.vertices = vertex_count(self)};
    count_strips(self, &counts);
    return formula_bytes(&counts);
}

/* -- sweeps ----------------------------------------------------------------------------------- */

static int64_t transform(void *self, const float matrix[12])
{
    struct indexed_strips *strips = self;
    return positions_transform(strips->positions, strips->vertex_count, matrix);
}

static double area(const void *self)
{
    const struct indexed_strips *strips = self;
    return faces_area(&representation_indexed_strips, self, strips->positions);
}

static void face_normals(const void *self, float *normals)
{
    const struct indexed_strips *strips = self;
    faces_normals(&representation_indexed_strips, self, strips->positions, normals);
}

static int vertex_normals(const void *self, float *normals, struct error *err)
{
    const struct indexed_strips *strips = self;
    (void)err;
    faces_vertex_normals(&representation_indexed_strips, self, strips->positions, normals);
    return 0;
}

static int64_t edges(const void *self, int32_t *pairs, struct error *err)
{
    return by_mesh_edges(&representation_indexed_strips, self, pairs, err);
}

static int32_t boundary_loops(const void *self, int32_t *vertices, int32_t *loop_starts,
                              struct error *err)
{
    return by_mesh_boundary_loops(&representation_indexed_strips, self, vertices, loop_starts, err);
}

static int smooth(void *self, struct error *err)
{
    struct indexed_strips *strips = self;
    return by_mesh_smooth(&representation_indexed_strips, self, strips->positions, err);
}

/* -- queries ---------------------------------------------------------------------------------- */

static void face_vertices(const void *self, int32_t first, int32_t count, int32_t *corners)
{
    const struct indexed_strips *strips = self;
    const int32_t *indices = strips->indices;
    strip_faces(strips->starts, strips->strip_count, first, count, corners);
    for (int64_t i = 0; i < 3 * (int64_t)count; i++)
        corners[i] = indices[corners[i]];
}

static int32_t face_neighbours(const void *self, int32_t face, int32_t neighbours[3])
{
    return faces_search_face_neighbours(&representation_indexed_strips, self, NULL, face,
                                        neighbours);
}

static int32_t faces_around_vertex(const void *self, int32_t vertex, int32_t *faces,
                                   int32_t capacity)
{
    return faces_search_faces_around(&representation_indexed_strips, self, NULL, vertex, faces,
                                     capacity);
}

static int32_t vertices_around_vertex(const void *self, int32_t vertex, int32_t *vertices,
                                      int32_t capacity)
{
    return faces_search_vertices_around(&representation_indexed_strips, self, vertex, vertices,
                                        capacity);
}

static bool is_edge(const void *self, int32_t u, int32_t v)
{
    return faces_search_edge(&representation_indexed_strips, self, NULL, u, v);
}

const struct representation representation_indexed_strips = {
    .order = 50,
    .name = "indexed-strips",
    .title = "Indexed strips",
    .documents = "000, 002",
    .struct_bytes = sizeof(struct indexed_strips),
    .holds = FEATURE_ALL,
    .cost = {[QUERY_FACE_VERTICES] = "lg s",
             [QUERY_FACE_NEIGHBOURS] = "n",
             [QUERY_FACES_AROUND_VERTEX] = "n",
             [QUERY_VERTICES_AROUND_VERTEX] = "n",
             [QUERY_IS_EDGE] = "n"},
    .tables = {{offsetof(struct indexed_strips, positions), 3 * sizeof(float)},
               {offsetof(struct indexed_strips, starts), sizeof(int32_t)},
               {offsetof(struct indexed_strips, indices), sizeof(int32_t)}},
    .build = build,
    .release = release,
    .check = check,
    .to_mesh = to_mesh,
    .vertex_count = vertex_count,
    .face_count = face_count,
    .bytes = bytes,
    .formula_bytes = formula_bytes,
    .count_strips = count_strips,
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
