/* Isolated triangles and their welding; see soup.h. */
#include "reference/mesh/soup.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

int soup_init(struct soup *soup, int64_t triangle_count, struct error *err)
{
    *soup = (struct soup){0};
    if (triangle_count < 0 || triangle_count > INT32_MAX / 9)
        return error_set(err, "a soup of %lld triangles: the count must be 0 to %d",
                         (long long)triangle_count, INT32_MAX / 9);
    if (triangle_count > 0) {
        soup->corners = calloc((size_t)triangle_count, 9 * sizeof *soup->corners);
        if (!soup->corners)
            return error_set(err, "out of memory: a soup of %lld triangles",
                             (long long)triangle_count);
    }
    soup->triangle_count = (int32_t)triangle_count;
    return 0;
}

void soup_release(struct soup *soup)
{
    free(soup->corners);
    *soup = (struct soup){0};
}

int soup_check(const struct soup *soup, struct error *err)
{
    for (int64_t i = 0; i < 9 * (int64_t)soup->triangle_count; i++)
        if (!isfinite(soup->corners[i]))
            return error_set(err, "triangle %lld of the soup: %c of corner %lld is not finite",
                             (long long)(i / 9), "xyz"[i % 3], (long long)(i % 9 / 3));
    return 0;
}

int64_t soup_bytes(int64_t triangle_count)
{
    return 36 * triangle_count;
}

int soup_from_mesh(struct soup *soup, const struct mesh *mesh, struct error *err)
{
    if (soup_init(soup, mesh->triangle_count, err))
        return -1;
    for (int64_t corner = 0; corner < 3 * (int64_t)mesh->triangle_count; corner++)
        memcpy(soup->corners + 3 * corner, mesh->positions + 3 * (int64_t)mesh->triangles[corner],
               3 * sizeof(float));
    return 0;
}

/* -- welding ---------------------------------------------------------------------------------- */

/* Vertices by position: open addressing, at most half full. */
struct vertex_table {
    int32_t *slots; /* vertex number, or -1 */
    uint64_t mask;  /* number of slots - 1, a power of two */
};

static uint64_t hash_position(const float *p)
{
    uint64_t h = 0;
    for (int axis = 0; axis < 3; axis++) {
        float value = p[axis] + 0.0F; /* -0 becomes 0, so that equal coordinates have equal bits */
        uint32_t bits;
        memcpy(&bits, &value, sizeof bits);
        h = (h ^ bits) * 0x9e3779b97f4a7c15u;
        h ^= h >> 32;
    }
    return h;
}

static bool same_position(const float *p, const float *q)
{
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

/* The vertex at p, found or appended. `positions` has room for one more. */
static int32_t find_or_add(struct vertex_table *table, float *positions, int32_t *vertex_count,
                           const float *p)
{
    uint64_t slot = hash_position(p) & table->mask;
    while (table->slots[slot] >= 0) {
        int32_t v = table->slots[slot];
        if (same_position(positions + 3 * (int64_t)v, p))
            return v;
        slot = (slot + 1) & table->mask;
    }
    table->slots[slot] = *vertex_count;
    memcpy(positions + 3 * (int64_t)*vertex_count, p, 3 * sizeof *p);
    return (*vertex_count)++;
}

static int vertex_table_init(struct vertex_table *table, int64_t corner_count, struct error *err)
{
    uint64_t slot_count = 16;
    while (slot_count < 2 * (uint64_t)corner_count)
        slot_count *= 2;
    table->mask = slot_count - 1;
    table->slots = malloc(slot_count * sizeof *table->slots);
    if (!table->slots)
        return error_set(err, "out of memory: welding %lld corners", (long long)corner_count);
    memset(table->slots, 0xff, slot_count * sizeof *table->slots);
    return 0;
}

int soup_to_mesh(struct mesh *mesh, const struct soup *soup, struct error *err)
{
    *mesh = (struct mesh){0};
    int64_t corner_count = 3 * (int64_t)soup->triangle_count;
    struct vertex_table table;
    if (vertex_table_init(&table, corner_count, err))
        return -1;
    float *positions = malloc((size_t)corner_count * 3 * sizeof *positions + 1);
    int32_t *numbers = malloc((size_t)corner_count * sizeof *numbers + 1);
    int32_t vertex_count = 0;
    int result = -1;
    if (positions && numbers) {
        for (int64_t corner = 0; corner < corner_count; corner++)
            numbers[corner] =
                find_or_add(&table, positions, &vertex_count, soup->corners + 3 * corner);
        result = mesh_init(mesh, vertex_count, soup->triangle_count, err);
        if (result == 0 && corner_count > 0) {
            memcpy(mesh->positions, positions, 12 * (size_t)vertex_count);
            memcpy(mesh->triangles, numbers, 4 * (size_t)corner_count);
        }
    } else {
        error_set(err, "out of memory: welding %lld corners", (long long)corner_count);
    }
    free(table.slots);
    free(positions);
    free(numbers);
    return result;
}
