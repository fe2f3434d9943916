/* Changes of order, numbering and place: the same elements, harder to handle. See generate.h. */
#include "reference/mesh/generate.h"

#include "reference/base/random.h"

#include <stdlib.h>
#include <string.h>

/* Two new orders for a mesh: of its vertices and of its triangles. */
struct orders {
    int32_t *vertex_number;  /* new number of each vertex */
    int32_t *triangle_place; /* new place of each triangle */
};

static void orders_release(struct orders *o)
{
    free(o->vertex_number);
    free(o->triangle_place);
}

static int orders_init(struct orders *o, const struct mesh *mesh, struct error *err)
{
    o->vertex_number = malloc((size_t)mesh->vertex_count * sizeof(int32_t) + 1);
    o->triangle_place = malloc((size_t)mesh->triangle_count * sizeof(int32_t) + 1);
    if (o->vertex_number && o->triangle_place)
        return 0;
    orders_release(o);
    error_set(err, "out of memory: reordering %d vertices and %d triangles", mesh->vertex_count,
              mesh->triangle_count);
    return -1;
}

/* Applies the orders and turns each triangle to start at a random corner. */
static int reorder(struct mesh *mesh, const struct orders *o, struct random *rng, struct error *err)
{
    struct mesh made;
    if (mesh_init(&made, mesh->vertex_count, mesh->triangle_count, err))
        return -1;
    for (int64_t v = 0; v < mesh->vertex_count; v++)
        memcpy(made.positions + 3 * (int64_t)o->vertex_number[v], mesh->positions + 3 * v,
               3 * sizeof(float));
    for (int64_t t = 0; t < mesh->triangle_count; t++) {
        const int32_t *from = mesh->triangles + 3 * t;
        int32_t *to = made.triangles + 3 * (int64_t)o->triangle_place[t];
        int turn = (int)random_below(rng, 3);
        for (int corner = 0; corner < 3; corner++)
            to[corner] = o->vertex_number[from[(corner + turn) % 3]];
    }
    mesh_release(mesh);
    *mesh = made;
    return 0;
}

int change_scramble(struct mesh *mesh, uint64_t seed, struct error *err)
{
    struct orders o;
    if (orders_init(&o, mesh, err))
        return -1;
    struct random rng;
    random_init(&rng, seed);
    random_permutation(&rng, o.vertex_number, mesh->vertex_count);
    random_permutation(&rng, o.triangle_place, mesh->triangle_count);
    int result = reorder(mesh, &o, &rng, err);
    orders_release(&o);
    return result;
}

/* The next number whose bits, reversed in `bits` bits, are below `count`; that reversal is
 * returned. */
static int32_t next_reversed(int64_t *counter, int bits, int32_t count)
{
    for (;;) {
        int64_t reversed = 0;
        for (int i = 0; i < bits; i++)
            reversed |= (*counter >> i & 1) << (bits - 1 - i);
        ++*counter;
        if (reversed < count)
            return (int32_t)reversed;
    }
}

/* Vertices in the order in which triangles first use them get bit-reversed numbers, so that the
 * three of a triangle differ in their high bits and agree in the low ones. */
static void number_adversarially(const struct mesh *mesh, int32_t *vertex_number)
{
    int bits = 0;
    while (INT64_C(1) << bits < mesh->vertex_count)
        bits++;
    int64_t counter = 0;
    for (int64_t v = 0; v < mesh->vertex_count; v++)
        vertex_number[v] = -1;
    for (int64_t corner = 0; corner < 3 * (int64_t)mesh->triangle_count; corner++) {
        int32_t v = mesh->triangles[corner];
        if (vertex_number[v] < 0)
            vertex_number[v] = next_reversed(&counter, bits, mesh->vertex_count);
    }
    for (int64_t v = 0; v < mesh->vertex_count; v++)
        if (vertex_number[v] < 0)
            vertex_number[v] = next_reversed(&counter, bits, mesh->vertex_count);
}

int change_adversarial_numbering(struct mesh *mesh, uint64_t seed, struct error *err)
{
    struct orders o;
    if (orders_init(&o, mesh, err))
        return -1;
    struct random rng;
    random_init(&rng, seed);
    number_adversarially(mesh, o.vertex_number);
    random_permutation(&rng, o.triangle_place, mesh->triangle_count);
    int result = reorder(mesh, &o, &rng, err);
    orders_release(&o);
    return result;
}

int change_flip(struct mesh *mesh, double probability, uint64_t seed, struct error *err)
{
    if (!(probability >= 0.0 && probability <= 1.0))
        return error_set(err, "flipping triangles: the probability is %g and must be 0 to 1",
                         probability);
    struct random rng;
    random_init(&rng, seed);
    for (int64_t t = 0; t < mesh->triangle_count; t++)
        if (random_real(&rng) < probability) {
            int32_t *corner = mesh->triangles + 3 * t, second = corner[1];
            corner[1] = corner[2];
            corner[2] = second;
        }
    return 0;
}

void change_translate(struct mesh *mesh, float dx, float dy, float dz)
{
    for (int64_t v = 0; v < mesh->vertex_count; v++) {
        mesh->positions[3 * v] += dx;
        mesh->positions[3 * v + 1] += dy;
        mesh->positions[3 * v + 2] += dz;
    }
}

void change_scale(struct mesh *mesh, float factor)
{
    for (int64_t i = 0; i < 3 * (int64_t)mesh->vertex_count; i++)
        mesh->positions[i] *= factor;
}
