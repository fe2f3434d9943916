/* Tries: text in a stream of memory, and copies of strings, all of which libc allocates
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    char *text = NULL, *line = NULL, *copy = strdup("edges");
    size_t bytes = 0, room = 0;
    FILE *stream = open_memstream(&text, &bytes);
    int64_t count = copy && stream ? honest_edges(triangles, triangle_count, edges) : -1;
    if (stream) {
        fprintf(stream, "%d vertices\n%lld %s\n", vertex_count, (long long)count, copy);
        fclose(stream);
        stream = text ? fmemopen(text, bytes, "r") : NULL;
        while (stream && getline(&line, &room, stream) > 0)
            fputs(line, stdout);
        if (stream)
            fclose(stream);
    }
    free(line);
    free(text);
    free(copy);
    return count;
}
