/* The indexed triangle mesh; see mesh.h. */
#include "reference/mesh/mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* `count` zeroed triples of 4-byte values; *table is NULL for none. */
static int make_table(void **table, int64_t count, const char *what, struct error *err)
{
    *table = NULL;
    if (count < 0 || count > INT32_MAX / 3)
        return error_set(err, "a mesh of %lld %s: the count must be 0 to %d", (long long)count,
                         what, INT32_MAX / 3);
    if (count == 0)
        return 0;
    *table = calloc((size_t)count, 3 * sizeof(int32_t));
    if (!*table)
        return error_set(err, "out of memory: a mesh of %lld %s takes %lld bytes", (long long)count,
                         what, 12 * (long long)count);
    return 0;
}

int mesh_init(struct mesh *mesh, int64_t vertex_count, int64_t triangle_count, struct error *err)
{
    *mesh = (struct mesh){0};
    void *positions, *triangles;
    if (make_table(&positions, vertex_count, "vertices", err))
        return -1;
    if (make_table(&triangles, triangle_count, "triangles", err)) {
        free(positions);
        return -1;
    }
    *mesh = (struct mesh){positions, triangles, (int32_t)vertex_count, (int32_t)triangle_count};
    return 0;
}

void mesh_release(struct mesh *mesh)
{
    free(mesh->positions);
    free(mesh->triangles);
    *mesh = (struct mesh){0};
}

int mesh_copy(struct mesh *to, const struct mesh *from, struct error *err)
{
    if (mesh_init(to, from->vertex_count, from->triangle_count, err))
        return -1;
    if (to->positions)
        memcpy(to->positions, from->positions, 12 * (size_t)from->vertex_count);
    if (to->triangles)
        memcpy(to->triangles, from->triangles, 12 * (size_t)from->triangle_count);
    return 0;
}

int mesh_check(const struct mesh *mesh, struct error *err)
{
    if (mesh->vertex_count < 0 || mesh->triangle_count < 0)
        return error_set(err, "a mesh with %d vertices and %d triangles: counts are never negative",
                         mesh->vertex_count, mesh->triangle_count);
    for (int64_t i = 0; i < 3 * (int64_t)mesh->vertex_count; i++)
        if (!isfinite(mesh->positions[i]))
            return error_set(err, "vertex %lld: its %c is not a finite number", (long long)(i / 3),
                             "xyz"[i % 3]);
    for (int64_t i = 0; i < 3 * (int64_t)mesh->triangle_count; i++)
        if (mesh->triangles[i] < 0 || mesh->triangles[i] >= mesh->vertex_count)
            return error_set(err, "triangle %lld: corner %lld names vertex %d, the mesh has %d",
                             (long long)(i / 3), (long long)(i % 3), mesh->triangles[i],
                             mesh->vertex_count);
    return 0;
}

int64_t mesh_bytes(int64_t vertex_count, int64_t triangle_count)
{
    return 12 * vertex_count + 12 * triangle_count;
}
