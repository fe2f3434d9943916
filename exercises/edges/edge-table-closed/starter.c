/* Your answer to problem 4.5 (b). The header says what the function must do. */
#include "edge-table-closed.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)triangles;
    (void)triangle_count;
    (void)vertex_count;
    *edges = NULL; /* make the table with malloc */
    return 0;      /* and return how many edges it holds */
}
