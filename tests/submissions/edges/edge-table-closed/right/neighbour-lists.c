/* Each vertex has a growing list of the larger neighbours that it has an edge to. As valence is
 * bounded, looking through a list takes constant time. */
#include "edge-table-closed.h"

#include <stdlib.h>

struct list {
    int32_t *neighbour;
    int32_t count, capacity;
};

static int contains(const struct list *list, int32_t vertex)
{
    for (int32_t i = 0; i < list->count; i++)
        if (list->neighbour[i] == vertex)
            return 1;
    return 0;
}

static int append(struct list *list, int32_t vertex)
{
    if (list->count == list->capacity) {
        int32_t capacity = list->capacity ? 2 * list->capacity : 4;
        int32_t *larger = realloc(list->neighbour, (size_t)capacity * sizeof *larger);
        if (!larger)
            return OUT_OF_MEMORY;
        list->neighbour = larger;
        list->capacity = capacity;
    }
    list->neighbour[list->count++] = vertex;
    return 0;
}

static int64_t fill_lists(struct list *lists, const int32_t *triangles, int32_t triangle_count)
{
    int64_t count = 0;
    for (int32_t t = 0; t < triangle_count; t++)
        for (int k = 0; k < 3; k++) {
            int32_t i = triangles[3 * (size_t)t + (size_t)k];
            int32_t j = triangles[3 * (size_t)t + (size_t)(k + 1) % 3];
            int32_t low = i < j ? i : j, high = i < j ? j : i;
            if (low == high || contains(&lists[low], high))
                continue;
            if (append(&lists[low], high))
                return OUT_OF_MEMORY;
            count++;
        }
    return count;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    struct list *lists = calloc((size_t)vertex_count + 1, sizeof *lists);
    if (!lists)
        return OUT_OF_MEMORY;
    int64_t count = fill_lists(lists, triangles, triangle_count);
    int32_t *table = count < 0 ? NULL : malloc((size_t)count * 2 * sizeof *table + 1);
    int32_t *end = table;
    for (int32_t v = 0; v < vertex_count; v++) {
        for (int32_t i = 0; table && i < lists[v].count; i++) {
            *end++ = v;
            *end++ = lists[v].neighbour[i];
        }
        free(lists[v].neighbour);
    }
    free(lists);
    *edges = table;
    return table ? count : OUT_OF_MEMORY;
}
