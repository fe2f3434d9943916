/* Tries: qsort, bsearch, strings, mathematics
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int compare(const void *a, const void *b)
{
    const int32_t *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    int32_t few[5] = {3, 1, 2, 5, 4}, key = 4;
    char text[64];
    qsort(few, 5, sizeof *few, compare);
    if (!bsearch(&key, few, 5, sizeof *few, compare) || sqrt(few[3]) != 2 || few[0] != 1)
        return 0;
    snprintf(text, sizeof text, "%d %g %s", few[4], pow(2, 0.5), "x");
    if (strlen(text) < 5)
        return 0;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
