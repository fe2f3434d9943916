/* Calls the functions of memory-indexed-grid. */
#include "memory-indexed-grid.h"

#include "graders/runner/questions.h"
#include "graders/runner/shapes.h"

static const struct asked asked[] = {ASKED_FORMULA_OF_TWO(indexed_grid_bytes),
                                     ASKED_NUMBER(indexed_grid_kilobytes),
                                     ASKED_NUMBER(indexed_grid_faces_per_vertex), ASKED_END};

void run_call(struct reader *input, struct writer *answer)
{
    if (!ask(asked, input, answer))
        return;
    int32_t m = (int32_t)read_int(input), n = (int32_t)read_int(input);
    struct indexed_grid grid = {0};
    measure_begin();
    int status = indexed_grid_build(m, n, &grid);
    measure_end();
    look_at_result(&status, sizeof status);
    if (status == OUT_OF_MEMORY) {
        call_out_of_memory();
        return;
    }
    write_int(answer, status);
    if (status != 0)
        return;
    answer_table(answer, grid.vertex_count, grid.vertices, 3 * sizeof *grid.vertices);
    answer_table(answer, grid.triangle_count, grid.triangles, 3 * sizeof *grid.triangles);
    write_int(answer, indexed_grid_bytes(m, n));
}
