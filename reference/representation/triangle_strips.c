/* Triangle strips as a representation; see triangle_strips.h. */
#include "reference/representation/triangle_strips.h"

#include "reference/representation/by_faces.h"
#include "reference/representation/by_mesh.h"
#include "reference/representation/mesh_sweeps.h"
#include "reference/representation/strip_faces.h"
#include "reference/representation/triangle_sweeps.h"

#include <string.h>

static int build(void *self, const struct mesh *mesh, struct error *err)
{
    memset(self, 0, sizeof(struct strips));
    if (mesh_refuse_isolated(mesh, "a set of strips", err))
        return -1;
    return strips_from_mesh(self, mesh, err);
}

static void release(void *self)
{
    struct strips *strips = self;
    strips_release(strips);
}

static int check(const void *self, struct error *err)
{
    const struct strips *strips = self;
    return strips_check(strips, err);
}

static int to_mesh(const void *self, struct mesh *mesh, struct error *err)
{
    return strips_to_mesh(mesh, self, err);
}

static int32_t vertex_count(const void *self)
{
    const struct strips *strips = self;
    return strips->vertex_count;
}

static int32_t face_count(const void *self)
{
    const struct strips *strips = self;
    return (int32_t)strips_triangle_count(strips);
}

static void count_strips(const void *self, struct mesh_counts *counts)
{
    const struct strips *strips = self;
    counts->strips = strips->strip_count;
    counts->strip_vertices = strips->vertex_count;
}

static int64_t formula_bytes(const struct mesh_counts *counts)
{
    return 4 + 4 * counts->strips + 12 * counts->strip_vertices;
}

static int64_t bytes(const void *self)
{
    struct mesh_counts counts = {0};
    count_strips(self, &counts);
    return formula_bytes(&counts);
}

static int vertex_names(const void *self, const struct mesh *mesh, int32_t *names,
                        struct error *err)
{
    return lowest_corners(&representation_triangle_strips, self, mesh, names, err);
}

/* -- sweeps ----------------------------------------------------------------------------------- */

static int64_t transform(void *self, const float matrix[12])
{
    struct strips *strips = self;
    return positions_transform(strips->positions, vertex_count(self), matrix);
}

static double area(const void *self)
{
    const struct strips *strips = self;
    return faces_area(&representation_triangle_strips, self, strips->positions);
}

static void face_normals(const void *self, float *normals)
{
    const struct strips *strips = self;
    faces_normals(&representation_triangle_strips, self, strips->positions, normals);
}

static int vertex_normals(const void *self, float *normals, struct error *err)
{
    return by_mesh_vertex_normals(&representation_triangle_strips, self, normals, err);
}

static int64_t edges(const void *self, int32_t *pairs, struct error *err)
{
    return by_mesh_edges(&representation_triangle_strips, self, pairs, err);
}

static int32_t boundary_loops(const void *self, int32_t *vertices, int32_t *loop_starts,
                              struct error *err)
{
    return by_mesh_boundary_loops(&representation_triangle_strips, self, vertices, loop_starts,
                                  err);
}

static int smooth(void *self, struct error *err)
{
    struct strips *strips = self;
    return by_mesh_smooth(&representation_triangle_strips, self, strips->positions, err);
}

/* -- queries ---------------------------------------------------------------------------------- */

static void face_vertices(const void *self, int32_t first, int32_t count, int32_t *corners)
{
    const struct strips *strips = self;
    strip_faces(strips->first_vertex, strips->strip_count, first, count, corners);
}

static int32_t face_neighbours(const void *self, int32_t face, int32_t neighbours[3])
{
    const struct strips *strips = self;
    return faces_search_face_neighbours(&representation_triangle_strips, self, strips->positions,
                                        face, neighbours);
}

static int32_t faces_around_vertex(const void *self, int32_t vertex, int32_t *faces,
                                   int32_t capacity)
{
    const struct strips *strips = self;
    return faces_search_faces_around(&representation_triangle_strips, self, strips->positions,
                                     vertex, faces, capacity);
}

static int32_t vertices_around_vertex(const void *self, int32_t vertex, int32_t *vertices,
                                      int32_t capacity)
{
    const struct strips *strips = self;
    return by_mesh_vertices_around(&representation_triangle_strips, self, strips->positions, vertex,
                                   vertices, capacity);
}

static bool is_edge(const void *self, int32_t u, int32_t v)
{
    const struct strips *strips = self;
    return faces_search_edge(&representation_triangle_strips, self, strips->positions, u, v);
}

const struct representation representation_triangle_strips = {
    .order = 20,
    .name = "triangle-strips",
    .title = "Triangle strips",
    .documents = "000, 002, 004",
    .struct_bytes = sizeof(struct strips),
    .holds = FEATURE_ALL & ~(unsigned)FEATURE_ISOLATED_VERTEX,
    .cost = {[QUERY_FACE_VERTICES] = "lg s",
             [QUERY_FACE_NEIGHBOURS] = "n",
             [QUERY_FACES_AROUND_VERTEX] = "n",
             [QUERY_VERTICES_AROUND_VERTEX] = "n",
             [QUERY_IS_EDGE] = "n"},
    .tables = {{offsetof(struct strips, positions), 3 * sizeof(float)},
               {offsetof(struct strips, first_vertex), sizeof(int32_t)}},
    .build = build,
    .release = release,
    .check = check,
    .to_mesh = to_mesh,
    .vertex_count = vertex_count,
    .face_count = face_count,
    .bytes = bytes,
    .formula_bytes = formula_bytes,
    .count_strips = count_strips,
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
