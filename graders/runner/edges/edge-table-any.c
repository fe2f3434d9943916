/* Calls edge_table_any once.
 *
 * input    int vertex_count, int triangle_count, float positions[3V], int32 triangles[3F]
 * answer   table of edges, int32[2] each */
#include "edge-table-any.h"
#include "graders/runner/call.h"

#include <stdlib.h>

void run_call(struct reader *input, struct writer *answer)
{
    int32_t vertex_count = (int32_t)read_int(input);
    int32_t triangle_count = (int32_t)read_int(input);
    (void)read_array(input, vertex_count, 3 * sizeof(float));
    const int32_t *triangles = read_array(input, triangle_count, 3 * sizeof *triangles);
    int32_t *edges = NULL;

    measure_begin();
    int64_t count = edge_table_any(triangles, triangle_count, vertex_count, &edges);
    measure_end();

    if (count == OUT_OF_MEMORY) {
        call_out_of_memory();
        return;
    }
    write_table(answer, edges, count, 2 * sizeof *edges);
    free(edges);
}
