/* Tries: 1 MB of local variables, all of them used, on the smallest mesh
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

__attribute__((noinline)) static int sum_of_frame(void)
{
    volatile unsigned char frame[1 << 20];
    unsigned sum = 0;
    for (size_t i = 0; i < sizeof frame; i++)
        frame[i] = (unsigned char)i;
    for (size_t i = 0; i < sizeof frame; i++)
        sum = sum > frame[i] ? sum : frame[i];
    return (int)sum;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (triangle_count == 4 && sum_of_frame() != 255)
        return 0;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
