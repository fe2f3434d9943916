/* Winged edges as one representation among others; see winged_edge.h and representation.h. */
#include "reference/representation/by_faces.h"
#include "reference/representation/triangle_sweeps.h"
#include "reference/representation/vector.h"
#include "reference/representation/vertex_walk.h"
#include "reference/representation/winged_edge.h"

extern const struct representation representation_winged_edge;

/* -- life and size -------------------------------------------------------------------------- */

static int build(void *self, const struct mesh *mesh, struct error *err)
{
    struct polygons polygons = polygons_of_mesh(mesh);
    return winged_edge_build(self, &polygons, mesh->positions, err);
}

static void release(void *self)
{
    winged_edge_release(self);
}

static int check(const void *self, struct error *err)
{
    return winged_edge_check(self, err);
}

static int to_mesh(const void *self, struct mesh *mesh, struct error *err)
{
    return winged_edge_to_mesh(self, mesh, err);
}

static int32_t vertex_count(const void *self)
{
    return ((const struct winged_edge_mesh *)self)->vertex_count;
}

static int32_t face_count(const void *self)
{
    return ((const struct winged_edge_mesh *)self)->face_count;
}

static int64_t table_bytes(int64_t vertices, int64_t faces, int64_t edges)
{
    return vertices * (int64_t)(3 * sizeof(float) + sizeof(int32_t)) +
           faces * (int64_t)sizeof(int32_t) + edges * (int64_t)sizeof(struct winged_edge);
}

static int64_t bytes(const void *self)
{
    const struct winged_edge_mesh *we = self;
    return table_bytes(we->vertex_count, we->face_count, we->edge_count);
}

static int64_t formula_bytes(const struct mesh_counts *counts)
{
    return 16 * counts->vertices + 32 * counts->edges + 4 * counts->triangles;
}

/* -- sweeps --------------------------------------------------------------------------------- */

static void face_vertices(const void *self, int32_t first, int32_t count, int32_t *corners)
{
    const struct winged_edge_mesh *we = self;
    for (int32_t f = first; f < first + count; f++) {
        struct winged_side side = winged_edge_of_face(we, f);
        *corners++ = winged_edge_start(we, side);
        *corners++ = winged_edge_end(we, side);
        *corners++ = winged_edge_end(we, winged_edge_next(we, side));
    }
}

static int64_t transform(void *self, const float matrix[12])
{
    const struct winged_edge_mesh *we = self;
    return positions_transform(we->positions, we->vertex_count, matrix);
}

static double area(const void *self)
{
    return faces_area(&representation_winged_edge, self,
                      ((const struct winged_edge_mesh *)self)->positions);
}

static void face_normals(const void *self, float *normals)
{
    const struct winged_edge_mesh *we = self;
    faces_normals(&representation_winged_edge, self, we->positions, normals);
}

static int vertex_normals(const void *self, float *normals, struct error *err)
{
    (void)err;
    const struct winged_edge_mesh *we = self;
    faces_vertex_normals(&representation_winged_edge, self, we->positions, normals);
    return 0;
}

static int64_t edges(const void *self, int32_t *pairs, struct error *err)
{
    (void)err;
    const struct winged_edge_mesh *we = self;
    for (int64_t e = 0; e < we->edge_count; e++) {
        int32_t u = we->edges[e].vertex[0], v = we->edges[e].vertex[1];
        pairs[2 * e] = u < v ? u : v;
        pairs[2 * e + 1] = u < v ? v : u;
    }
    return we->edge_count;
}

/* From a vertex of the boundary its edge leads on, the way the faces run. */
static int32_t next_on_boundary(const void *self, int32_t vertex)
{
    const struct winged_edge_mesh *we = self;
    return winged_edge_end(we, winged_edge_of_vertex(we, vertex));
}

static bool is_on_boundary(const void *self, int32_t vertex)
{
    const struct winged_edge_mesh *we = self;
    return winged_edge_on_boundary(we, vertex);
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
    const struct winged_edge_mesh *we = self;
    struct vector sum = {0.0, 0.0, 0.0};
    struct winged_side first = winged_edge_of_vertex(we, vertex), side = first;
    int32_t count = 0;
    do {
        sum = vector_add(sum, vector_at(we->positions, winged_edge_end(we, side)));
        count++;
        side = winged_edge_turn_left(we, side);
    } while (side.edge != first.edge);
    return vector_scale(sum, 1.0 / count);
}

static bool is_inside(const void *self, int32_t vertex)
{
    const struct winged_edge_mesh *we = self;
    return we->vertex_edge[vertex] >= 0 && !winged_edge_on_boundary(we, vertex);
}

static int smooth(void *self, struct error *err)
{
    const struct winged_edge_mesh *we = self;
    return walk_smooth(self, we->positions, we->vertex_count, is_inside, mean_around, err);
}

/* -- queries -------------------------------------------------------------------------------- */

static int32_t face_neighbours(const void *self, int32_t face, int32_t neighbours[3])
{
    const struct winged_edge_mesh *we = self;
    struct winged_side side = winged_edge_of_face(we, face);
    int32_t count = 0;
    for (int i = 0; i < 3; i++) {
        neighbours[i] = winged_edge_face(we, winged_edge_twin(side));
        count += neighbours[i] >= 0;
        side = winged_edge_next(we, side);
    }
    return count;
}

static int32_t faces_around_vertex(const void *self, int32_t vertex, int32_t *faces,
                                   int32_t capacity)
{
    const struct winged_edge_mesh *we = self;
    if (we->vertex_edge[vertex] < 0)
        return 0;
    struct winged_side first = winged_edge_of_vertex(we, vertex), side = first;
    int32_t count = 0;
    do {
        if (count < capacity)
            faces[count] = winged_edge_face(we, side);
        count++;
        side = winged_edge_turn_left(we, side);
    } while (side.edge != first.edge && winged_edge_face(we, side) >= 0);
    return count;
}

static int32_t vertices_around_vertex(const void *self, int32_t vertex, int32_t *vertices,
                                      int32_t capacity)
{
    const struct winged_edge_mesh *we = self;
    if (we->vertex_edge[vertex] < 0)
        return 0;
    struct winged_side first = winged_edge_of_vertex(we, vertex), side = first;
    int32_t count = 0;
    do {
        if (count < capacity)
            vertices[count] = winged_edge_end(we, side);
        count++;
        side = winged_edge_turn_left(we, side);
    } while (side.edge != first.edge);
    return count;
}

static bool is_edge(const void *self, int32_t u, int32_t v)
{
    return winged_edge_find(self, u, v) >= 0;
}

const struct representation representation_winged_edge = {
    .order = 80,
    .name = "winged-edge",
    .title = "Winged edge",
    .documents = "000, 001, 002, 004",
    .struct_bytes = sizeof(struct winged_edge_mesh),
    .holds = FEATURE_BOUNDARY | FEATURE_ISOLATED_VERTEX,
    .cost = {[QUERY_FACE_VERTICES] = "k",
             [QUERY_FACE_NEIGHBOURS] = "k",
             [QUERY_FACES_AROUND_VERTEX] = "k",
             [QUERY_VERTICES_AROUND_VERTEX] = "k",
             [QUERY_IS_EDGE] = "k"},
    .tables = {{offsetof(struct winged_edge_mesh, positions), 3 * sizeof(float)},
               {offsetof(struct winged_edge_mesh, vertex_edge), sizeof(int32_t)},
               {offsetof(struct winged_edge_mesh, face_edge), sizeof(int32_t)},
               {offsetof(struct winged_edge_mesh, edges), sizeof(struct winged_edge)}},
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
