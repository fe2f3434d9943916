/* The indexed mesh as a representation; see indexed_mesh.h. */
#include "reference/representation/indexed_mesh.h"

#include "reference/representation/by_faces.h"
#include "reference/representation/mesh_sweeps.h"
#include "reference/representation/triangle_sweeps.h"

#include <string.h>

static int build(void *self, const struct mesh *mesh, struct error *err)
{
    return mesh_copy(self, mesh, err);
}

static void release(void *self)
{
    mesh_release(self);
}

static int check(const void *self, struct error *err)
{
    return mesh_check(self, err);
}

static int to_mesh(const void *self, struct mesh *mesh, struct error *err)
{
    return mesh_copy(mesh, self, err);
}

static int32_t vertex_count(const void *self)
{
    const struct mesh *mesh = self;
    return mesh->vertex_count;
}

static int32_t face_count(const void *self)
{
    const struct mesh *mesh = self;
    return mesh->triangle_count;
}

static int64_t bytes(const void *self)
{
    return mesh_bytes(vertex_count(self), face_count(self));
}

static int64_t formula_bytes(const struct mesh_counts *counts)
{
    return 12 * counts->vertices + 12 * counts->triangles;
}

/* -- sweeps ----------------------------------------------------------------------------------- */

static int64_t transform(void *self, const float matrix[12])
{
    struct mesh *mesh = self;
    return positions_transform(mesh->positions, mesh->vertex_count, matrix);
}

static double area(const void *self)
{
    const struct mesh *mesh = self;
    return triangles_area(mesh->positions, mesh->triangles, mesh->triangle_count);
}

static void face_normals(const void *self, float *normals)
{
    const struct mesh *mesh = self;
    triangles_normals(mesh->positions, mesh->triangles, mesh->triangle_count, normals);
}

static int vertex_normals(const void *self, float *normals, struct error *err)
{
    (void)err;
    mesh_vertex_normals(self, normals);
    return 0;
}

static int64_t edges(const void *self, int32_t *pairs, struct error *err)
{
    return mesh_edges(self, pairs, err);
}

static int32_t boundary_loops(const void *self, int32_t *vertices, int32_t *loop_starts,
                              struct error *err)
{
    return mesh_boundary_loops(self, vertices, loop_starts, err);
}

static int smooth(void *self, struct error *err)
{
    return mesh_smooth(self, err);
}

/* -- queries ---------------------------------------------------------------------------------- */

static void face_vertices(const void *self, int32_t first, int32_t count, int32_t *corners)
{
    const struct mesh *mesh = self;
    memcpy(corners, mesh->triangles + 3 * (int64_t)first, 12 * (size_t)count);
}

static int32_t face_neighbours(const void *self, int32_t face, int32_t neighbours[3])
{
    return faces_search_face_neighbours(&representation_indexed_mesh, self, NULL, face, neighbours);
}

static int32_t faces_around_vertex(const void *self, int32_t vertex, int32_t *faces,
                                   int32_t capacity)
{
    return faces_search_faces_around(&representation_indexed_mesh, self, NULL, vertex, faces,
                                     capacity);
}

static int32_t vertices_around_vertex(const void *self, int32_t vertex, int32_t *vertices,
                                      int32_t capacity)
{
    return faces_search_vertices_around(&representation_indexed_mesh, self, vertex, vertices,
                                        capacity);
}

static bool is_edge(const void *self, int32_t u, int32_t v)
{
    return faces_search_edge(&representation_indexed_mesh, self, NULL, u, v);
}

const struct representation representation_indexed_mesh = {
    .order = 40,
    .name = "indexed-mesh",
    .title = "Indexed mesh",
    .documents = "000, 002, 004",
    .struct_bytes = sizeof(struct mesh),
    .holds = FEATURE_ALL,
    .cost = {[QUERY_FACE_VERTICES] = "1",
             [QUERY_FACE_NEIGHBOURS] = "n",
             [QUERY_FACES_AROUND_VERTEX] = "n",
             [QUERY_VERTICES_AROUND_VERTEX] = "n",
             [QUERY_IS_EDGE] = "n"},
    .tables = {{offsetof(struct mesh, positions), 3 * sizeof(float)},
               {offsetof(struct mesh, triangles), 3 * sizeof(int32_t)}},
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
