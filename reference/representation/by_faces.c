/* Operations through face_vertices alone; see by_faces.h. */
#include "reference/representation/by_faces.h"

#include "reference/representation/triangle_sweeps.h"

#include <stdlib.h>
#include <string.h>

/* Faces read at a time: the call is then cheap beside the work, and the block stays in cache. */
enum { BLOCK = 256 };

/* Reading all faces:  for (struct block b = first_block(...); b.count > 0; next_block(&b)) */
struct block {
    const struct representation *kind;
    const void *self;
    int32_t first, count; /* faces first ... first + count - 1 are in `corners` */
    int32_t corners[3 * BLOCK];
};

static void read_block(struct block *block, int32_t first)
{
    int32_t left = block->kind->face_count(block->self) - first;
    block->first = first;
    block->count = left < BLOCK ? left : BLOCK;
    if (block->count > 0)
        block->kind->face_vertices(block->self, first, block->count, block->corners);
}

static void first_block(struct block *block, const struct representation *kind, const void *self)
{
    block->kind = kind;
    block->self = self;
    read_block(block, 0);
}

static void next_block(struct block *block)
{
    read_block(block, block->first + block->count);
}

/* -- sweeps ----------------------------------------------------------------------------------- */

double faces_area(const struct representation *kind, const void *self, const float *positions)
{
    double sum = 0.0;
    struct block block;
    for (first_block(&block, kind, self); block.count > 0; next_block(&block))
        sum += triangles_area(positions, block.corners, block.count);
    return sum;
}

void faces_normals(const struct representation *kind, const void *self, const float *positions,
                   float *normals)
{
    struct block block;
    for (first_block(&block, kind, self); block.count > 0; next_block(&block))
        triangles_normals(positions, block.corners, block.count,
                          normals + 3 * (int64_t)block.first);
}

void faces_vertex_normals(const struct representation *kind, const void *self,
                          const float *positions, float *normals)
{
    int32_t vertex_count = kind->vertex_count(self);
    if (vertex_count == 0)
        return;
    memset(normals, 0, 3 * (size_t)vertex_count * sizeof *normals);
    struct block block;
    for (first_block(&block, kind, self); block.count > 0; next_block(&block))
        triangles_add_normals(positions, block.corners, block.count, normals);
    vectors_to_unit(normals, vertex_count);
}

int faces_to_mesh(const struct representation *kind, const void *self, const float *positions,
                  struct mesh *mesh, struct error *err)
{
    int32_t vertex_count = kind->vertex_count(self), face_count = kind->face_count(self);
    if (mesh_init(mesh, vertex_count, face_count, err))
        return -1;
    if (vertex_count > 0)
        memcpy(mesh->positions, positions, 12 * (size_t)vertex_count);
    if (face_count > 0)
        kind->face_vertices(self, 0, face_count, mesh->triangles);
    return 0;
}

/* -- searches --------------------------------------------------------------------------------- */

static bool same_vertex(const float *positions, int32_t a, int32_t b)
{
    return a == b ||
           (positions && same_position(positions + 3 * (int64_t)a, positions + 3 * (int64_t)b));
}

static bool is_degenerate(const float *positions, const int32_t corner[3])
{
    return same_vertex(positions, corner[0], corner[1]) ||
           same_vertex(positions, corner[1], corner[2]) ||
           same_vertex(positions, corner[2], corner[0]);
}

/* Which corner is the vertex, or -1. */
static int find_corner(const float *positions, const int32_t corner[3], int32_t vertex)
{
    for (int i = 0; i < 3; i++)
        if (same_vertex(positions, corner[i], vertex))
            return i;
    return -1;
}

static bool has_edge(const float *positions, const int32_t corner[3], int32_t u, int32_t v)
{
    return find_corner(positions, corner, u) >= 0 && find_corner(positions, corner, v) >= 0 &&
           !is_degenerate(positions, corner);
}

int32_t faces_search_face_neighbours(const struct representation *kind, const void *self,
                                     const float *positions, int32_t face, int32_t neighbours[3])
{
    int32_t own[3];
    kind->face_vertices(self, face, 1, own);
    neighbours[0] = neighbours[1] = neighbours[2] = -1;
    int32_t found = 0;
    if (is_degenerate(positions, own))
        return 0;
    struct block block;
    for (first_block(&block, kind, self); block.count > 0 && found < 3; next_block(&block))
        for (int32_t i = 0; i < block.count; i++) {
            const int32_t *corner = block.corners + 3 * i;
            if (block.first + i == face)
                continue;
            for (int side = 0; side < 3; side++)
                if (neighbours[side] < 0 &&
                    has_edge(positions, corner, own[side], own[(side + 1) % 3])) {
                    neighbours[side] = block.first + i;
                    found++;
                }
        }
    return found;
}

int32_t faces_search_faces_around(const struct representation *kind, const void *self,
                                  const float *positions, int32_t vertex, int32_t *faces,
                                  int32_t capacity)
{
    int32_t found = 0;
    struct block block;
    for (first_block(&block, kind, self); block.count > 0; next_block(&block))
        for (int32_t i = 0; i < block.count; i++)
            if (find_corner(positions, block.corners + 3 * i, vertex) >= 0) {
                if (found < capacity)
                    faces[found] = block.first + i;
                found++;
            }
    return found;
}

bool faces_search_edge(const struct representation *kind, const void *self, const float *positions,
                       int32_t u, int32_t v)
{
    if (same_vertex(positions, u, v))
        return false;
    struct block block;
    for (first_block(&block, kind, self); block.count > 0; next_block(&block))
        for (int32_t i = 0; i < block.count; i++)
            if (has_edge(positions, block.corners + 3 * i, u, v))
                return true;
    return false;
}

int32_t faces_search_vertices_around(const struct representation *kind, const void *self,
                                     int32_t vertex, int32_t *vertices, int32_t capacity)
{
    uint8_t *is_seen = calloc((size_t)kind->vertex_count(self) / 8 + 1, 1);
    if (!is_seen)
        return -1;
    int32_t found = 0;
    struct block block;
    for (first_block(&block, kind, self); block.count > 0; next_block(&block))
        for (int32_t i = 0; i < block.count; i++) {
            const int32_t *corner = block.corners + 3 * i;
            int at = find_corner(NULL, corner, vertex);
            if (at < 0 || is_degenerate(NULL, corner))
                continue;
            for (int step = 1; step < 3; step++) {
                int32_t other = corner[(at + step) % 3];
                if (is_seen[other / 8] >> other % 8 & 1)
                    continue;
                is_seen[other / 8] |= (uint8_t)(1 << other % 8);
                if (found < capacity)
                    vertices[found] = other;
                found++;
            }
        }
    free(is_seen);
    return found;
}
