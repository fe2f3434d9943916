/* Problem 4.5 (a): the sides of all triangles, put into one row for each vertex by counting.
 *
 * Side {i,j}, i < j, goes to the row of i as j. Within a row, j is new unless it was met in this
 * very row before, which one number for each vertex remembers. Time O(V + F), whatever the valence;
 * memory 8 V + 12 F bytes beside the table, which is made as long as it must be. */
#include "edge-table-any.h"

#include <stdlib.h>
#include <string.h>

struct rows {
    int32_t *end;    /* one for each vertex: where its row ends; it begins where the last ended */
    int32_t *entry;  /* all rows, one after the other */
    int32_t *met_in; /* for each vertex, the last row where it was met */
};

static void count_side(struct rows *rows, int32_t i, int32_t j)
{
    rows->end[i < j ? i : j] += i != j;
}

/* Fills each row from its end, which so becomes its begin. */
static void store_side(struct rows *rows, int32_t i, int32_t j)
{
    if (i != j)
        rows->entry[--rows->end[i < j ? i : j]] = i < j ? j : i;
}

static void fill_rows(struct rows *rows, const int32_t *triangles, int32_t triangle_count,
                      int32_t vertex_count)
{
    const int32_t *stop = triangles + 3 * (size_t)triangle_count;
    for (const int32_t *t = triangles; t < stop; t += 3) {
        count_side(rows, t[0], t[1]);
        count_side(rows, t[1], t[2]);
        count_side(rows, t[2], t[0]);
    }
    int32_t total = 0;
    for (int32_t v = 0; v < vertex_count; v++) {
        total += rows->end[v];
        rows->end[v] = total;
    }
    for (const int32_t *t = triangles; t < stop; t += 3) {
        store_side(rows, t[0], t[1]);
        store_side(rows, t[1], t[2]);
        store_side(rows, t[2], t[0]);
    }
    /* Where a row begins, the row before ends. */
    for (int32_t v = 0; v + 1 < vertex_count; v++)
        rows->end[v] = rows->end[v + 1];
    if (vertex_count > 0)
        rows->end[vertex_count - 1] = total;
}

/* Keeps the first of equal entries of each row and closes the gaps. Returns how many stay: the
 * number of edges. */
static int32_t drop_repeated(struct rows *rows, int32_t vertex_count)
{
    int32_t kept = 0, begin = 0;
    for (int32_t v = 0; v < vertex_count; v++) {
        int32_t end = rows->end[v];
        for (int32_t k = begin; k < end; k++) {
            int32_t other = rows->entry[k];
            rows->entry[kept] = other;
            kept += rows->met_in[other] != v;
            rows->met_in[other] = v;
        }
        rows->end[v] = kept;
        begin = end;
    }
    return kept;
}

static void write_table(const struct rows *rows, int32_t vertex_count, int32_t *table)
{
    int32_t e = 0;
    for (int32_t v = 0; v < vertex_count; v++)
        for (; e < rows->end[v]; e++) {
            *table++ = v;
            *table++ = rows->entry[e];
        }
}

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    size_t vertex_bytes = (size_t)vertex_count * sizeof(int32_t);
    struct rows rows = {.end = calloc((size_t)vertex_count + 1, sizeof *rows.end),
                        .entry = malloc(3 * (size_t)triangle_count * sizeof *rows.entry + 1),
                        .met_in = malloc(vertex_bytes + 1)};
    int64_t count = OUT_OF_MEMORY;
    *edges = NULL;
    if (rows.end && rows.entry && rows.met_in) {
        memset(rows.met_in, -1, vertex_bytes);
        fill_rows(&rows, triangles, triangle_count, vertex_count);
        int32_t kept = drop_repeated(&rows, vertex_count);
        *edges = malloc(2 * (size_t)kept * sizeof **edges + 1);
        if (*edges) {
            write_table(&rows, vertex_count, *edges);
            count = kept;
        }
    }
    free(rows.end);
    free(rows.entry);
    free(rows.met_in);
    return count;
}
