/* The corner table as one representation among others; see corner_table.h and representation.h. */
#include "reference/representation/by_faces.h"
#include "reference/representation/corner_table.h"
#include "reference/representation/triangle_sweeps.h"
#include "reference/representation/vector.h"
#include "reference/representation/vertex_walk.h"

#include <string.h>

extern const struct representation representation_corner_table;

/* -- life and size -------------------------------------------------------------------------- */

static int build(void *self, const struct mesh *mesh, struct error *err)
{
    return corner_table_build(self, mesh, err);
}

static void release(void *self)
{
    corner_table_release(self);
}

static int check(const void *self, struct error *err)
{
    return corner_table_check(self, err);
}

static int to_mesh(const void *self, struct mesh *mesh, struct error *err)
{
    return corner_table_to_mesh(self, mesh, err);
}

static int32_t vertex_count(const void *self)
{
    return ((const struct corner_table *)self)->vertex_count;
}

static int32_t face_count(const void *self)
{
    return ((const struct corner_table *)self)->triangle_count;
}

static int64_t bytes(const void *self)
{
    const struct corner_table *table = self;
    return (int64_t)(3 * sizeof *table->positions + sizeof *table->vertex_corner) *
               table->vertex_count +
           3 * (int64_t)(sizeof *table->vertex + sizeof *table->opposite) * table->triangle_count;
}

static int64_t formula_bytes(const struct mesh_counts *counts)
{
    return 16 * counts->vertices + 24 * counts->triangles;
}

/* -- sweeps --------------------------------------------------------------------------------- */

static void face_vertices(const void *self, int32_t first, int32_t count, int32_t *corners)
{
    const struct corner_table *table = self;
    memcpy(corners, table->vertex + 3 * (int64_t)first, 3 * (size_t)count * sizeof *corners);
}

static int64_t transform(void *self, const float matrix[12])
{
    const struct corner_table *table = self;
    return positions_transform(table->positions, table->vertex_count, matrix);
}

static double area(const void *self)
{
    return faces_area(&representation_corner_table, self,
                      ((const struct corner_table *)self)->positions);
}

static void face_normals(const void *self, float *normals)
{
    const struct corner_table *table = self;
    faces_normals(&representation_corner_table, self, table->positions, normals);
}

static int vertex_normals(const void *self, float *normals, struct error *err)
{
    (void)err;
    const struct corner_table *table = self;
    faces_vertex_normals(&representation_corner_table, self, table->positions, normals);
    return 0;
}

/* Each edge from the one of the corners that face it that has the lower number. */
static int64_t edges(const void *self, int32_t *pairs, struct error *err)
{
    (void)err;
    const struct corner_table *table = self;
    int64_t count = 0;
    for (int32_t c = 0; c < 3 * table->triangle_count; c++) {
        if (table->opposite[c] >= 0 && table->opposite[c] < c)
            continue;
        int32_t u = table->vertex[corner_next(c)], v = table->vertex[corner_previous(c)];
        pairs[2 * count] = u < v ? u : v;
        pairs[2 * count++ + 1] = u < v ? v : u;
    }
    return count;
}

/* On the boundary the corner of a vertex starts the boundary side that leaves it. */
static int32_t next_on_boundary(const void *self, int32_t vertex)
{
    const struct corner_table *table = self;
    return table->vertex[corner_next(table->vertex_corner[vertex])];
}

static bool is_on_boundary(const void *self, int32_t vertex)
{
    const struct corner_table *table = self;
    return corner_table_on_boundary(table, vertex);
}

static int32_t boundary_loops(const void *self, int32_t *vertices, int32_t *loop_starts,
                              struct error *err)
{
    return walk_boundary_loops(self, vertex_count(self), is_on_boundary, next_on_boundary, vertices,
                               loop_starts, err);
}

/* Mean of the vertices around one that is not on the boundary. */
static struct vector mean_around(const void *self, int32_t vertex)
{
    const struct corner_table *table = self;
    struct vector sum = {0.0, 0.0, 0.0};
    int32_t first = table->vertex_corner[vertex], c = first, count = 0;
    do {
        sum = vector_add(sum, vector_at(table->positions, table->vertex[corner_next(c)]));
        count++;
        c = corner_table_swing(table, c);
    } while (c != first);
    return vector_scale(sum, 1.0 / count);
}

static bool is_inside(const void *self, int32_t vertex)
{
    const struct corner_table *table = self;
    return table->vertex_corner[vertex] >= 0 && !corner_table_on_boundary(table, vertex);
}

static int smooth(void *self, struct error *err)
{
    const struct corner_table *table = self;
    return walk_smooth(self, table->positions, table->vertex_count, is_inside, mean_around, err);
}

/* -- queries -------------------------------------------------------------------------------- */

static int32_t face_neighbours(const void *self, int32_t face, int32_t neighbours[3])
{
    const struct corner_table *table = self;
    int32_t count = 0;
    for (int i = 0; i < 3; i++) {
        neighbours[i] = corner_table_across(table, 3 * face + i);
        count += neighbours[i] >= 0;
    }
    return count;
}

static int32_t faces_around_vertex(const void *self, int32_t vertex, int32_t *faces,
                                   int32_t capacity)
{
    const struct corner_table *table = self;
    int32_t first = table->vertex_corner[vertex], c = first, count = 0;
    if (first < 0)
        return 0;
    do {
        if (count < capacity)
            faces[count] = c / 3;
        count++;
        c = corner_table_swing(table, c);
    } while (c >= 0 && c != first);
    return count;
}

/* The next corner of each, and on a boundary the previous one of the last. */
static int32_t vertices_around_vertex(const void *self, int32_t vertex, int32_t *vertices,
                                      int32_t capacity)
{
    const struct corner_table *table = self;
    int32_t first = table->vertex_corner[vertex], c = first, last, count = 0;
    if (first < 0)
        return 0;
    do {
        if (count < capacity)
            vertices[count] = table->vertex[corner_next(c)];
        count++;
        last = c;
        c = corner_table_swing(table, c);
    } while (c >= 0 && c != first);
    if (c >= 0)
        return count;
    if (count < capacity)
        vertices[count] = table->vertex[corner_previous(last)];
    return count + 1;
}

static bool is_edge(const void *self, int32_t u, int32_t v)
{
    const struct corner_table *table = self;
    int32_t first = table->vertex_corner[u], c = first;
    if (first < 0)
        return false;
    do {
        if (table->vertex[corner_next(c)] == v || table->vertex[corner_previous(c)] == v)
            return true;
        c = corner_table_swing(table, c);
    } while (c >= 0 && c != first);
    return false;
}

const struct representation representation_corner_table = {
    .order = 110,
    .name = "corner-table",
    .title = "Corner table",
    .documents = "-",
    .struct_bytes = sizeof(struct corner_table),
    .holds = FEATURE_BOUNDARY | FEATURE_ISOLATED_VERTEX,
    .cost = {[QUERY_FACE_VERTICES] = "1",
             [QUERY_FACE_NEIGHBOURS] = "1",
             [QUERY_FACES_AROUND_VERTEX] = "k",
             [QUERY_VERTICES_AROUND_VERTEX] = "k",
             [QUERY_IS_EDGE] = "k"},
    .tables = {{offsetof(struct corner_table, positions), 3 * sizeof(float)},
               {offsetof(struct corner_table, vertex_corner), sizeof(int32_t)},
               {offsetof(struct corner_table, vertex), 3 * sizeof(int32_t)},
               {offsetof(struct corner_table, opposite), sizeof(int32_t)}},
    .rings_in_order = true,
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
    .is_edge = is_edge};
