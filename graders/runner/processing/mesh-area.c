/* Calls mesh_area once.
 *
 * input    int vertex_count, int triangle_count, float positions[3V], int32 triangles[3F]
 * answer   real area */
#include "mesh-area.h"
#include "graders/runner/call.h"

void run_call(struct reader *input, struct writer *answer)
{
    int32_t vertex_count = (int32_t)read_int(input);
    int32_t triangle_count = (int32_t)read_int(input);
    const float *vertices = read_array(input, vertex_count, 3 * sizeof *vertices);
    const int32_t *triangles = read_array(input, triangle_count, 3 * sizeof *triangles);

    measure_begin();
    double area = mesh_area(vertices, vertex_count, triangles, triangle_count);
    measure_end();

    if (area == OUT_OF_MEMORY)
        call_out_of_memory();
    else
        write_real(answer, area);
}
