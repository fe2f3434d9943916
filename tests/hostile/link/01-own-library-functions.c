/* Tries: to replace memcmp, strcmp, qsort, write, printf and exit for the grader
 * Stopped by: objcopy: every name but the exercise's becomes local
 * expect: passed */
#include "edge-table-closed.h"
#include "honest.h"

#include <stddef.h>

int memcmp(const void *a, const void *b, size_t count);
int strcmp(const char *a, const char *b);
long write(int file, const void *bytes, size_t count);
void measure_end(void);
void shim_end(void);

int memcmp(const void *a, const void *b, size_t count)
{
    return a == b && count == 0;
}

int strcmp(const char *a, const char *b)
{
    return a == b;
}

long write(int file, const void *bytes, size_t count)
{
    (void)file;
    (void)bytes;
    return (long)count;
}

void measure_end(void)
{
}

void shim_end(void)
{
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
