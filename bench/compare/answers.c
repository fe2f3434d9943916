/* Answers that do not depend on order; see answers.h. */
#include "bench/compare/answers.h"

#include "reference/kernels/vertex_cache.h"

#include <math.h>
#include <stdlib.h>

/* splitmix64's finaliser: sums of it over a set tell sets apart. */
static uint64_t mix(uint64_t x)
{
    x += UINT64_C(0x9E3779B97F4A7C15);
    x = (x ^ (x >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    x = (x ^ (x >> 27)) * UINT64_C(0x94D049BB133111EB);
    return x ^ (x >> 31);
}

void answer_edges(struct worker_answer *answer, const int32_t *pairs, int64_t edge_count)
{
    uint64_t sum = mix((uint64_t)edge_count);
    for (int64_t i = 0; i < edge_count; i++) {
        uint32_t u = (uint32_t)pairs[2 * i], v = (uint32_t)pairs[2 * i + 1];
        sum += mix(u < v ? (uint64_t)u << 32 | v : (uint64_t)v << 32 | u);
    }
    answer->hash = sum | 1;
    answer_count(answer, edge_count);
}

void answer_area(struct worker_answer *answer, double area)
{
    answer->value = area;
    answer->scale = fabs(area) + 1e-300;
    answer->tolerance = 1e-6;
}

void answer_normals(struct worker_answer *answer, const float *normals, int64_t count)
{
    double sum = 0;
    for (int64_t i = 0; i < count; i++) /* unequal weights: swapped or negated axes show */
        sum += fabs((double)normals[3 * i] + 0.1) + 2 * fabs((double)normals[3 * i + 1] + 0.2) +
               3 * fabs((double)normals[3 * i + 2] + 0.3);
    answer->value = sum;
    answer->scale = (double)count;
    answer->tolerance = 1e-4;
}

void answer_positions(struct worker_answer *answer, const float *positions, int64_t count)
{
    answer_normals(answer, positions, count);
}

void answer_count(struct worker_answer *answer, int64_t count)
{
    answer->value = (double)count;
    answer->scale = 1;
    answer->tolerance = 0;
}

void answer_neighbours(struct worker_answer *answer, const int32_t *neighbours,
                       int64_t triangle_count)
{
    uint64_t sum = mix((uint64_t)triangle_count);
    int64_t met = 0;
    for (int64_t side = 0; side < 3 * triangle_count; side++) {
        int32_t other = neighbours[side] < 0 ? -1 : neighbours[side];
        met += other >= 0;
        sum += mix((uint64_t)side << 32 | (uint32_t)other);
    }
    answer->hash = sum | 1;
    answer_count(answer, met);
}

void answer_strips(struct worker_answer *answer, int64_t index_count)
{
    worker_fact(answer, "indices", (double)index_count);
}

void answer_order(struct worker_answer *answer, int32_t *triangles, int32_t triangle_count,
                  int32_t vertex_count)
{
    const struct mesh mesh = {
        .triangles = triangles, .triangle_count = triangle_count, .vertex_count = vertex_count};
    int64_t *scratch = malloc((size_t)vertex_count * sizeof *scratch + 1);
    answer_count(answer, triangle_count);
    if (scratch)
        worker_fact(answer, "cache_misses",
                    (double)vertex_cache_misses(&mesh, VERTEX_CACHE_SIZE, scratch));
    free(scratch);
}

int answers_agree(const struct worker_answer *left, const struct worker_answer *right)
{
    bool hashes = left->hash && right->hash, values = left->scale > 0 && right->scale > 0;
    if (hashes && left->hash != right->hash)
        return 0;
    if (values) {
        double scale = left->scale > right->scale ? left->scale : right->scale;
        double tolerance = left->tolerance > right->tolerance ? left->tolerance : right->tolerance;
        if (!(fabs(left->value - right->value) <= tolerance * scale))
            return 0;
    }
    return hashes || values ? 1 : -1;
}
