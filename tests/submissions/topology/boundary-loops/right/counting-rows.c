/* The corners of all triangles, put into one row for each vertex by counting.
 *
 * In the row of v stand the vertices that a triangle runs to from v, and those that one comes from
 * to v. Side (v,w) is on the boundary when no triangle comes from w to v, which one number for each
 * vertex tells. At every vertex as many boundary sides arrive as leave, so that a walk that uses
 * each side once can end only where it began. Time O(V + F), whatever the valence; memory
 * 12 V + 24 F bytes beside the tables. */
#include "boundary-loops.h"

#include <stdlib.h>
#include <string.h>

struct rows {
    int32_t *end;    /* one for each vertex: where its row ends; it begins where the last ended */
    int32_t *to;     /* all rows, one after the other */
    int32_t *from;   /* the same */
    int32_t *met_in; /* for each vertex, the last row where it was met */
    int32_t *used;   /* for each vertex, how many sides of its row are in loops */
};

static int32_t row_begin(const struct rows *rows, int32_t v)
{
    return v > 0 ? rows->end[v - 1] : 0;
}

/* Fills each row from its end, which so becomes its begin. */
static void fill_rows(struct rows *rows, const int32_t *triangles, int32_t triangle_count,
                      int32_t vertex_count)
{
    int32_t corner_count = 3 * triangle_count, total = 0;
    for (int32_t c = 0; c < corner_count; c++)
        rows->end[triangles[c]]++;
    for (int32_t v = 0; v < vertex_count; v++) {
        total += rows->end[v];
        rows->end[v] = total;
    }
    for (int32_t t = 0; t < corner_count; t += 3)
        for (int32_t k = 0; k < 3; k++) {
            int32_t slot = --rows->end[triangles[t + k]];
            rows->to[slot] = triangles[t + (k + 1) % 3];
            rows->from[slot] = triangles[t + (k + 2) % 3];
        }
    /* Where a row begins, the row before ends. */
    for (int32_t v = 0; v + 1 < vertex_count; v++)
        rows->end[v] = rows->end[v + 1];
    if (vertex_count > 0)
        rows->end[vertex_count - 1] = total;
}

/* Keeps the boundary sides of each row and closes the gaps. Returns how many stay. */
static int32_t keep_boundary(struct rows *rows, int32_t vertex_count)
{
    int32_t kept = 0, begin = 0;
    for (int32_t v = 0; v < vertex_count; v++) {
        int32_t end = rows->end[v];
        for (int32_t k = begin; k < end; k++)
            rows->met_in[rows->from[k]] = v;
        for (int32_t k = begin; k < end; k++) {
            rows->to[kept] = rows->to[k];
            kept += rows->met_in[rows->to[k]] != v;
        }
        rows->end[v] = kept;
        begin = end;
    }
    return kept;
}

/* Returns how many loops there are. */
static int32_t walk(struct rows *rows, int32_t vertex_count, int32_t *first, int32_t *vertices)
{
    int32_t loop_count = 0, count = 0;
    first[0] = 0;
    for (int32_t v = 0; v < vertex_count; v++)
        while (row_begin(rows, v) + rows->used[v] < rows->end[v]) {
            int32_t at = v;
            do {
                vertices[count++] = at;
                at = rows->to[row_begin(rows, at) + rows->used[at]++];
            } while (at != v);
            first[++loop_count] = count;
        }
    return loop_count;
}

/* Makes both tables; a loop has three vertices or more. */
static int32_t make_loops(struct rows *rows, int32_t vertex_count, int32_t kept, int32_t **first,
                          int32_t **vertices)
{
    *first = malloc(((size_t)kept / 3 + 1) * sizeof **first);
    *vertices = malloc((size_t)kept * sizeof **vertices + 1);
    if (*first && *vertices)
        return walk(rows, vertex_count, *first, *vertices);
    free(*first);
    free(*vertices);
    return OUT_OF_MEMORY;
}

int32_t boundary_loops(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **first, int32_t **vertices)
{
    size_t vertex_bytes = (size_t)vertex_count * sizeof(int32_t);
    size_t corner_bytes = 3 * (size_t)triangle_count * sizeof(int32_t);
    struct rows rows = {.end = calloc((size_t)vertex_count + 1, sizeof *rows.end),
                        .to = malloc(corner_bytes + 1),
                        .from = malloc(corner_bytes + 1),
                        .met_in = malloc(vertex_bytes + 1),
                        .used = calloc((size_t)vertex_count + 1, sizeof *rows.used)};
    int32_t count = OUT_OF_MEMORY;
    if (rows.end && rows.to && rows.from && rows.met_in && rows.used) {
        memset(rows.met_in, -1, vertex_bytes);
        fill_rows(&rows, triangles, triangle_count, vertex_count);
        int32_t kept = keep_boundary(&rows, vertex_count);
        count = make_loops(&rows, vertex_count, kept, first, vertices);
    }
    free(rows.end);
    free(rows.to);
    free(rows.from);
    free(rows.met_in);
    free(rows.used);
    return count;
}
