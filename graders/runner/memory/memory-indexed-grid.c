/* Calls the functions of memory-indexed-grid. */
#include "memory-indexed-grid.h"
#include "graders/runner/call.h"
#include "graders/runner/memory/questions.h"

#include <stdlib.h>

static void ask_bytes(struct reader *input, struct writer *answer)
{
    int64_t row_count = read_int(input);
    const int32_t *rows = read_array(input, row_count, 2 * sizeof *rows);
    measure_begin();
    for (int64_t i = 0; rows && i < row_count; i++)
        write_int(answer, indexed_grid_bytes(rows[2 * i], rows[2 * i + 1]));
    measure_end();
}

static void ask_number(double (*number)(void), struct writer *answer)
{
    measure_begin();
    double value = number();
    measure_end();
    write_real(answer, value);
}

static void build(struct reader *input, struct writer *answer)
{
    int32_t m = (int32_t)read_int(input);
    int32_t n = (int32_t)read_int(input);
    struct indexed_grid grid = {0};
    measure_begin();
    int status = indexed_grid_build(m, n, &grid);
    measure_end();
    if (status == OUT_OF_MEMORY) {
        call_out_of_memory();
        return;
    }
    write_int(answer, status);
    if (status != 0)
        return;
    write_table(answer, grid.vertices, grid.vertex_count, 3 * sizeof *grid.vertices);
    write_table(answer, grid.triangles, grid.triangle_count, 3 * sizeof *grid.triangles);
    write_int(answer, indexed_grid_bytes(m, n));
    free(grid.vertices);
    free(grid.triangles);
}

void run_call(struct reader *input, struct writer *answer)
{
    switch (read_int(input)) {
    case ASK_GRID_BYTES:
        ask_bytes(input, answer);
        break;
    case ASK_GRID_KILOBYTES:
        ask_number(indexed_grid_kilobytes, answer);
        break;
    case ASK_GRID_FACES_PER_VERTEX:
        ask_number(indexed_grid_faces_per_vertex, answer);
        break;
    case ASK_GRID_BUILD:
        build(input, answer);
        break;
    }
}
