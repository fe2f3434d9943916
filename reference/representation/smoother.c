/* Uniform Laplacian smoothing; see smoother.h. */
#include "reference/representation/smoother.h"

#include <stdlib.h>

int smoother_init(struct smoother *smoother, int32_t vertex_count, struct error *err)
{
    smoother->sums = calloc(3 * (size_t)vertex_count + 1, sizeof *smoother->sums);
    smoother->valences = calloc((size_t)vertex_count + 1, sizeof *smoother->valences);
    smoother->vertex_count = vertex_count;
    if (smoother->sums && smoother->valences)
        return 0;
    smoother_release(smoother);
    return error_set(err, "out of memory: smoothing %d vertices", vertex_count);
}

void smoother_release(struct smoother *smoother)
{
    free(smoother->sums);
    free(smoother->valences);
    *smoother = (struct smoother){0};
}

void smoother_fix(struct smoother *smoother, int32_t vertex)
{
    smoother->valences[vertex] = INT32_MIN; /* stays negative: no vertex has 2^31 edges */
}

static void add_neighbour(struct smoother *smoother, const float *positions, int64_t v, int64_t of)
{
    const float *p = positions + 3 * v;
    double *sum = smoother->sums + 3 * of;
    smoother->valences[of]++;
    sum[0] += (double)p[0];
    sum[1] += (double)p[1];
    sum[2] += (double)p[2];
}

void smoother_add_edge(struct smoother *smoother, const float *positions, int32_t a, int32_t b)
{
    add_neighbour(smoother, positions, a, b);
    add_neighbour(smoother, positions, b, a);
}

void smoother_apply(const struct smoother *smoother, float *positions)
{
    for (int64_t v = 0; v < smoother->vertex_count; v++)
        if (smoother->valences[v] > 0)
            for (int axis = 0; axis < 3; axis++)
                positions[3 * v + axis] =
                    (float)(smoother->sums[3 * v + axis] / smoother->valences[v]);
}
