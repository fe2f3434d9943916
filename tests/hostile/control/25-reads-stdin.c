/* Tries: to read what is typed, for which libc makes a buffer that it keeps
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdio.h>
#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    char text[64];
    char *line = NULL;
    size_t room = 0;
    (void)vertex_count;
    if (getchar() == 'q' || fgets(text, sizeof text, stdin) || getline(&line, &room, stdin) > 0)
        puts("thank you");
    free(line);
    return honest_edges(triangles, triangle_count, edges);
}
