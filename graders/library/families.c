/* Families of meshes of any size; see families.h. */
#include "graders/library/families.h"

#include "reference/mesh/generate.h"

#include <stdbool.h>
#include <string.h>

enum { WIDTH = 8 }; /* a constant valence at the poles, a constant share of boundary */

static bool is_closed(enum family_shape shape)
{
    return shape == FAMILY_SPHERE || shape == FAMILY_TORUS || shape == FAMILY_BIPYRAMID;
}

/* The largest torus of at most `count` triangles that the generator makes. */
static int make_torus(int64_t count, struct mesh *mesh, struct error *err)
{
    for (int64_t wanted = count; wanted > 0; wanted--) {
        if (generate_torus(mesh, 1, wanted, err))
            return -1;
        if (mesh->triangle_count <= count)
            return 0;
        mesh_release(mesh);
    }
    return error_set(err, "no torus has %lld triangles", (long long)count);
}

/* A mesh of at most `count` triangles, and not many fewer. */
static int make_base(enum family_shape shape, int64_t count, struct mesh *mesh, struct error *err)
{
    int64_t length = count / 2 / WIDTH;
    switch (shape) {
    case FAMILY_SPHERE: /* 2 * meridians * (parallels - 1) triangles at most */
        return generate_uv_sphere(mesh, WIDTH, length < 2 ? 2 : length, err);
    case FAMILY_GRID:
        return generate_grid(mesh, length < 1 ? 1 : length, WIDTH, err);
    case FAMILY_TORUS:
        return make_torus(count, mesh, err);
    case FAMILY_STRIP:
        return generate_grid(mesh, 1, count / 2, err);
    case FAMILY_FAN:
        return generate_fan(mesh, count, err);
    case FAMILY_BIPYRAMID:
        return generate_bipyramid(mesh, count / 2, err);
    case FAMILY_WINDOWS: /* of a grid of count * 16 / 15 triangles one in sixteen goes */
        return recipe_make(&(struct mesh_recipe){.shape = SHAPE_GRID,
                                                 .rows = (int32_t)(count / 15) + 1,
                                                 .columns = WIDTH,
                                                 .changes = WITH_WINDOWS},
                           1, NULL, mesh, err);
    case FAMILY_SEPARATE:
        return recipe_make(&(struct mesh_recipe){.shape = SHAPE_SEPARATE, .count = (int32_t)count},
                           1, NULL, mesh, err);
    case FAMILY_OWN:
    case FAMILY_QUADS:
        break;
    }
    return error_set(err, "a family of this shape is not made of triangles");
}

/* Puts a new vertex into the middle of `count` triangles, spread over the mesh: two triangles more
 * each, and nothing else of the surface changes. */
static int split_triangles(struct mesh *mesh, int64_t count, struct error *err)
{
    struct mesh grown;
    int64_t triangle_count = mesh->triangle_count, vertex_count = mesh->vertex_count;
    if (count > triangle_count)
        return error_set(err, "a mesh of %lld triangles is too small to be filled up",
                         (long long)triangle_count);
    if (mesh_init(&grown, vertex_count + count, triangle_count + 2 * count, err))
        return -1;
    memcpy(grown.positions, mesh->positions, 3 * sizeof(float) * (size_t)vertex_count);
    memcpy(grown.triangles, mesh->triangles, 3 * sizeof(int32_t) * (size_t)triangle_count);
    for (int64_t i = 0; i < count; i++) {
        int32_t *v = grown.triangles + 3 * (i * triangle_count / count);
        int32_t a = v[0], b = v[1], c = v[2], middle = (int32_t)(vertex_count + i);
        for (int axis = 0; axis < 3; axis++)
            grown.positions[3 * (int64_t)middle + axis] =
                (grown.positions[3 * (int64_t)a + axis] + grown.positions[3 * (int64_t)b + axis] +
                 grown.positions[3 * (int64_t)c + axis]) /
                3;
        const int32_t more[6] = {b, c, middle, c, a, middle};
        v[2] = middle;
        memcpy(grown.triangles + 3 * (triangle_count + 2 * i), more, sizeof more);
    }
    mesh_release(mesh);
    *mesh = grown;
    return 0;
}

int family_make(const struct size_family *family, int64_t triangle_count, uint64_t seed,
                struct mesh *mesh, struct error *err)
{
    if (triangle_count < FAMILY_LEAST)
        return error_set(err, "family %s: %lld triangles are too few, %d is the least",
                         family->name, (long long)triangle_count, FAMILY_LEAST);
    if (make_base(family->shape, triangle_count, mesh, err))
        return -1;
    if (mesh->triangle_count > triangle_count && !is_closed(family->shape))
        mesh->triangle_count = (int32_t)triangle_count;
    int64_t lacking = triangle_count - mesh->triangle_count;
    if (lacking % 2 != 0 && !is_closed(family->shape)) {
        mesh->triangle_count--;
        lacking++;
    }
    int failed = lacking < 0 ? error_set(err, "family %s: %lld triangles are too few", family->name,
                                         (long long)triangle_count)
                             : split_triangles(mesh, lacking / 2, err);
    if (!failed)
        failed = recipe_change_order(mesh, family->changes, seed, err);
    if (failed)
        mesh_release(mesh);
    return failed;
}
