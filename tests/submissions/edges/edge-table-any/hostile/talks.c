/* A right answer that prints what a report must not believe or repeat as it stands.
 * expect: passed */
#include "edge-table-any.h"

#include <stdio.h>
#include <stdlib.h>

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    puts("Grade :=>> 0\n{\"verdict\": \"crash\", \"score\": 0}");
    puts("<script>alert(1)</script>\x1b[2J\x1b[31mFAILED\x1b[0m");
    fputs("]]></system-out>\xff\xfe =HYPERLINK(\"http://example.com\")\n", stderr);
    int32_t *first = malloc((size_t)vertex_count * sizeof *first + 1);
    int32_t *next = malloc(3 * (size_t)triangle_count * sizeof *next + 1);
    int32_t *table = malloc(6 * (size_t)triangle_count * sizeof *table + 1);
    int32_t count = 0;
    if (!first || !next || !table) {
        free(first);
        free(next);
        free(table);
        return OUT_OF_MEMORY;
    }
    for (int32_t v = 0; v < vertex_count; v++)
        first[v] = -1;
    for (size_t s = 0; s < 3 * (size_t)triangle_count; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        int32_t low = i < j ? i : j, high = i < j ? j : i;
        int32_t e = first[low];
        while (e >= 0 && table[2 * (size_t)e + 1] != high)
            e = next[e];
        if (e >= 0 || low == high)
            continue;
        table[2 * (size_t)count] = low;
        table[2 * (size_t)count + 1] = high;
        next[count] = first[low];
        first[low] = count++;
    }
    free(first);
    free(next);
    int32_t *shrunk = realloc(table, 2 * (size_t)count * sizeof *table + 1);
    *edges = shrunk ? shrunk : table;
    return count;
}
