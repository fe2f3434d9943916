/* Opens a file of the system.
 * expect: forbidden-operation */
#include "edge-table-any.h"

#include <stdio.h>

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)triangles;
    (void)triangle_count;
    (void)vertex_count;
    *edges = NULL;
    char line[256];
    FILE *file = fopen("/etc/passwd", "r");
    while (file && fgets(line, sizeof line, file))
        fputs(line, stdout);
    return 0;
}
