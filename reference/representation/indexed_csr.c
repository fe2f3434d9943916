/* Indexed + vertex faces as a representation; see indexed_csr.h. */
#include "reference/representation/indexed_csr.h"

#include "reference/representation/boundary_chain.h"
#include "reference/representation/mesh_sweeps.h"
#include "reference/representation/smoother.h"
#include "reference/representation/triangle_sweeps.h"

#include <stdlib.h>
#include <string.h>

/* -- life ------------------------------------------------------------------------------------- */

static void release(void *self)
{
    struct indexed_csr *csr = self;
    mesh_release(&csr->mesh);
    free(csr->starts);
    free(csr->vertex_faces);
    *csr = (struct indexed_csr){0};
}

/* Counting sort of all corners by vertex: faces of a vertex come in ascending order. */
static void fill_rows(struct indexed_csr *csr)
{
    int64_t corner_count = 3 * (int64_t)csr->mesh.triangle_count;
    int32_t *starts = csr->starts;
    for (int64_t c = 0; c < corner_count; c++)
        starts[csr->mesh.triangles[c] + 1]++;
    for (int64_t v = 0; v < csr->mesh.vertex_count; v++)
        starts[v + 1] += starts[v];
    for (int64_t c = corner_count - 1; c >= 0; c--) /* from the back, down to each row's start */
        csr->vertex_faces[--starts[csr->mesh.triangles[c] + 1]] = (int32_t)(c / 3);
    for (int64_t v = 0; v < csr->mesh.vertex_count; v++)
        starts[v] = starts[v + 1];
    starts[csr->mesh.vertex_count] = (int32_t)corner_count;
}

static int build(void *self, const struct mesh *mesh, struct error *err)
{
    struct indexed_csr *csr = self;
    *csr = (struct indexed_csr){0};
    if (mesh_copy(&csr->mesh, mesh, err))
        return -1;
    csr->starts = calloc((size_t)mesh->vertex_count + 1, sizeof *csr->starts);
    csr->vertex_faces = malloc(12 * (size_t)mesh->triangle_count + 1);
    if (!csr->starts || !csr->vertex_faces) {
        release(self);
        return error_set(err, "out of memory: the faces of %d vertices", mesh->vertex_count);
    }
    fill_rows(csr);
    return 0;
}

static int32_t corners_at(const struct mesh *mesh, int32_t face, int32_t vertex)
{
    const int32_t *corner = mesh->triangles + 3 * (int64_t)face;
    return (corner[0] == vertex) + (corner[1] == vertex) + (corner[2] == vertex);
}

/* The row of vertex v ascends, and holds each face as often as the face has v. */
static int check_row(const struct indexed_csr *csr, int32_t v, struct error *err)
{
    int32_t times = 0;
    for (int32_t i = csr->starts[v]; i < csr->starts[v + 1]; i++) {
        int32_t face = csr->vertex_faces[i];
        if (face < 0 || face >= csr->mesh.triangle_count)
            return error_set(err, "vertex %d lists face %d of %d", v, face,
                             csr->mesh.triangle_count);
        if (i > csr->starts[v] && face < csr->vertex_faces[i - 1])
            return error_set(err, "vertex %d lists face %d behind face %d", v, face,
                             csr->vertex_faces[i - 1]);
        times = i > csr->starts[v] && face == csr->vertex_faces[i - 1] ? times + 1 : 1;
        if (times > corners_at(&csr->mesh, face, v))
            return error_set(err, "vertex %d lists face %d, which has not that corner", v, face);
    }
    return 0;
}

/* When every entry is right and there are as many as corners, none lacks. */
static int check(const void *self, struct error *err)
{
    const struct indexed_csr *csr = self;
    if (mesh_check(&csr->mesh, err))
        return -1;
    int64_t corner_count = 3 * (int64_t)csr->mesh.triangle_count;
    for (int32_t v = 0; v < csr->mesh.vertex_count; v++) {
        int32_t first = csr->starts[v], end = csr->starts[v + 1];
        if ((v == 0 && first != 0) || end < first || end > corner_count)
            return error_set(err, "vertex %d has entries %d up to %d of %lld", v, first, end,
                             (long long)corner_count);
        if (check_row(csr, v, err))
            return -1;
    }
    if (csr->starts[csr->mesh.vertex_count] != corner_count)
        return error_set(err, "vertices list %d faces, faces have %lld corners",
                         csr->starts[csr->mesh.vertex_count], (long long)corner_count);
    return 0;
}

static int to_mesh(const void *self, struct mesh *mesh, struct error *err)
{
    const struct indexed_csr *csr = self;
    return mesh_copy(mesh, &csr->mesh, err);
}

static int32_t vertex_count(const void *self)
{
    const struct indexed_csr *csr = self;
    return csr->mesh.vertex_count;
}

static int32_t face_count(const void *self)
{
    const struct indexed_csr *csr = self;
    return csr->mesh.triangle_count;
}

static int64_t formula_bytes(const struct mesh_counts *counts)
{
    return 16 * counts->vertices + 24 * counts->triangles + 4;
}

static int64_t bytes(const void *self)
{
    return formula_bytes(
        &(struct mesh_counts){.vertices = vertex_count(self), .triangles = face_count(self)});
}

/* -- edges ------------------------------------------------------------------------------------ */

/* Faces at the edge {u,v}, from the shorter of the two rows; degenerate ones have no edges.
 *
 * except   a face that does not count, or -1
 * *lowest  the lowest one, or -1
 * returns  how many */
static int32_t faces_at_edge(const struct indexed_csr *csr, int32_t u, int32_t v, int32_t except,
                             int32_t *lowest)
{
    const int32_t *starts = csr->starts;
    bool u_is_shorter = starts[u + 1] - starts[u] < starts[v + 1] - starts[v];
    int32_t row = u_is_shorter ? u : v, other = u_is_shorter ? v : u;
    int32_t count = 0;
    *lowest = -1;
    for (int32_t i = starts[row]; i < starts[row + 1]; i++) {
        int32_t face = csr->vertex_faces[i];
        if (face == except || corners_at(&csr->mesh, face, other) == 0 ||
            triangle_is_degenerate(csr->mesh.triangles + 3 * (int64_t)face))
            continue;
        if (count++ == 0)
            *lowest = face;
    }
    return count;
}

/* Whether face f has a side from its corner i, and is the lowest face at that edge: visiting these
 * sides visits every edge once. *uses: faces at the edge. */
static bool owns_side(const struct indexed_csr *csr, int32_t f, int i, int32_t *uses)
{
    const int32_t *corner = csr->mesh.triangles + 3 * (int64_t)f;
    int32_t lowest;
    if (triangle_is_degenerate(corner))
        return false;
    *uses = faces_at_edge(csr, corner[i], corner[(i + 1) % 3], -1, &lowest);
    return lowest == f;
}

/* -- sweeps ----------------------------------------------------------------------------------- */

static int64_t transform(void *self, const float matrix[12])
{
    struct indexed_csr *csr = self;
    return positions_transform(csr->mesh.positions, csr->mesh.vertex_count, matrix);
}

static double area(const void *self)
{
    const struct indexed_csr *csr = self;
    return triangles_area(csr->mesh.positions, csr->mesh.triangles, csr->mesh.triangle_count);
}

static void face_normals(const void *self, float *normals)
{
    const struct indexed_csr *csr = self;
    triangles_normals(csr->mesh.positions, csr->mesh.triangles, csr->mesh.triangle_count, normals);
}

static int vertex_normals(const void *self, float *normals, struct error *err)
{
    const struct indexed_csr *csr = self;
    (void)err;
    mesh_vertex_normals(&csr->mesh, normals);
    return 0;
}

static int64_t edges(const void *self, int32_t *pairs, struct error *err)
{
    const struct indexed_csr *csr = self;
    (void)err;
    int64_t count = 0;
    int32_t uses;
    for (int32_t f = 0; f < csr->mesh.triangle_count; f++)
        for (int i = 0; i < 3; i++) {
            if (!owns_side(csr, f, i, &uses))
                continue;
            int32_t u = csr->mesh.triangles[3 * (int64_t)f + i];
            int32_t v = csr->mesh.triangles[3 * (int64_t)f + (i + 1) % 3];
            pairs[2 * count] = u < v ? u : v;
            pairs[2 * count + 1] = u < v ? v : u;
            count++;
        }
    return count;
}

/* Sides on edges of one face, from and to; with sides NULL only counts them. Returns how many, or
 * -1 and *err naming an edge that has more than two faces. */
static int64_t collect_boundary(const struct indexed_csr *csr, int32_t *sides, struct error *err)
{
    int64_t count = 0;
    int32_t uses;
    for (int32_t f = 0; f < csr->mesh.triangle_count; f++)
        for (int i = 0; i < 3; i++) {
            if (!owns_side(csr, f, i, &uses) || uses == 2)
                continue;
            int32_t from = csr->mesh.triangles[3 * (int64_t)f + i];
            int32_t to = csr->mesh.triangles[3 * (int64_t)f + (i + 1) % 3];
            if (uses > 2)
                return error_set(err, "edge {%d,%d} has %d faces: no boundary loops", from, to,
                                 uses);
            if (sides) {
                sides[2 * count] = from;
                sides[2 * count + 1] = to;
            }
            count++;
        }
    return count;
}

static int32_t boundary_loops(const void *self, int32_t *vertices, int32_t *loop_starts,
                              struct error *err)
{
    const struct indexed_csr *csr = self;
    int64_t count = collect_boundary(csr, NULL, err);
    if (count < 0)
        return -1;
    int32_t *sides = malloc(2 * (size_t)count * sizeof *sides + 1);
    if (!sides)
        return error_set(err, "out of memory: %lld boundary edges", (long long)count);
    collect_boundary(csr, sides, err);
    int32_t loops =
        boundary_chain(sides, count, csr->mesh.vertex_count, vertices, loop_starts, err);
    free(sides);
    return loops;
}

static int smooth(void *self, struct error *err)
{
    struct indexed_csr *csr = self;
    struct smoother smoother;
    if (smoother_init(&smoother, csr->mesh.vertex_count, err))
        return -1;
    int32_t uses;
    for (int32_t f = 0; f < csr->mesh.triangle_count; f++)
        for (int i = 0; i < 3; i++) {
            if (!owns_side(csr, f, i, &uses))
                continue;
            int32_t u = csr->mesh.triangles[3 * (int64_t)f + i];
            int32_t v = csr->mesh.triangles[3 * (int64_t)f + (i + 1) % 3];
            smoother_add_edge(&smoother, csr->mesh.positions, u, v);
            if (uses == 1) {
                smoother_fix(&smoother, u);
                smoother_fix(&smoother, v);
            }
        }
    smoother_apply(&smoother, csr->mesh.positions);
    smoother_release(&smoother);
    return 0;
}

/* -- queries ---------------------------------------------------------------------------------- */

static void face_vertices(const void *self, int32_t first, int32_t count, int32_t *corners)
{
    const struct indexed_csr *csr = self;
    memcpy(corners, csr->mesh.triangles + 3 * (int64_t)first, 12 * (size_t)count);
}

static int32_t face_neighbours(const void *self, int32_t face, int32_t neighbours[3])
{
    const struct indexed_csr *csr = self;
    const int32_t *corner = csr->mesh.triangles + 3 * (int64_t)face;
    int32_t found = 0;
    for (int i = 0; i < 3; i++) {
        neighbours[i] = -1;
        if (!triangle_is_degenerate(corner) &&
            faces_at_edge(csr, corner[i], corner[(i + 1) % 3], face, &neighbours[i]) > 0)
            found++;
    }
    return found;
}

static int32_t faces_around_vertex(const void *self, int32_t vertex, int32_t *faces,
                                   int32_t capacity)
{
    const struct indexed_csr *csr = self;
    int32_t found = 0;
    for (int32_t i = csr->starts[vertex]; i < csr->starts[vertex + 1]; i++) {
        if (i > csr->starts[vertex] && csr->vertex_faces[i] == csr->vertex_faces[i - 1])
            continue; /* another corner of a degenerate face */
        if (found < capacity)
            faces[found] = csr->vertex_faces[i];
        found++;
    }
    return found;
}

static int32_t vertices_around_vertex(const void *self, int32_t vertex, int32_t *vertices,
                                      int32_t capacity)
{
    const struct indexed_csr *csr = self;
    int32_t found = 0;
    for (int32_t i = csr->starts[vertex]; i < csr->starts[vertex + 1]; i++) {
        const int32_t *corner = csr->mesh.triangles + 3 * (int64_t)csr->vertex_faces[i];
        if (triangle_is_degenerate(corner))
            continue;
        for (int c = 0; c < 3; c++) {
            int32_t lowest;
            if (corner[c] == vertex)
                continue;
            faces_at_edge(csr, vertex, corner[c], -1, &lowest);
            if (lowest != csr->vertex_faces[i])
                continue; /* an earlier face had it */
            if (found < capacity)
                vertices[found] = corner[c];
            found++;
        }
    }
    return found;
}

static bool is_edge(const void *self, int32_t u, int32_t v)
{
    const struct indexed_csr *csr = self;
    int32_t lowest;
    return u != v && faces_at_edge(csr, u, v, -1, &lowest) > 0;
}

const struct representation representation_indexed_csr = {
    .order = 45,
    .name = "indexed-csr",
    .title = "Indexed + vertex faces",
    .documents = "-",
    .struct_bytes = sizeof(struct indexed_csr),
    .holds = FEATURE_ALL,
    .cost = {[QUERY_FACE_VERTICES] = "1",
             [QUERY_FACE_NEIGHBOURS] = "k",
             [QUERY_FACES_AROUND_VERTEX] = "k",
             [QUERY_VERTICES_AROUND_VERTEX] = "k^2",
             [QUERY_IS_EDGE] = "k"},
    .tables = {{offsetof(struct indexed_csr, mesh.positions), 3 * sizeof(float)},
               {offsetof(struct indexed_csr, mesh.triangles), 3 * sizeof(int32_t)},
               {offsetof(struct indexed_csr, starts), sizeof(int32_t)},
               {offsetof(struct indexed_csr, vertex_faces), sizeof(int32_t)}},
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
