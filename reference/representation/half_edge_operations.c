/* Half edges as one representation among others; see half_edge.h and representation.h. */
#include "reference/representation/by_faces.h"
#include "reference/representation/half_edge.h"
#include "reference/representation/triangle_sweeps.h"
#include "reference/representation/vector.h"
#include "reference/representation/vertex_walk.h"

extern const struct representation representation_half_edge;

/* -- life and size -------------------------------------------------------------------------- */

static int build(void *self, const struct mesh *mesh, struct error *err)
{
    struct polygons polygons = polygons_of_mesh(mesh);
    return half_edge_build(self, &polygons, mesh->positions, err);
}

static void release(void *self)
{
    half_edge_release(self);
}

static int check(const void *self, struct error *err)
{
    return half_edge_check(self, err);
}

static int to_mesh(const void *self, struct mesh *mesh, struct error *err)
{
    return half_edge_to_mesh(self, mesh, err);
}

static int32_t vertex_count(const void *self)
{
    return ((const struct half_edge_mesh *)self)->vertex_count;
}

static int32_t face_count(const void *self)
{
    return ((const struct half_edge_mesh *)self)->face_count;
}

static int64_t table_bytes(int64_t vertices, int64_t faces, int64_t half_edges)
{
    return vertices * (int64_t)(3 * sizeof(float) + sizeof(int32_t)) +
           faces * (int64_t)sizeof(int32_t) + half_edges * (int64_t)sizeof(struct half_edge);
}

static int64_t bytes(const void *self)
{
    const struct half_edge_mesh *he = self;
    return table_bytes(he->vertex_count, he->face_count, he->half_edge_count);
}

static int64_t formula_bytes(const struct mesh_counts *counts)
{
    return 16 * counts->vertices + 32 * counts->edges + 4 * counts->triangles;
}

/* -- sweeps --------------------------------------------------------------------------------- */

static void face_vertices(const void *self, int32_t first, int32_t count, int32_t *corners)
{
    const struct half_edge_mesh *he = self;
    for (int32_t f = first; f < first + count; f++) {
        struct half_edge a = he->half_edges[he->face_half_edge[f]];
        struct half_edge b = he->half_edges[a.next];
        *corners++ = a.origin;
        *corners++ = b.origin;
        *corners++ = he->half_edges[b.next].origin;
    }
}

static int64_t transform(void *self, const float matrix[12])
{
    const struct half_edge_mesh *he = self;
    return positions_transform(he->positions, he->vertex_count, matrix);
}

static double area(const void *self)
{
    return faces_area(&representation_half_edge, self,
                      ((const struct half_edge_mesh *)self)->positions);
}

static void face_normals(const void *self, float *normals)
{
    const struct half_edge_mesh *he = self;
    faces_normals(&representation_half_edge, self, he->positions, normals);
}

static int vertex_normals(const void *self, float *normals, struct error *err)
{
    (void)err;
    const struct half_edge_mesh *he = self;
    faces_vertex_normals(&representation_half_edge, self, he->positions, normals);
    return 0;
}

/* Each edge from the one of its halves that has the lower number. */
static int64_t edges(const void *self, int32_t *pairs, struct error *err)
{
    (void)err;
    const struct half_edge_mesh *he = self;
    int64_t count = 0;
    for (int32_t h = 0; h < he->half_edge_count; h++) {
        struct half_edge half = he->half_edges[h];
        if (half.twin < h)
            continue;
        int32_t end = he->half_edges[half.twin].origin;
        pairs[2 * count] = half.origin < end ? half.origin : end;
        pairs[2 * count++ + 1] = half.origin < end ? end : half.origin;
    }
    return count;
}

/* From a vertex of the boundary its half edge leads on, the way the faces run. */
static int32_t next_on_boundary(const void *self, int32_t vertex)
{
    const struct half_edge_mesh *he = self;
    return half_edge_end(he, he->vertex_half_edge[vertex]);
}

static bool is_on_boundary(const void *self, int32_t vertex)
{
    const struct half_edge_mesh *he = self;
    return half_edge_on_boundary(he, vertex);
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
    const struct half_edge_mesh *he = self;
    struct vector sum = {0.0, 0.0, 0.0};
    int32_t first = he->vertex_half_edge[vertex], h = first, count = 0;
    do {
        struct half_edge twin = he->half_edges[he->half_edges[h].twin];
        sum = vector_add(sum, vector_at(he->positions, twin.origin));
        count++;
        h = twin.next;
    } while (h != first);
    return vector_scale(sum, 1.0 / count);
}

static bool is_inside(const void *self, int32_t vertex)
{
    const struct half_edge_mesh *he = self;
    return he->vertex_half_edge[vertex] >= 0 && !half_edge_on_boundary(he, vertex);
}

static int smooth(void *self, struct error *err)
{
    const struct half_edge_mesh *he = self;
    return walk_smooth(self, he->positions, he->vertex_count, is_inside, mean_around, err);
}

/* -- queries -------------------------------------------------------------------------------- */

static int32_t face_neighbours(const void *self, int32_t face, int32_t neighbours[3])
{
    const struct half_edge_mesh *he = self;
    int32_t h = he->face_half_edge[face], count = 0;
    for (int i = 0; i < 3; i++) {
        struct half_edge half = he->half_edges[h];
        neighbours[i] = he->half_edges[half.twin].face;
        count += neighbours[i] >= 0;
        h = half.next;
    }
    return count;
}

static int32_t faces_around_vertex(const void *self, int32_t vertex, int32_t *faces,
                                   int32_t capacity)
{
    const struct half_edge_mesh *he = self;
    int32_t first = he->vertex_half_edge[vertex], h = first, count = 0;
    if (first < 0)
        return 0;
    do {
        if (count < capacity)
            faces[count] = he->half_edges[h].face;
        count++;
        h = half_edge_turn_left(he, h);
    } while (h != first && he->half_edges[h].face >= 0);
    return count;
}

static int32_t vertices_around_vertex(const void *self, int32_t vertex, int32_t *vertices,
                                      int32_t capacity)
{
    const struct half_edge_mesh *he = self;
    int32_t count = half_edge_outgoing(he, vertex, vertices, capacity);
    for (int32_t i = 0; i < count && i < capacity; i++)
        vertices[i] = half_edge_end(he, vertices[i]);
    return count;
}

static bool is_edge(const void *self, int32_t u, int32_t v)
{
    return half_edge_find(self, u, v) >= 0;
}

const struct representation representation_half_edge = {
    .order = 90,
    .name = "half-edge",
    .title = "Half edge",
    .documents = "001, 004",
    .struct_bytes = sizeof(struct half_edge_mesh),
    .holds = FEATURE_BOUNDARY | FEATURE_ISOLATED_VERTEX,
    .cost = {[QUERY_FACE_VERTICES] = "k",
             [QUERY_FACE_NEIGHBOURS] = "k",
             [QUERY_FACES_AROUND_VERTEX] = "k",
             [QUERY_VERTICES_AROUND_VERTEX] = "k",
             [QUERY_IS_EDGE] = "k"},
    .tables = {{offsetof(struct half_edge_mesh, positions), 3 * sizeof(float)},
               {offsetof(struct half_edge_mesh, vertex_half_edge), sizeof(int32_t)},
               {offsetof(struct half_edge_mesh, face_half_edge), sizeof(int32_t)},
               {offsetof(struct half_edge_mesh, half_edges), sizeof(struct half_edge)}},
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
