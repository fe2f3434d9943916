/* Plain measures of meshes; see mesh_measures.h. */
#include "tests/unit/mesh_measures.h"

#include "reference/base/random.h"
#include "reference/mesh/generate.h"

#include <stdlib.h>
#include <string.h>

double signed_volume(const struct mesh *mesh)
{
    double sum = 0.0;
    for (int64_t t = 0; t < mesh->triangle_count; t++) {
        double p[3][3];
        for (int corner = 0; corner < 3; corner++)
            for (int axis = 0; axis < 3; axis++)
                p[corner][axis] =
                    (double)mesh->positions[3 * (int64_t)mesh->triangles[3 * t + corner] + axis];
        for (int axis = 0; axis < 3; axis++) {
            int y = (axis + 1) % 3, z = (axis + 2) % 3;
            sum += p[0][axis] * (p[1][y] * p[2][z] - p[1][z] * p[2][y]);
        }
    }
    return sum / 6.0;
}

static uint64_t hash_corners(const struct mesh *mesh, const int32_t *triangle, int first)
{
    uint64_t h = 1;
    for (int corner = 0; corner < 3; corner++) {
        uint32_t bits[3];
        int32_t v = triangle[(first + corner) % 3];
        memcpy(bits, mesh->positions + 3 * (int64_t)v, sizeof bits);
        for (int axis = 0; axis < 3; axis++) {
            struct random rng;
            random_init(&rng, h ^ bits[axis]);
            h = random_next(&rng);
        }
    }
    return h;
}

uint64_t surface_hash(const struct mesh *mesh)
{
    uint64_t sum = 0;
    for (int64_t t = 0; t < mesh->triangle_count; t++)
        for (int first = 0; first < 3; first++)
            sum += hash_corners(mesh, mesh->triangles + 3 * t, first);
    return sum;
}

static uint32_t float_bits(float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

bool same_mesh(const struct mesh *a, const struct mesh *b)
{
    if (a->vertex_count != b->vertex_count || a->triangle_count != b->triangle_count)
        return false;
    for (int64_t i = 0; i < 3 * (int64_t)a->vertex_count; i++)
        if (float_bits(a->positions[i]) != float_bits(b->positions[i]))
            return false;
    for (int64_t i = 0; i < 3 * (int64_t)a->triangle_count; i++)
        if (a->triangles[i] != b->triangles[i])
            return false;
    return true;
}

static int make_kind(struct mesh *mesh, uint64_t kind, int64_t size, uint64_t seed)
{
    switch (kind) {
    case 0:
        return generate_grid(mesh, size, 3, NULL);
    case 1:
        return generate_uv_sphere(mesh, size + 2, size, NULL);
    case 2:
        return generate_torus(mesh, (int)(size % 5), 50 * size, NULL);
    case 3:
        return generate_moebius(mesh, size + 2, NULL);
    case 4:
        return generate_two_cones(mesh, size + 2, NULL);
    case 5:
        return generate_book(mesh, size + 2, NULL);
    case 6:
        return generate_soup(mesh, size, seed, NULL);
    case 7:
        return generate_bipyramid(mesh, size + 2, NULL);
    default:
        return generate_needles(mesh, size, 0.01, seed, NULL);
    }
}

static int change_at_random(struct mesh *mesh, struct random *rng)
{
    int64_t count = (int64_t)random_below(rng, 4);
    uint64_t seed = random_next(rng);
    switch (random_below(rng, 6)) {
    case 0:
        return change_flip(mesh, 0.5, seed, NULL);
    case 1:
        return change_add_isolated_vertices(mesh, count, seed, NULL);
    case 2:
        return change_add_duplicate_triangles(mesh, count, seed, NULL);
    case 3:
        return change_add_degenerate_triangles(mesh, count, seed, NULL);
    case 4:
        return change_adversarial_numbering(mesh, seed, NULL);
    default:
        return change_scramble(mesh, seed, NULL);
    }
}

struct mesh random_mesh(uint64_t seed)
{
    struct random rng;
    random_init(&rng, seed);
    struct mesh mesh;
    uint64_t kind = random_below(&rng, 9);
    int64_t size = 1 + (int64_t)random_below(&rng, 12);
    if (make_kind(&mesh, kind, size, seed))
        abort();
    for (uint64_t changes = random_below(&rng, 4); changes > 0; changes--)
        if (change_at_random(&mesh, &rng))
            abort();
    return mesh;
}
