/* Looks for the reference answer.
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
    static const char *const paths[] = {
        "reference/answers/edges/edge-table-any.c",
        "/usr/src/meshgrade/reference/answers/edges/edge-table-any.c",
        "../../../reference/answers/edges/edge-table-any.c"};
    char line[256];
    for (int i = 0; i < 3; i++) {
        FILE *file = fopen(paths[i], "r");
        while (file && fgets(line, sizeof line, file))
            fputs(line, stdout);
    }
    return 0;
}
