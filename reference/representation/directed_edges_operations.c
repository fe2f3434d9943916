/* Directed edges as one representation among others; see directed_edges.h and representation.h. */
#include "reference/representation/by_faces.h"
#include "reference/representation/directed_edges.h"
#include "reference/representation/triangle_sweeps.h"
#include "reference/representation/vector.h"
#include "reference/representation/vertex_walk.h"

#include <stdlib.h>

extern const struct representation representation_directed_edges;

/* -- life and size -------------------------------------------------------------------------- */

static int build(void *self, const struct mesh *mesh, struct error *err)
{
    return directed_edges_build(self, mesh, err);
}

static void release(void *self)
{
    directed_edges_release(self);
}

static int check(const void *self, struct error *err)
{
    return directed_edges_check(self, err);
}

static int to_mesh(const void *self, struct mesh *mesh, struct error *err)
{
    return directed_edges_to_mesh(self, mesh, err);
}

static int32_t vertex_count(const void *self)
{
    return ((const struct directed_edge_mesh *)self)->vertex_count;
}

static int32_t face_count(const void *self)
{
    return ((const struct directed_edge_mesh *)self)->triangle_count;
}

static int64_t bytes(const void *self)
{
    const struct directed_edge_mesh *de = self;
    return (int64_t)(3 * sizeof *de->positions + sizeof *de->vertex_edge) * de->vertex_count +
           3 * (int64_t)sizeof *de->edges * de->triangle_count;
}

static int64_t formula_bytes(const struct mesh_counts *counts)
{
    return 16 * counts->vertices + 24 * counts->triangles;
}

/* -- sweeps --------------------------------------------------------------------------------- */

static void face_vertices(const void *self, int32_t first, int32_t count, int32_t *corners)
{
    const struct directed_edge_mesh *de = self;
    for (int32_t e = 3 * first; e < 3 * (first + count); e++)
        *corners++ = de->edges[e].vertex;
}

static int64_t transform(void *self, const float matrix[12])
{
    const struct directed_edge_mesh *de = self;
    return positions_transform(de->positions, de->vertex_count, matrix);
}

static double area(const void *self)
{
    return faces_area(&representation_directed_edges, self,
                      ((const struct directed_edge_mesh *)self)->positions);
}

static void face_normals(const void *self, float *normals)
{
    const struct directed_edge_mesh *de = self;
    faces_normals(&representation_directed_edges, self, de->positions, normals);
}

static int vertex_normals(const void *self, float *normals, struct error *err)
{
    (void)err;
    const struct directed_edge_mesh *de = self;
    faces_vertex_normals(&representation_directed_edges, self, de->positions, normals);
    return 0;
}

/* Each edge from the lower of its two directed edges, or from the only one. */
static int64_t edges(const void *self, int32_t *pairs, struct error *err)
{
    (void)err;
    const struct directed_edge_mesh *de = self;
    int64_t count = 0;
    for (int32_t e = 0; e < 3 * de->triangle_count; e++) {
        if (de->edges[e].neighbour >= 0 && de->edges[e].neighbour < e)
            continue;
        int32_t u = de->edges[e].vertex, v = de->edges[directed_edge_next(e)].vertex;
        pairs[2 * count] = u < v ? u : v;
        pairs[2 * count++ + 1] = u < v ? v : u;
    }
    return count;
}

/* Boundary edges lead to each other. */
static int32_t boundary_loops(const void *self, int32_t *vertices, int32_t *loop_starts,
                              struct error *err)
{
    const struct directed_edge_mesh *de = self;
    uint8_t *visited = calloc((size_t)de->vertex_count + 1, 1);
    if (!visited)
        return error_set(err, "out of memory: boundary loops of %d vertices", de->vertex_count);
    int32_t count = 0, loops = 0;
    for (int32_t first = 0; first < 3 * de->triangle_count; first++) {
        if (de->edges[first].neighbour >= 0 || visited[de->edges[first].vertex])
            continue;
        loop_starts[loops++] = count;
        for (int32_t e = first; !visited[de->edges[e].vertex]; e = ~de->edges[e].neighbour) {
            visited[de->edges[e].vertex] = 1;
            vertices[count++] = de->edges[e].vertex;
        }
    }
    loop_starts[loops] = count;
    free(visited);
    return loops;
}

/* Mean of the vertices around one that is not on the boundary. */
static struct vector mean_around(const void *self, int32_t vertex)
{
    const struct directed_edge_mesh *de = self;
    struct vector sum = {0.0, 0.0, 0.0};
    int32_t first = de->vertex_edge[vertex], e = first, count = 0;
    do {
        sum = vector_add(sum, vector_at(de->positions, de->edges[directed_edge_next(e)].vertex));
        count++;
        e = directed_edge_turn_left(de, e);
    } while (e != first);
    return vector_scale(sum, 1.0 / count);
}

static bool is_inside(const void *self, int32_t vertex)
{
    const struct directed_edge_mesh *de = self;
    return de->vertex_edge[vertex] >= 0 && !directed_edge_on_boundary(de, vertex);
}

static int smooth(void *self, struct error *err)
{
    const struct directed_edge_mesh *de = self;
    return walk_smooth(self, de->positions, de->vertex_count, is_inside, mean_around, err);
}

/* -- queries -------------------------------------------------------------------------------- */

static int32_t face_neighbours(const void *self, int32_t face, int32_t neighbours[3])
{
    const struct directed_edge_mesh *de = self;
    int32_t count = 0;
    for (int i = 0; i < 3; i++) {
        int32_t across = de->edges[3 * face + i].neighbour;
        neighbours[i] = across < 0 ? -1 : across / 3;
        count += across >= 0;
    }
    return count;
}

static int32_t faces_around_vertex(const void *self, int32_t vertex, int32_t *faces,
                                   int32_t capacity)
{
    const struct directed_edge_mesh *de = self;
    int32_t first = de->vertex_edge[vertex], e = first, count = 0;
    if (first < 0)
        return 0;
    do {
        if (count < capacity)
            faces[count] = e / 3;
        count++;
        e = directed_edge_turn_left(de, e);
    } while (e >= 0 && e != first);
    return count;
}

/* The end of each edge that leaves, and on a boundary the start of the one that comes last. */
static int32_t vertices_around_vertex(const void *self, int32_t vertex, int32_t *vertices,
                                      int32_t capacity)
{
    const struct directed_edge_mesh *de = self;
    int32_t first = de->vertex_edge[vertex], e = first, last, count = 0;
    if (first < 0)
        return 0;
    do {
        if (count < capacity)
            vertices[count] = de->edges[directed_edge_next(e)].vertex;
        count++;
        last = e;
        e = directed_edge_turn_left(de, e);
    } while (e >= 0 && e != first);
    if (e >= 0)
        return count;
    if (count < capacity)
        vertices[count] = de->edges[directed_edge_previous(last)].vertex;
    return count + 1;
}

static bool is_edge(const void *self, int32_t u, int32_t v)
{
    const struct directed_edge_mesh *de = self;
    int32_t first = de->vertex_edge[u], e = first;
    if (first < 0)
        return false;
    do {
        if (de->edges[directed_edge_next(e)].vertex == v ||
            de->edges[directed_edge_previous(e)].vertex == v)
            return true;
        e = directed_edge_turn_left(de, e);
    } while (e >= 0 && e != first);
    return false;
}

const struct representation representation_directed_edges = {
    .order = 120,
    .name = "directed-edges",
    .title = "Directed edges",
    .documents = "-",
    .struct_bytes = sizeof(struct directed_edge_mesh),
    .holds = FEATURE_BOUNDARY | FEATURE_ISOLATED_VERTEX,
    .cost = {[QUERY_FACE_VERTICES] = "1",
             [QUERY_FACE_NEIGHBOURS] = "1",
             [QUERY_FACES_AROUND_VERTEX] = "k",
             [QUERY_VERTICES_AROUND_VERTEX] = "k",
             [QUERY_IS_EDGE] = "k"},
    .tables = {{offsetof(struct directed_edge_mesh, positions), 3 * sizeof(float)},
               {offsetof(struct directed_edge_mesh, vertex_edge), sizeof(int32_t)},
               {offsetof(struct directed_edge_mesh, edges), sizeof(struct directed_edge)}},
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
