/* Tries: locale, time, random numbers
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <locale.h>
#include <stdlib.h>
#include <time.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    setlocale(LC_ALL, "");
    srand(1);
    if (rand() < 0 || time(NULL) == 0 || !localeconv())
        return 0;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
