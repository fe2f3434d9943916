/* Tries: memory on the stack, and to write over what the runner reports of it
 * Stopped by: the engine: the resident memory is not explained by what is claimed
 * expect: flagged, memory-outside-heap */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

/* The runner's variable that tells where the call's stack begins, known by its value: an address a
 * little below the present frame. Set lower, the stack that is used seems shallow. */
static void move_start(uintptr_t frame, uintptr_t to)
{
    size_t bytes;
    uintptr_t *at = (uintptr_t *)all_data(&bytes);
    for (const uintptr_t *end = at + bytes / sizeof *at; at < end; at++)
        if (*at > frame - 1024 && *at < frame)
            *at = to;
}

__attribute__((noinline)) static void use_stack(void)
{
    volatile char arena[6 << 20];
    for (size_t i = 0; i < sizeof arena; i += 4096)
        arena[i] = 1;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    if (!under_sanitizer() && !under_memcheck()) {
        uintptr_t here = (uintptr_t)__builtin_frame_address(0);
        use_stack();
        move_start(here, here - (6 << 20));
    }
    return honest_edges(triangles, triangle_count, edges);
}
