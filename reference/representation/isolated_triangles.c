/* Isolated triangles as a representation; see isolated_triangles.h. */
#include "reference/representation/isolated_triangles.h"

#include "reference/representation/by_faces.h"
#include "reference/representation/by_mesh.h"
#include "reference/representation/mesh_sweeps.h"
#include "reference/representation/triangle_sweeps.h"

#include <string.h>

static int build(void *self, const struct mesh *mesh, struct error *err)
{
    memset(self, 0, sizeof(struct soup));
    if (mesh_refuse_isolated(mesh, "a table of isolated triangles", err))
        return -1;
    return soup_from_mesh(self, mesh, err);
}

static void release(void *self)
{
    soup_release(self);
}

static int check(const void *self, struct error *err)
{
    return soup_check(self, err);
}

static int to_mesh(const void *self, struct mesh *mesh, struct error *err)
{
    return soup_to_mesh(mesh, self, err);
}

static int32_t face_count(const void *self)
{
    const struct soup *soup = self;
    return soup->triangle_count;
}

static int32_t vertex_count(const void *self)
{
    return 3 * face_count(self);
}

static int64_t bytes(const void *self)
{
    return soup_bytes(face_count(self));
}

static int64_t formula_bytes(const struct mesh_counts *counts)
{
    return 36 * counts->triangles;
}

static int vertex_names(const void *self, const struct mesh *mesh, int32_t *names,
                        struct error *err)
{
    return lowest_corners(&representation_isolated_triangles, self, mesh, names, err);
}

/* -- sweeps ----------------------------------------------------------------------------------- */

static int64_t transform(void *self, const float matrix[12])
{
    struct soup *soup = self;
    return positions_transform(soup->corners, vertex_count(self), matrix);
}

static double area(const void *self)
{
    const struct soup *soup = self;
    return faces_area(&representation_isolated_triangles, self, soup->corners);
}

static void face_normals(const void *self, float *normals)
{
    const struct soup *soup = self;
    faces_normals(&representation_isolated_triangles, self, soup->corners, normals);
}

static int vertex_normals(const void *self, float *normals, struct error *err)
{
    return by_mesh_vertex_normals(&representation_isolated_triangles, self, normals, err);
}

static int64_t edges(const void *self, int32_t *pairs, struct error *err)
{
    return by_mesh_edges(&representation_isolated_triangles, self, pairs, err);
}

static int32_t boundary_loops(const void *self, int32_t *vertices, int32_t *loop_starts,
                              struct error *err)
{
    return by_mesh_boundary_loops(&representation_isolated_triangles, self, vertices, loop_starts,
                                  err);
}

static int smooth(void *self, struct error *err)
{
    struct soup *soup = self;
    return by_mesh_smooth(&representation_isolated_triangles, self, soup->corners, err);
}

/* -- queries ---------------------------------------------------------------------------------- */

static void face_vertices(const void *self, int32_t first, int32_t count, int32_t *corners)
{
    (void)self;
    for (int32_t i = 0; i < 3 * count; i++)
        corners[i] = 3 * first + i;
}

static int32_t face_neighbours(const void *self, int32_t face, int32_t neighbours[3])
{
    const struct soup *soup = self;
    return faces_search_face_neighbours(&representation_isolated_triangles, self, soup->corners,
                                        face, neighbours);
}

static int32_t faces_around_vertex(const void *self, int32_t vertex, int32_t *faces,
                                   int32_t capacity)
{
    const struct soup *soup = self;
    return faces_search_faces_around(&representation_isolated_triangles, self, soup->corners,
                                     vertex, faces, capacity);
}

static int32_t vertices_around_vertex(const void *self, int32_t vertex, int32_t *vertices,
                                      int32_t capacity)
{
    const struct soup *soup = self;
    return by_mesh_vertices_around(&representation_isolated_triangles, self, soup->corners, vertex,
                                   vertices, capacity);
}

static bool is_edge(const void *self, int32_t u, int32_t v)
{
    const struct soup *soup = self;
    return faces_search_edge(&representation_isolated_triangles, self, soup->corners, u, v);
}

const struct representation representation_isolated_triangles = {
    .order = 10,
    .name = "isolated-triangles",
    .title = "Isolated triangles",
    .documents = "000, 002, 004",
    .struct_bytes = sizeof(struct soup),
    .holds = FEATURE_ALL & ~(unsigned)FEATURE_ISOLATED_VERTEX,
    .cost = {[QUERY_FACE_VERTICES] = "1",
             [QUERY_FACE_NEIGHBOURS] = "n",
             [QUERY_FACES_AROUND_VERTEX] = "n",
             [QUERY_VERTICES_AROUND_VERTEX] = "n",
             [QUERY_IS_EDGE] = "n"},
    .tables = {{offsetof(struct soup, corners), 9 * sizeof(float)}},
    .build = build,
    .release = release,
    .check = check,
    .to_mesh = to_mesh,
    .vertex_count = vertex_count,
    .face_count = face_count,
    .bytes = bytes,
    .formula_bytes = formula_bytes,
    .vertex_names = vertex_names,
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
