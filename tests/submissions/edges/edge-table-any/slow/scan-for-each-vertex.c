/* Reads the whole table of triangles once for each vertex that it has to list.
 * expect: grows-too-fast */
#include "edge-table-any.h"

#include <stdlib.h>

/* The larger neighbours of `vertex`, each once, to the end of the table. */
static int64_t append_neighbours(const int32_t *triangles, int32_t triangle_count, int32_t vertex,
                                 int32_t *table, int64_t count)
{
    int64_t begin = count;
    for (int32_t t = 0; t < triangle_count; t++) {
        const int32_t *v = triangles + 3 * (size_t)t;
        if (v[0] != vertex && v[1] != vertex && v[2] != vertex)
            continue;
        for (int k = 0; k < 3; k++) {
            int64_t e = begin;
            while (e < count && table[2 * e + 1] != v[k])
                e++;
            if (v[k] <= vertex || e < count)
                continue;
            table[2 * count] = vertex;
            table[2 * count++ + 1] = v[k];
        }
    }
    return count;
}

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    int32_t *table = malloc(6 * (size_t)triangle_count * sizeof *table + 1);
    char *used = calloc((size_t)vertex_count + 1, 1);
    if (!table || !used) {
        free(table);
        free(used);
        return OUT_OF_MEMORY;
    }
    for (size_t s = 0; s < 3 * (size_t)triangle_count; s++)
        used[triangles[s]] = 1;
    int64_t count = 0;
    for (int32_t v = 0; v < vertex_count; v++)
        if (used[v])
            count = append_neighbours(triangles, triangle_count, v, table, count);
    free(used);
    *edges = table;
    return count;
}
