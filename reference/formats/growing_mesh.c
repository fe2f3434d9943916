/* A mesh that grows; see growing_mesh.h. */
#include "reference/formats/growing_mesh.h"

#include <stdlib.h>
#include <string.h>

/* Room for one more triple of 4-byte values in *table. */
static int grow(void **table, int64_t count, int64_t *capacity, const char *what, struct error *err)
{
    if (count < *capacity)
        return 0;
    if (count >= INT32_MAX / 3)
        return error_set(err, "more than %d %s: a mesh cannot hold them", INT32_MAX / 3, what);
    int64_t wanted = *capacity > 0 ? 2 * *capacity : 64;
    void *grown = realloc(*table, 12 * (size_t)wanted);
    if (!grown)
        return error_set(err, "out of memory: reading more than %lld %s", (long long)count, what);
    *table = grown;
    *capacity = wanted;
    return 0;
}

int growing_mesh_add_vertex(struct growing_mesh *mesh, const float position[3], struct error *err)
{
    void *table = mesh->positions;
    int result = grow(&table, mesh->vertex_count, &mesh->vertex_capacity, "vertices", err);
    mesh->positions = table;
    if (result == 0)
        memcpy(mesh->positions + 3 * mesh->vertex_count++, position, 3 * sizeof *position);
    return result;
}

int growing_mesh_add_triangle(struct growing_mesh *mesh, int32_t a, int32_t b, int32_t c,
                              struct error *err)
{
    void *table = mesh->triangles;
    int result = grow(&table, mesh->triangle_count, &mesh->triangle_capacity, "triangles", err);
    mesh->triangles = table;
    if (result == 0) {
        int32_t *corner = mesh->triangles + 3 * mesh->triangle_count++;
        corner[0] = a;
        corner[1] = b;
        corner[2] = c;
    }
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
