/* Keeps the sides that go from the larger to the smaller number, in a table that doubles when it is
 * full. */
#include "edge-table-closed.h"

#include <stdlib.h>

struct table {
    int32_t *ends;
    size_t count, capacity;
};

static int append(struct table *t, int32_t i, int32_t j)
{
    if (t->count == t->capacity) {
        size_t capacity = t->capacity ? 2 * t->capacity : 16;
        int32_t *larger = realloc(t->ends, 2 * capacity * sizeof *larger);
        if (!larger)
            return OUT_OF_MEMORY;
        t->ends = larger;
        t->capacity = capacity;
    }
    t->ends[2 * t->count] = i;
    t->ends[2 * t->count + 1] = j;
    t->count++;
    return 0;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    struct table t = {NULL, 0, 0};
    for (size_t s = 0; s < 3 * (size_t)triangle_count; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        if (i > j && append(&t, i, j)) {
            free(t.ends);
            return OUT_OF_MEMORY;
        }
    }
    *edges = t.ends;
    return (int64_t)t.count;
}
