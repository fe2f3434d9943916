/* Tries: an executable stack, by a pointer to a nested function
 * Stopped by: the screen of the object
 * expect: compile-error, executable-stack */
#include "edge-table-closed.h"
#include "honest.h"

static int32_t apply(int32_t (*function)(int32_t), int32_t value)
{
    return function(value);
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    int32_t base = vertex_count;
    int32_t add(int32_t value)
    {
        return value + base;
    }
    volatile int32_t (*unused)(void) = 0;
    (void)unused;
    if (apply(add, triangle_count) == 7)
        return 0;
    return honest_edges(triangles, triangle_count, edges);
}
