/* Answers that do not depend on order; see answers.h. */
#include "bench/compare/answers.h"

#include "reference/kernels/normals.h"
#include "reference/kernels/stripify.h"
#include "reference/kernels/vertex_cache.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* splitmix64's finaliser. */
uint64_t answer_mix(uint64_t bits)
{
    bits += UINT64_C(0x9E3779B97F4A7C15);
    bits = (bits ^ (bits >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    bits = (bits ^ (bits >> 27)) * UINT64_C(0x94D049BB133111EB);
    return bits ^ (bits >> 31);
}

uint64_t answer_position_name(const float position[3])
{
    uint64_t name = 0;
    for (int k = 0; k < 3; k++) {
        float coordinate = position[k] + 0.0F; /* -0 is 0 */
        uint32_t bits;
        memcpy(&bits, &coordinate, sizeof bits);
        name = answer_mix(name + bits);
    }
    return name;
}

uint64_t answer_triangle_name(uint64_t a, uint64_t b, uint64_t c)
{
    uint64_t least = a < b ? a : b;
    least = c < least ? c : least;
    if (least == a)
        return answer_mix(answer_mix(answer_mix(a) + b) + c);
    return least == b ? answer_mix(answer_mix(answer_mix(b) + c) + a)
                      : answer_mix(answer_mix(answer_mix(c) + a) + b);
}

static uint64_t name_of(const uint64_t *names, int64_t number)
{
    return names ? names[number] : (uint64_t)number;
}

void answer_edges_named(struct worker_answer *answer, const int32_t *pairs, int64_t edge_count,
                        const uint64_t *names)
{
    uint64_t sum = answer_mix((uint64_t)edge_count);
    for (int64_t i = 0; i < edge_count; i++) {
        uint64_t u = name_of(names, pairs[2 * i]), v = name_of(names, pairs[2 * i + 1]);
        sum += u < v ? answer_mix(answer_mix(u) + v) : answer_mix(answer_mix(v) + u);
    }
    answer_count(answer, edge_count);
    answer->hash = sum | 1;
}

void answer_edges(struct worker_answer *answer, const int32_t *pairs, int64_t edge_count)
{
    answer_edges_named(answer, pairs, edge_count, NULL);
}

void answer_triangles(struct worker_answer *answer, const int32_t *triangles, int64_t count)
{
    uint64_t sum = 0;
    int64_t met = 0;
    for (const int32_t *t = triangles; t < triangles + 3 * count; t += 3) {
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
            continue;
        sum += answer_triangle_name((uint64_t)t[0], (uint64_t)t[1], (uint64_t)t[2]);
        met++;
    }
    answer_count(answer, met);
    answer->hash = sum | 1;
}

void answer_area(struct worker_answer *answer, double area)
{
    answer->value = area;
    answer->scale = fabs(area) + 1e-300;
    answer->tolerance = 1e-6;
}

/* -1 ... 1, of a coordinate of what has that name. */
static double weight(uint64_t name, int coordinate)
{
    return (double)(answer_mix(name) >> 21 * coordinate & 0x1FFFFF) / 0x100000 - 1;
}

void answer_vectors_named(struct worker_answer *answer, const float *vectors, int64_t count,
                          const uint64_t *names)
{
    double sum = 0;
    for (int64_t i = 0; i < count; i++) {
        for (int k = 0; k < 3; k++)
            sum += weight(name_of(names, i), k) * (double)vectors[3 * i + k];
    }
    answer->hash = answer_mix((uint64_t)count) | 1;
    answer->value = sum;
    answer->scale = sqrt((double)count);
    answer->tolerance = 1e-4;
}

void answer_normals(struct worker_answer *answer, const float *normals, int64_t count)
{
    answer_vectors_named(answer, normals, count, NULL);
}

void answer_positions(struct worker_answer *answer, const float *positions, int64_t count)
{
    answer_vectors_named(answer, positions, count, NULL);
}

/* Mean over the vertices that have a normal of ours; 1 without any. */
static double mean_cosine(const float *theirs, const float *ours, int64_t count)
{
    double sum = 0;
    int64_t met = 0;
    for (const float *end = ours + 3 * count; ours < end; ours += 3, theirs += 3) {
        if (ours[0] == 0 && ours[1] == 0 && ours[2] == 0)
            continue;
        for (int k = 0; k < 3; k++)
            sum += (double)theirs[k] * (double)ours[k];
        met++;
    }
    return met ? sum / (double)met : 1;
}

void answer_normals_about(struct worker_answer *answer, const float *normals,
                          const struct mesh *mesh)
{
    const size_t aligned = 64;
    int64_t vertices = mesh->vertex_count, triangles = mesh->triangle_count;
    size_t scratch_bytes = vertex_normals_scratch_bytes(vertices, triangles);
    size_t output_bytes = vertex_normals_output_bytes(vertices, triangles);
    void *scratch = aligned_alloc(aligned, (scratch_bytes / aligned + 1) * aligned);
    float *ours = aligned_alloc(aligned, (output_bytes / aligned + 1) * aligned);
    if (scratch && ours) {
        vertex_normals_plain(mesh, scratch, ours);
        bool agrees = mean_cosine(normals, ours, vertices) >= 0.95; /* not for NaN */
        answer_normals(answer, agrees ? ours : normals, vertices);
    }
    free(scratch);
    free(ours);
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
    uint64_t sum = answer_mix((uint64_t)triangle_count);
    int64_t met = 0;
    for (int64_t side = 0; side < 3 * triangle_count; side++) {
        int32_t other = neighbours[side] < 0 ? -1 : neighbours[side];
        met += other >= 0;
        sum += answer_mix((uint64_t)side << 32 | (uint32_t)other);
    }
    answer->hash = sum | 1;
    answer_count(answer, met);
}

void answer_read_mesh(struct worker_answer *answer, const float *corners, int64_t triangle_count)
{
    uint64_t hash = answer_mix((uint64_t)triangle_count);
    double sum = 0;
    for (int64_t t = 0; t < triangle_count; t++) {
        uint64_t names[3];
        for (int k = 0; k < 3; k++)
            names[k] = answer_position_name(corners + 9 * t + 3 * k);
        for (int k = 0; k < 9; k++) /* the same for all three corners: they may be rotated */
            sum += weight((uint64_t)t, k % 3) * (double)corners[9 * t + k];
        hash = answer_mix(hash + answer_triangle_name(names[0], names[1], names[2]));
    }
    answer->hash = hash | 1;
    answer->value = sum;
    answer->scale = sqrt((double)triangle_count);
    answer->tolerance = 1e-6;
}

void answer_strips(struct worker_answer *answer, const int32_t *indices, int64_t index_count)
{
    int32_t *triangles = malloc(12 * (size_t)index_count + 1);
    if (triangles)
        answer_triangles(answer, triangles, strips_triangles(indices, index_count, triangles));
    free(triangles);
    worker_fact(answer, "indices", (double)index_count);
}

void answer_order(struct worker_answer *answer, int32_t *triangles, int32_t triangle_count,
                  int32_t vertex_count)
{
    const struct mesh mesh = {
        .triangles = triangles, .triangle_count = triangle_count, .vertex_count = vertex_count};
    int64_t *scratch = malloc((size_t)vertex_count * sizeof *scratch + 1);
    answer_triangles(answer, triangles, triangle_count);
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
