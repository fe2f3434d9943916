/* Tries: to jump to a system call inside libc, past the screen
 * Stopped by: the seccomp filter of the run box
 * expect: forbidden-operation, tgkill */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>
#include <string.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    static const unsigned char call[] = {0xb8, 0xea, 0, 0, 0, 0x0f, 0x05}; /* tgkill */
    volatile uintptr_t near = (uintptr_t)abort;
    unsigned char *at = (unsigned char *)(near - (1 << 20));
    if ((uintptr_t)at < 0x401000)
        at = (unsigned char *)0x401000;
    while (memcmp(at, call, sizeof call) != 0)
        at++;
    ((long (*)(long, long, long))(uintptr_t)at)(1, 1, 9);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
