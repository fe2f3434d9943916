/* Tries: a read past its table that the tools do not see: under each it starts its program anew,
 * memcheck's natively, the sanitizer's with another setting
 * Stopped by: the screen of the object: undefined names
 * expect: compile-error, forbidden-symbol */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void leave_tools(void)
{
    static char options[] = "ASAN_OPTIONS=poison_heap=0:detect_leaks=0";
    char *arguments[] = {(char[]){"x"}, NULL}, *environment[] = {options, NULL};
    const char *asan = getenv("ASAN_OPTIONS"), *preloaded = getenv("LD_PRELOAD");
    if (asan && !strstr(asan, "poison_heap"))
        execve("./sanitized", arguments, environment);
    if (preloaded && strstr(preloaded, "memcheck"))
        execve("./checked", arguments, (char *[]){NULL});
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    leave_tools();
    volatile size_t bytes = 64; /* out of sight of UBSan */
    volatile int32_t *table = malloc(bytes);
    vertex_count += table ? table[16] : 0;
    free((void *)(uintptr_t)table);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
