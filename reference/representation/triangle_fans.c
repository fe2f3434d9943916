/* Triangle fans as a representation; see triangle_fans.h. */
#include "reference/representation/triangle_fans.h"

#include "reference/kernels/twins.h"
#include "reference/representation/by_faces.h"
#include "reference/representation/by_mesh.h"
#include "reference/representation/mesh_sweeps.h"
#include "reference/representation/strip_faces.h"
#include "reference/representation/triangle_sweeps.h"

#include <stdlib.h>
#include <string.h>

/* -- cutting a mesh into fans ----------------------------------------------------------------- */

/* Sides are numbered as in twins.h: side 3 t + i runs from corner i of triangle t to the next. A
 * fan around the start of side s goes on, counter-clockwise, behind the side that ends there. */
struct fanner {
    const struct mesh *mesh;
    int32_t *twin;    /* of each side, negative where there is none */
    uint8_t *is_used; /* of each triangle: it lies in a fan */
    int32_t *indices; /* vertices of all fans so far */
    int32_t *lengths; /* of each fan */
    int64_t index_count;
    int32_t fan_count;
};

static int32_t next_side(int32_t side)
{
    return side % 3 == 2 ? side - 2 : side + 1;
}

static int32_t previous_side(int32_t side)
{
    return side % 3 == 0 ? side + 2 : side - 1;
}

/* The side that starts at the same vertex in the next triangle around it, or -1 when that is used
 * or there is none. */
static int32_t forwards(const struct fanner *f, int32_t side)
{
    int32_t twin = f->twin[previous_side(side)];
    return twin < 0 || f->is_used[twin / 3] ? -1 : twin;
}

static int32_t backwards(const struct fanner *f, int32_t side)
{
    int32_t twin = f->twin[side];
    return twin < 0 || f->is_used[twin / 3] ? -1 : next_side(twin);
}

/* Where a largest fan through the triangle of `side` around the start of that side begins; *count
 * is its triangles. A walk that does not end comes back to where it began: it has gone around. */
static int32_t fan_start(const struct fanner *f, int32_t side, int64_t *count)
{
    int32_t first = side;
    *count = 1;
    for (int32_t s = backwards(f, side); s >= 0; s = backwards(f, s)) {
        if (s == side)
            return first;
        first = s;
        ++*count;
    }
    for (int32_t s = forwards(f, side); s >= 0; s = forwards(f, s))
        ++*count;
    return first;
}

static void add_fan(struct fanner *f, int32_t triangle)
{
    int32_t best = -1;
    int64_t best_count = 0;
    for (int32_t side = 3 * triangle; side < 3 * triangle + 3; side++) {
        int64_t count;
        int32_t start = fan_start(f, side, &count);
        if (count > best_count) {
            best_count = count;
            best = start;
        }
    }
    const int32_t *corners = f->mesh->triangles;
    int32_t *out = f->indices + f->index_count;
    out[0] = corners[best];
    out[1] = corners[next_side(best)];
    int64_t count = 2;
    for (int32_t side = best; side >= 0; side = forwards(f, side)) {
        f->is_used[side / 3] = 1;
        out[count++] = corners[previous_side(side)];
    }
    f->index_count += count;
    f->lengths[f->fan_count++] = (int32_t)count;
}

static void fanner_release(struct fanner *f)
{
    free(f->twin);
    free(f->is_used);
    free(f->indices);
    free(f->lengths);
}

/* Memory as the kernels want it: 64-byte aligned, never NULL for nothing. */
static void *kernel_memory(size_t bytes)
{
    return aligned_alloc(64, (bytes / 64 + 2) * 64);
}

static int fanner_init(struct fanner *f, const struct mesh *mesh, struct error *err)
{
    int64_t vertices = mesh->vertex_count, triangles = mesh->triangle_count;
    *f = (struct fanner){.mesh = mesh};
    void *scratch = kernel_memory(twins_scratch_bytes(vertices, triangles));
    f->twin = kernel_memory(twins_output_bytes(vertices, triangles));
    f->is_used = calloc((size_t)triangles + 1, 1);
    f->indices = malloc(3 * (size_t)triangles * sizeof *f->indices + 1);
    f->lengths = malloc((size_t)triangles * sizeof *f->lengths + 1);
    bool ok = scratch && f->twin && f->is_used && f->indices && f->lengths;
    if (ok)
        twins_plain(mesh, scratch, f->twin);
    free(scratch);
    if (ok)
        return 0;
    fanner_release(f);
    error_set(err, "out of memory: making fans of %d triangles", mesh->triangle_count);
    return -1;
}

/* -- life ------------------------------------------------------------------------------------- */

static int build(void *self, const struct mesh *mesh, struct error *err)
{
    struct triangle_fans *fans = self;
    *fans = (struct triangle_fans){0};
    struct fanner f;
    if (mesh_refuse_isolated(mesh, "a set of fans", err) || fanner_init(&f, mesh, err))
        return -1;
    for (int32_t t = 0; t < mesh->triangle_count; t++)
        if (!f.is_used[t])
            add_fan(&f, t);
    int result = strips_init(&fans->entries, f.fan_count, f.lengths, err);
    if (result == 0)
        for (int64_t i = 0; i < f.index_count; i++)
            memcpy(fans->entries.positions + 3 * i, mesh->positions + 3 * (int64_t)f.indices[i],
                   3 * sizeof(float));
    fanner_release(&f);
    return result;
}

static void release(void *self)
{
    struct triangle_fans *fans = self;
    strips_release(&fans->entries);
}

static int check(const void *self, struct error *err)
{
    const struct triangle_fans *fans = self;
    return strips_check(&fans->entries, err);
}

static void face_vertices(const void *self, int32_t first, int32_t count, int32_t *corners)
{
    const struct triangle_fans *fans = self;
    strip_faces_of_fans(fans->entries.first_vertex, fans->entries.strip_count, first, count,
                        corners);
}

static int to_mesh(const void *self, struct mesh *mesh, struct error *err)
{
    const struct triangle_fans *fans = self;
    *mesh = (struct mesh){0};
    struct soup soup;
    if (soup_init(&soup, strips_triangle_count(&fans->entries), err))
        return -1;
    for (int32_t f = 0; f < soup.triangle_count; f++) {
        int32_t corners[3];
        face_vertices(self, f, 1, corners);
        for (int i = 0; i < 3; i++)
            memcpy(soup.corners + 9 * (int64_t)f + 3 * i,
                   fans->entries.positions + 3 * (int64_t)corners[i], 3 * sizeof(float));
    }
    int result = soup_to_mesh(mesh, &soup, err);
    soup_release(&soup);
    return result;
}

static int32_t vertex_count(const void *self)
{
    const struct triangle_fans *fans = self;
    return fans->entries.vertex_count;
}

static int32_t face_count(const void *self)
{
    const struct triangle_fans *fans = self;
    return (int32_t)strips_triangle_count(&fans->entries);
}

static void count_strips(const void *self, struct mesh_counts *counts)
{
    const struct triangle_fans *fans = self;
    counts->strips = fans->entries.strip_count;
    counts->strip_vertices = fans->entries.vertex_count;
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
    return lowest_corners(&representation_triangle_fans, self, mesh, names, err);
}

/* -- sweeps ----------------------------------------------------------------------------------- */

static int64_t transform(void *self, const float matrix[12])
{
    struct triangle_fans *fans = self;
    return positions_transform(fans->entries.positions, vertex_count(self), matrix);
}

static double area(const void *self)
{
    const struct triangle_fans *fans = self;
    return faces_area(&representation_triangle_fans, self, fans->entries.positions);
}

static void face_normals(const void *self, float *normals)
{
    const struct triangle_fans *fans = self;
    faces_normals(&representation_triangle_fans, self, fans->entries.positions, normals);
}

static int vertex_normals(const void *self, float *normals, struct error *err)
{
    return by_mesh_vertex_normals(&representation_triangle_fans, self, normals, err);
}

static int64_t edges(const void *self, int32_t *pairs, struct error *err)
{
    return by_mesh_edges(&representation_triangle_fans, self, pairs, err);
}

static int32_t boundary_loops(const void *self, int32_t *vertices, int32_t *loop_starts,
                              struct error *err)
{
    return by_mesh_boundary_loops(&representation_triangle_fans, self, vertices, loop_starts, err);
}

static int smooth(void *self, struct error *err)
{
    struct triangle_fans *fans = self;
    return by_mesh_smooth(&representation_triangle_fans, self, fans->entries.positions, err);
}

/* -- queries ---------------------------------------------------------------------------------- */

static int32_t face_neighbours(const void *self, int32_t face, int32_t neighbours[3])
{
    const struct triangle_fans *fans = self;
    return faces_search_face_neighbours(&representation_triangle_fans, self,
                                        fans->entries.positions, face, neighbours);
}

static int32_t faces_around_vertex(const void *self, int32_t vertex, int32_t *faces,
                                   int32_t capacity)
{
    const struct triangle_fans *fans = self;
    return faces_search_faces_around(&representation_triangle_fans, self, fans->entries.positions,
                                     vertex, faces, capacity);
}

static int32_t vertices_around_vertex(const void *self, int32_t vertex, int32_t *vertices,
                                      int32_t capacity)
{
    const struct triangle_fans *fans = self;
    return by_mesh_vertices_around(&representation_triangle_fans, self, fans->entries.positions,
                                   vertex, vertices, capacity);
}

static bool is_edge(const void *self, int32_t u, int32_t v)
{
    const struct triangle_fans *fans = self;
    return faces_search_edge(&representation_triangle_fans, self, fans->entries.positions, u, v);
}

const struct representation representation_triangle_fans = {
    .order = 30,
    .name = "triangle-fans",
    .title = "Triangle fans",
    .documents = "004",
    .struct_bytes = sizeof(struct triangle_fans),
    .holds = FEATURE_ALL & ~(unsigned)FEATURE_ISOLATED_VERTEX,
    .cost = {[QUERY_FACE_VERTICES] = "lg s",
             [QUERY_FACE_NEIGHBOURS] = "n",
             [QUERY_FACES_AROUND_VERTEX] = "n",
             [QUERY_VERTICES_AROUND_VERTEX] = "n",
             [QUERY_IS_EDGE] = "n"},
    .tables = {{offsetof(struct triangle_fans, entries.positions), 3 * sizeof(float)},
               {offsetof(struct triangle_fans, entries.first_vertex), sizeof(int32_t)}},
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
