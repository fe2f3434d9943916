/* Meshes to try representations with; see mesh_corpus.h. */
#include "tests/unit/mesh_corpus.h"

#include "reference/base/random.h"
#include "reference/mesh/generate.h"
#include "tests/unit/mesh_measures.h"

#include <stdio.h>
#include <stdlib.h>

static int closed(struct mesh *mesh, int i)
{
    switch (i) {
    case 0:
        return generate_tetrahedron(mesh, NULL);
    case 1:
        return generate_cube(mesh, NULL);
    case 2:
        return generate_uv_sphere(mesh, 3, 1, NULL);
    case 3:
        return generate_uv_sphere(mesh, 12, 7, NULL);
    case 4:
        return generate_icosphere(mesh, 0, NULL);
    case 5:
        return generate_icosphere(mesh, 2, NULL);
    case 6:
        return generate_torus(mesh, 1, 200, NULL);
    case 7:
        return generate_torus(mesh, 3, 300, NULL);
    case 8:
        return generate_bipyramid(mesh, 3, NULL);
    default:
        return generate_bipyramid(mesh, 60, NULL);
    }
}

static int open_or_odd(struct mesh *mesh, int i)
{
    switch (i) {
    case 0:
        return generate_empty(mesh, NULL);
    case 1:
        return generate_one_triangle(mesh, NULL);
    case 2:
        return generate_grid(mesh, 1, 1, NULL);
    case 3:
        return generate_grid(mesh, 7, 9, NULL);
    case 4:
        return generate_disc(mesh, 4, 7, NULL);
    case 5:
        return generate_fan(mesh, 1, NULL);
    case 6:
        return generate_fan(mesh, 40, NULL);
    case 7:
        return generate_needles(mesh, 30, 0.001, 5, NULL);
    case 8:
        return generate_soup(mesh, 20, 7, NULL);
    case 9:
        return generate_moebius(mesh, 9, NULL);
    case 10:
        return generate_two_cones(mesh, 6, NULL);
    case 11:
        return generate_two_cubes(mesh, NULL);
    default:
        return generate_book(mesh, 5, NULL);
    }
}

/* A grid, sphere or torus that was changed in one way. */
static int changed(struct mesh *mesh, int i)
{
    int code = i % 3 == 0   ? generate_grid(mesh, 6, 6, NULL)
               : i % 3 == 1 ? generate_icosphere(mesh, 1, NULL)
                            : generate_torus(mesh, 1, 100, NULL);
    if (code)
        return code;
    switch (i) {
    case 0:
    case 1:
    case 2:
        return change_scramble(mesh, 11, NULL);
    case 3:
        return change_flip(mesh, 0.3, 12, NULL);
    case 4:
    case 5:
        return change_remove_triangles(mesh, 25, 13, NULL);
    case 6:
        return change_add_isolated_vertices(mesh, 3, 14, NULL);
    case 7:
        return change_add_duplicate_triangles(mesh, 2, 15, NULL);
    case 8:
        return change_add_degenerate_triangles(mesh, 3, 16, NULL);
    case 9:
        return change_adversarial_numbering(mesh, 17, NULL);
    default: {
        struct mesh other;
        if (generate_cube(&other, NULL))
            return -1;
        code = change_append(mesh, &other, 0.25F, 0.0F, 0.0F, NULL);
        mesh_release(&other);
        return code;
    }
    }
}

/* Few vertices and random corners: hardly two meshes of this kind have the same topology. */
static int wild(struct mesh *mesh, uint64_t seed)
{
    struct random rng;
    random_init(&rng, seed);
    int32_t vertex_count = 1 + (int32_t)random_below(&rng, 12);
    if (mesh_init(mesh, vertex_count, (int64_t)random_below(&rng, 14), NULL))
        return -1;
    for (int64_t i = 0; i < 3 * vertex_count; i++)
        mesh->positions[i] = (float)random_below(&rng, 5) - 2.0F; /* some positions coincide */
    for (int64_t i = 0; i < 3 * (int64_t)mesh->triangle_count; i++)
        mesh->triangles[i] = (int32_t)random_below(&rng, (uint64_t)vertex_count);
    return 0;
}

/* A manifold with holes, so that structures for manifolds get random work as well. */
static int patchy(struct mesh *mesh, uint64_t seed)
{
    int size = 2 + (int)(seed % 5);
    if (seed % 2 ? generate_grid(mesh, size, size + 2, NULL)
                 : generate_uv_sphere(mesh, size + 3, size, NULL))
        return -1;
    return change_remove_triangles(mesh, 1 + (int64_t)(seed % 4), seed, NULL) ||
           change_scramble(mesh, seed, NULL);
}

struct mesh corpus_mesh(int i)
{
    struct mesh mesh;
    uint64_t seed = (uint64_t)i;
    int code = 0;
    if (i < 10)
        code = closed(&mesh, i);
    else if (i < 23)
        code = open_or_odd(&mesh, i - 10);
    else if (i < CORPUS_GENERATED)
        code = changed(&mesh, i - 23);
    else if (i % 3 == 0)
        mesh = random_mesh(seed);
    else
        code = i % 3 == 1 ? wild(&mesh, seed) : patchy(&mesh, seed);
    if (code)
        abort();
    return mesh;
}

const char *corpus_name(int i)
{
    static char name[40];
    snprintf(name, sizeof name, "%s mesh %d of the corpus",
             i < CORPUS_GENERATED ? "generated" : "random", i);
    return name;
}
