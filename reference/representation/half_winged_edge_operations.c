/* Half-winged edges as one representation among others; see half_winged_edge.h and
 * representation.h. */
#include "reference/representation/by_faces.h"
#include "reference/representation/half_winged_edge.h"
#include "reference/representation/triangle_sweeps.h"
#include "reference/representation/vector.h"
#include "reference/representation/vertex_walk.h"

extern const struct representation representation_half_winged_edge;

/* -- life and size -------------------------------------------------------------------------- */

static int build(void *self, const struct mesh *mesh, struct error *err)
{
    struct polygons polygons = polygons_of_mesh(mesh);
    return half_winged_edge_build(self, &polygons, mesh->positions, NULL, NULL, err);
}

static void release(void *self)
{
    half_winged_edge_release(self);
}

static int check(const void *self, struct error *err)
{
    return half_winged_edge_check(self, err);
}

static int to_mesh(const void *self, struct mesh *mesh, struct error *err)
{
    return half_winged_edge_to_mesh(self, mesh, err);
}

static int32_t vertex_count(const void *self)
{
    return ((const struct half_winged_edge_mesh *)self)->vertex_count;
}

static int32_t face_count(const void *self)
{
    return ((const struct half_winged_edge_mesh *)self)->face_count;
}

static int64_t table_bytes(int64_t vertices, int64_t faces, int64_t half_edges)
{
    return vertices * (int64_t)(3 * sizeof(float) + sizeof(int32_t)) +
           faces * (int64_t)sizeof(int32_t) + half_edges * (int64_t)sizeof(struct half_winged_edge);
}

static int64_t bytes(const void *self)
{
    const struct half_winged_edge_mesh *hw = self;
    return table_bytes(hw->vertex_count, hw->face_count, hw->half_edge_count);
}

static int64_t formula_bytes(const struct mesh_counts *counts)
{
    return 16 * counts->vertices + 88 * counts->edges + 4 * counts->triangles;
}

/* -- sweeps --------------------------------------------------------------------------------- */

static void face_vertices(const void *self, int32_t first, int32_t count, int32_t *corners)
{
    const struct half_winged_edge_mesh *hw = self;
    for (int32_t f = first; f < first + count; f++) {
        const struct half_winged_edge *half = hw->half_edges + hw->face_half_edge[f];
        *corners++ = half->start;
        *corners++ = half->end;
        *corners++ = hw->half_edges[half->next].end;
    }
}

/* Normals go with the cofactors of A, which is its inverse transpose up to a factor. */
static void turn_normals(struct half_winged_edge_mesh *hw, const float matrix[12])
{
    struct vector rows[3], cofactors[3];
    for (int row = 0; row < 3; row++)
        rows[row] = (struct vector){(double)matrix[4 * row], (double)matrix[4 * row + 1],
                                    (double)matrix[4 * row + 2]};
    for (int row = 0; row < 3; row++)
        cofactors[row] = vector_cross(rows[(row + 1) % 3], rows[(row + 2) % 3]);
    for (int32_t h = 0; h < hw->half_edge_count; h++) {
        struct vector normal = vector_at(hw->half_edges[h].normal, 0);
        struct vector turned = {vector_dot(cofactors[0], normal), vector_dot(cofactors[1], normal),
                                vector_dot(cofactors[2], normal)};
        vector_put(hw->half_edges[h].normal, 0, vector_unit(turned));
    }
}

static int64_t transform(void *self, const float matrix[12])
{
    struct half_winged_edge_mesh *hw = self;
    turn_normals(hw, matrix);
    return positions_transform(hw->positions, hw->vertex_count, matrix);
}

static double area(const void *self)
{
    return faces_area(&representation_half_winged_edge, self,
                      ((const struct half_winged_edge_mesh *)self)->positions);
}

static void face_normals(const void *self, float *normals)
{
    const struct half_winged_edge_mesh *hw = self;
    faces_normals(&representation_half_winged_edge, self, hw->positions, normals);
}

static int vertex_normals(const void *self, float *normals, struct error *err)
{
    (void)err;
    const struct half_winged_edge_mesh *hw = self;
    faces_vertex_normals(&representation_half_winged_edge, self, hw->positions, normals);
    return 0;
}

/* The first halves are the edges. */
static int64_t edges(const void *self, int32_t *pairs, struct error *err)
{
    (void)err;
    const struct half_winged_edge_mesh *hw = self;
    int64_t edge_count = hw->half_edge_count / 2;
    for (int64_t e = 0; e < edge_count; e++) {
        int32_t u = hw->half_edges[e].start, v = hw->half_edges[e].end;
        pairs[2 * e] = u < v ? u : v;
        pairs[2 * e + 1] = u < v ? v : u;
    }
    return edge_count;
}

/* From a vertex of the boundary its half edge leads on, the way the faces run. */
static int32_t next_on_boundary(const void *self, int32_t vertex)
{
    const struct half_winged_edge_mesh *hw = self;
    return hw->half_edges[hw->vertex_half_edge[vertex]].end;
}

static bool is_on_boundary(const void *self, int32_t vertex)
{
    const struct half_winged_edge_mesh *hw = self;
    return half_winged_edge_on_boundary(hw, vertex);
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
    const struct half_winged_edge_mesh *hw = self;
    struct vector sum = {0.0, 0.0, 0.0};
    int32_t first = hw->vertex_half_edge[vertex], h = first, count = 0;
    do {
        sum = vector_add(sum, vector_at(hw->positions, hw->half_edges[h].end));
        count++;
        h = half_winged_edge_turn_right(hw, h);
    } while (h != first);
    return vector_scale(sum, 1.0 / count);
}

static bool is_inside(const void *self, int32_t vertex)
{
    const struct half_winged_edge_mesh *hw = self;
    return hw->vertex_half_edge[vertex] >= 0 && !half_winged_edge_on_boundary(hw, vertex);
}

static int smooth(void *self, struct error *err)
{
    const struct half_winged_edge_mesh *hw = self;
    return walk_smooth(self, hw->positions, hw->vertex_count, is_inside, mean_around, err);
}

/* -- queries -------------------------------------------------------------------------------- */

static int32_t face_neighbours(const void *self, int32_t face, int32_t neighbours[3])
{
    const struct half_winged_edge_mesh *hw = self;
    int32_t h = hw->face_half_edge[face], count = 0;
    for (int i = 0; i < 3; i++) {
        neighbours[i] = hw->half_edges[hw->half_edges[h].twin].face;
        count += neighbours[i] >= 0;
        h = hw->half_edges[h].next;
    }
    return count;
}

static int32_t faces_around_vertex(const void *self, int32_t vertex, int32_t *faces,
                                   int32_t capacity)
{
    const struct half_winged_edge_mesh *hw = self;
    int32_t first = hw->vertex_half_edge[vertex], h = first, count = 0;
    if (first < 0)
        return 0;
    do {
        if (count < capacity)
            faces[count] = hw->half_edges[h].face;
        count++;
        h = half_winged_edge_turn_left(hw, h);
    } while (h != first && hw->half_edges[h].face >= 0);
    return count;
}

static int32_t vertices_around_vertex(const void *self, int32_t vertex, int32_t *vertices,
                                      int32_t capacity)
{
    const struct half_winged_edge_mesh *hw = self;
    int32_t first = hw->vertex_half_edge[vertex], h = first, count = 0;
    if (first < 0)
        return 0;
    do {
        if (count < capacity)
            vertices[count] = hw->half_edges[h].end;
        count++;
        h = half_winged_edge_turn_left(hw, h);
    } while (h != first);
    return count;
}

static bool is_edge(const void *self, int32_t u, int32_t v)
{
    const struct half_winged_edge_mesh *hw = self;
    int32_t first = hw->vertex_half_edge[u], h = first;
    if (first < 0)
        return false;
    do {
        if (hw->half_edges[h].end == v)
            return true;
        h = half_winged_edge_turn_left(hw, h);
    } while (h != first);
    return false;
}

const struct representation representation_half_winged_edge = {
    .order = 100,
    .name = "half-winged-edge",
    .title = "Half-winged edge",
    .documents = "001",
    .struct_bytes = sizeof(struct half_winged_edge_mesh),
    .holds = FEATURE_BOUNDARY | FEATURE_ISOLATED_VERTEX,
    .cost = {[QUERY_FACE_VERTICES] = "k",
             [QUERY_FACE_NEIGHBOURS] = "k",
             [QUERY_FACES_AROUND_VERTEX] = "k",
             [QUERY_VERTICES_AROUND_VERTEX] = "k",
             [QUERY_IS_EDGE] = "k"},
    .tables = {{offsetof(struct half_winged_edge_mesh, positions), 3 * sizeof(float)},
               {offsetof(struct half_winged_edge_mesh, vertex_half_edge), sizeof(int32_t)},
               {offsetof(struct half_winged_edge_mesh, face_half_edge), sizeof(int32_t)},
               {offsetof(struct half_winged_edge_mesh, half_edges),
                sizeof(struct half_winged_edge)}},
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
