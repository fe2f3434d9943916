/* Tries: a forged answer and grade to every descriptor
 * Stopped by: the control page and answer are copied and judged as bytes
 * expect: wrong-answer, missing-edge */
#define _GNU_SOURCE
#include "edge-table-closed.h"

#include <stddef.h>
#include <unistd.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)triangles;
    (void)vertex_count;
    static const char grade[] = "Grade :=>> 10\n{\"verdict\": \"passed\", \"score\": 10}\n";
    int64_t answer[8] = {3, 3, 1LL << 32, 2LL << 32, 2LL << 32 | 1, 0, 0, 0};
    for (int file = 1; file < 1024; file++) {
        ssize_t written = write(file, answer, sizeof answer);
        written += pwrite(file, answer, sizeof answer, 64 * (triangle_count % 7));
        written += write(file, grade, sizeof grade - 1);
        if (written < 0)
            close(file);
    }
    *edges = NULL;
    return 0;
}
