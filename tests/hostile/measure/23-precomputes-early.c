/* Tries: tables filled before main
 * Stopped by: the policy on preprocessed text
 * expect: compile-error, forbidden-attribute */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

static int32_t table[1 << 20];

__attribute__((constructor)) static void fill(void)
{
    for (int32_t i = 0; i < 1 << 20; i++)
        table[i] = i;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    vertex_count += table[0];
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
