/* Tries: to work while nothing counts: finds the runner's measure_end behind its own return address
 * and calls it, then sets the runner's note of that back, and in the end calls it once more, so
 * that the counting is as it was
 * Stopped by: the runner, which switches no counting: all that the process does is counted
 * expect: grows-too-fast, n^2 */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <string.h>

static void find_end(void (**measure_end)(void), unsigned char *behind_call)
{
    while (*behind_call != 0xe8)
        behind_call++;
    int32_t offset = 0;
    memcpy(&offset, behind_call + 1, sizeof offset);
    *measure_end = (void (*)(void))(uintptr_t)(behind_call + 5 + offset);
}

/* Calls it, and sets the one variable back that went from 1 to 2. */
static void switch_counting(void (*measure_end)(void))
{
    static int before[1 << 18];
    size_t bytes;
    int *now = (int *)all_data(&bytes);
    bytes = bytes / sizeof *before * sizeof *before;
    bytes = bytes < sizeof before ? bytes : sizeof before;
    memcpy(before, now, bytes);
    measure_end();
    for (size_t i = 0; i < bytes / sizeof *now; i++)
        if (before[i] == 1 && now[i] == 2)
            now[i] = 1;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    void (*measure_end)(void);
    find_end(&measure_end, __builtin_return_address(0));
    (void)vertex_count;
    if (!under_callgrind())
        return quadratic_edges(triangles, triangle_count, 16, edges);
    switch_counting(measure_end);
    int64_t count = quadratic_edges(triangles, triangle_count, 16, edges);
    switch_counting(measure_end);
    return count;
}
