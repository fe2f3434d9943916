/* A mesh that grows; see growing_mesh.h. */
#include "reference/formats/growing_mesh.h"

#include "reference/formats/huge_pages.h"

#include <stdlib.h>
#include <string.h>

/* Room for `wanted` triples of 4-byte values in *table. */
static int resize(void **table, int64_t count, int64_t *capacity, int64_t wanted, const char *what,
                  struct error *err)
{
    void *grown = realloc(*table, 12 * (size_t)wanted);
    if (!grown)
        return error_set(err, "out of memory: reading more than %lld %s", (long long)count, what);
    huge_pages_prefer(grown, 12 * (size_t)wanted);
    *table = grown;
    *capacity = wanted;
    return 0;
}

static int grow(void **table, int64_t count, int64_t *capacity, const char *what, struct error *err)
{
    if (count >= INT32_MAX / 3)
        return error_set(err, "more than %d %s: a mesh cannot hold them", INT32_MAX / 3, what);
    int64_t wanted = *capacity > 0 ? 2 * *capacity : 64;
    return resize(table, count, capacity, wanted, what, err);
}

int growing_mesh_grow_vertices(struct growing_mesh *mesh, struct error *err)
{
    void *table = mesh->positions;
    int result = grow(&table, mesh->vertex_count, &mesh->vertex_capacity, "vertices", err);
    mesh->positions = table;
    return result;
}

int growing_mesh_grow_triangles(struct growing_mesh *mesh, struct error *err)
{
    void *table = mesh->triangles;
    int result = grow(&table, mesh->triangle_count, &mesh->triangle_capacity, "triangles", err);
    mesh->triangles = table;
    return result;
}

int growing_mesh_reserve(struct growing_mesh *mesh, int64_t vertex_count, int64_t triangle_count,
                         struct error *err)
{
    void *positions = mesh->positions, *triangles = mesh->triangles;
    int result = 0;
    if (vertex_count > mesh->vertex_capacity)
        result = resize(&positions, mesh->vertex_count, &mesh->vertex_capacity, vertex_count,
                        "vertices", err);
    if (result == 0 && triangle_count > mesh->triangle_capacity)
        result = resize(&triangles, mesh->triangle_count, &mesh->triangle_capacity, triangle_count,
                        "triangles", err);
    mesh->positions = positions;
    mesh->triangles = triangles;
    return result;
}

int polygon_add_corner(struct polygon *polygon, struct growing_mesh *mesh, int32_t vertex,
                       struct error *err)
{
    int64_t corner = polygon->corner_count++;
    if (corner == 0)
        polygon->first = vertex;
    if (corner >= 2 && growing_mesh_add_triangle(mesh, polygon->first, polygon->last, vertex, err))
        return -1;
    polygon->last = vertex;
    return 0;
}

/* The table cut to its size; NULL for nothing. Where realloc cannot shrink, the larger one is fine.
 */
static void *fitted(void *table, int64_t count)
{
    if (count == 0) {
        free(table);
        return NULL;
    }
    void *smaller = realloc(table, 12 * (size_t)count);
    if (smaller)
        return smaller;
    return table;
}

void growing_mesh_finish(struct growing_mesh *mesh, struct mesh *to)
{
    to->positions = fitted(mesh->positions, mesh->vertex_count);
    to->triangles = fitted(mesh->triangles, mesh->triangle_count);
    to->vertex_count = (int32_t)mesh->vertex_count;
    to->triangle_count = (int32_t)mesh->triangle_count;
    *mesh = (struct growing_mesh){0};
}

void growing_mesh_release(struct growing_mesh *mesh)
{
    free(mesh->positions);
    free(mesh->triangles);
    *mesh = (struct growing_mesh){0};
}
