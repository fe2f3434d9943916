/* Claims two thousand million strips and gives no table.
 * expect: wrong-answer
 * fails: strips, winding, smallest, measured-memory, vertices-processed
 */
#include "memory-strips.h"

#include <stddef.h>

int64_t strips_bytes(int32_t m, int32_t n)
{
    int64_t table_bytes = (int64_t)sizeof(int32_t) + (int64_t)m * (int64_t)sizeof(float *);
    return table_bytes + strips_processed_vertices(m, n) * 3 * (int64_t)sizeof(float);
}

double strips_kilobytes(void)
{
    return (double)strips_bytes(128, 128) / 1024;
}

int64_t strips_processed_vertices(int32_t m, int32_t n)
{
    return (int64_t)m * 2 * ((int64_t)n + 1);
}

int64_t indexed_processed_vertices(int32_t m, int32_t n)
{
    return ((int64_t)m + 1) * ((int64_t)n + 1);
}

double strips_memory_ratio(void)
{
    return 1.5; /* 36 mn / 24 mn */
}

double strips_time_ratio(void)
{
    return 2; /* 2m(n + 1) / ((m + 1)(n + 1)) */
}

int strips_build(int32_t m, int32_t n, struct strip_grid *grid)
{
    (void)m;
    (void)n;
    grid->strips = NULL;
    grid->strip_count = INT32_MAX;
    grid->vertices_per_strip = INT32_MIN;
    return 0;
}
