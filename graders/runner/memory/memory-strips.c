/* Calls the functions of memory-strips. */
#include "memory-strips.h"

#include "graders/runner/questions.h"
#include "graders/runner/shapes.h"

#include <stdlib.h>

static const struct asked asked[] = {ASKED_FORMULA_OF_TWO(strips_bytes),
                                     ASKED_FORMULA_OF_TWO(strips_processed_vertices),
                                     ASKED_FORMULA_OF_TWO(indexed_processed_vertices),
                                     ASKED_NUMBER(strips_kilobytes),
                                     ASKED_NUMBER(strips_memory_ratio),
                                     ASKED_NUMBER(strips_time_ratio),
                                     ASKED_END};

/* Only as many strips as the grid has rows are looked at: strip_count itself may be anything. */
static void answer_strips(struct writer *answer, struct strip_grid *grid, int32_t m)
{
    int32_t kept = grid->strips && grid->strip_count == m ? m : 0;
    write_int(answer, grid->vertices_per_strip);
    write_int(answer, grid->strip_count);
    write_int(answer, kept);
    for (int32_t row = 0; row < kept; row++)
        answer_given(answer, grid->vertices_per_strip, grid->strips[row],
                     3 * sizeof *grid->strips[row]);
    for (int32_t row = 0; grid->strips && row < grid->strip_count && row < m; row++)
        free(grid->strips[row]);
    free(grid->strips);
}

void run_call(struct reader *input, struct writer *answer)
{
    if (!ask(asked, input, answer))
        return;
    int32_t m = (int32_t)read_int(input), n = (int32_t)read_int(input);
    struct strip_grid grid = {0};
    measure_begin();
    int status = strips_build(m, n, &grid);
    measure_end();
    look_at_result(&status, sizeof status);
    if (status == OUT_OF_MEMORY) {
        call_out_of_memory();
        return;
    }
    write_int(answer, status);
    if (status != 0)
        return;
    write_int(answer, strips_bytes(m, n));
    write_int(answer, strips_processed_vertices(m, n));
    answer_strips(answer, &grid, m);
}
