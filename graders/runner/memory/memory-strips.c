/* Calls the functions of memory-strips. */
#include "memory-strips.h"
#include "graders/runner/call.h"
#include "graders/runner/memory/questions.h"

#include <stdlib.h>

static void ask_rows(struct reader *input, struct writer *answer,
                     int64_t (*first)(int32_t m, int32_t n),
                     int64_t (*second)(int32_t m, int32_t n))
{
    int64_t row_count = read_int(input);
    const int32_t *rows = read_array(input, row_count, 2 * sizeof *rows);
    measure_begin();
    for (int64_t i = 0; rows && i < row_count; i++)
        write_int(answer, first(rows[2 * i], rows[2 * i + 1]));
    for (int64_t i = 0; second && rows && i < row_count; i++)
        write_int(answer, second(rows[2 * i], rows[2 * i + 1]));
    measure_end();
}

static void ask_number(double (*number)(void), struct writer *answer)
{
    measure_begin();
    double value = number();
    measure_end();
    write_real(answer, value);
}

/* Only as many strips as the grid has rows are looked at: strip_count itself may be anything. */
static void write_strips(const struct strip_grid *grid, int32_t m, struct writer *answer)
{
    int32_t kept = grid->strips && grid->strip_count == m ? m : 0;
    write_int(answer, grid->strip_count);
    write_int(answer, kept);
    for (int32_t row = 0; row < kept; row++)
        write_table(answer, grid->strips[row], grid->vertices_per_strip,
                    3 * sizeof *grid->strips[row]);
}

static void free_strips(struct strip_grid *grid, int32_t m)
{
    for (int32_t row = 0; grid->strips && row < grid->strip_count && row < m; row++)
        free(grid->strips[row]);
    free(grid->strips);
}

static void build(struct reader *input, struct writer *answer)
{
    int32_t m = (int32_t)read_int(input);
    int32_t n = (int32_t)read_int(input);
    struct strip_grid grid = {0};
    measure_begin();
    int status = strips_build(m, n, &grid);
    measure_end();
    if (status == OUT_OF_MEMORY) {
        call_out_of_memory();
        return;
    }
    write_int(answer, status);
    if (status != 0)
        return;
    write_int(answer, strips_bytes(m, n));
    write_int(answer, strips_processed_vertices(m, n));
    write_int(answer, grid.vertices_per_strip);
    write_strips(&grid, m, answer);
    free_strips(&grid, m);
}

void run_call(struct reader *input, struct writer *answer)
{
    switch (read_int(input)) {
    case ASK_STRIPS_BYTES:
        ask_rows(input, answer, strips_bytes, NULL);
        break;
    case ASK_STRIPS_PROCESSED:
        ask_rows(input, answer, strips_processed_vertices, indexed_processed_vertices);
        break;
    case ASK_STRIPS_KILOBYTES:
        ask_number(strips_kilobytes, answer);
        break;
    case ASK_STRIPS_MEMORY_RATIO:
        ask_number(strips_memory_ratio, answer);
        break;
    case ASK_STRIPS_TIME_RATIO:
        ask_number(strips_time_ratio, answer);
        break;
    case ASK_STRIPS_BUILD:
        build(input, answer);
        break;
    }
}
