/* Calls the function of euler-closed-mesh for every row of the packet.
 * In: row count, then pairs of int64: which number is given, and the number.
 * Out, for each row: status, vertices, edges, faces. */
#include "euler-closed-mesh.h"
#include "graders/runner/call.h"

void run_call(struct reader *input, struct writer *answer)
{
    int64_t row_count = read_int(input);
    const int64_t *rows = read_array(input, row_count, 2 * sizeof *rows);
    measure_begin();
    for (int64_t i = 0; rows && i < row_count; i++) {
        struct euler_counts counts = {0};
        int status = euler_counts_from((enum euler_given)rows[2 * i], rows[2 * i + 1], &counts);
        write_int(answer, status);
        write_int(answer, counts.vertices);
        write_int(answer, counts.edges);
        write_int(answer, counts.faces);
    }
    measure_end();
}
