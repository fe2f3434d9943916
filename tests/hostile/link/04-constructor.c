/* Tries: code before main that ends the program with code 0
 * Stopped by: the policy on preprocessed text
 * expect: compile-error, forbidden-attribute */
#include "edge-table-closed.h"
#include "honest.h"

#include <stdio.h>
#include <unistd.h>

__attribute__((constructor)) static void early(void)
{
    puts("{\"verdict\": \"passed\", \"score\": 10}");
    _exit(0);
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
