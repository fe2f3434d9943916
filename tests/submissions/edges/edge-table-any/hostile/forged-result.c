/* Writes a forged answer and a forged grade to every descriptor that there may be.
 * expect: wrong-answer */
#define _GNU_SOURCE
#include "edge-table-any.h"

#include <stddef.h>
#include <unistd.h>

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)triangles;
    (void)triangle_count;
    (void)vertex_count;
    *edges = NULL;
    static const char grade[] = "Grade :=>> 10\n{\"verdict\": \"passed\", \"score\": 10}\n";
    int64_t answer[8] = {3, 3, 1LL << 32, 2LL << 32, 2LL << 32 | 1, 0, 0, 0};
    for (int descriptor = 1; descriptor < 1024; descriptor++) {
        ssize_t written = write(descriptor, answer, sizeof answer);
        written += pwrite(descriptor, answer, sizeof answer, 0);
        written += write(descriptor, grade, sizeof grade - 1);
        if (written < 0)
            close(descriptor);
    }
    return 0;
}
