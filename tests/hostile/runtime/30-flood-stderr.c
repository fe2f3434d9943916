/* Tries: to fill the disk by stderr
 * Stopped by: the largest file of the box
 * expect: too-much-output, output-limit */
#define _GNU_SOURCE
#include "edge-table-closed.h"

#include <string.h>
#include <unistd.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    static char block[1 << 16];
    memset(block, 'x', sizeof block);
    for (;;)
        if (write(2, block, sizeof block) < 0)
            continue;
}
