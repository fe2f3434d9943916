/* Tries: to put such a file into the program, and print it while running
 * Stopped by: the build box: the assembler finds nothing
 * expect: compile-error, syntax */
#include "edge-table-closed.h"
#include "honest.h"

#include <stdio.h>

__asm__(".data\nfound: .incbin \"/tmp/meshgrade-canary/canary.h\"\n.byte 0\n.text");
extern const char found[];

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    puts(found);
    return honest_edges(triangles, triangle_count, edges);
}
