/* Ends the program with success before main.
 * expect: compile-error */
#include "edge-table-any.h"

#include <stdio.h>
#include <stdlib.h>

__attribute__((constructor)) static void end(void)
{
    puts("Grade :=>> 10");
    exit(0);
}

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)triangles;
    (void)triangle_count;
    (void)vertex_count;
    *edges = NULL;
    return 0;
}
