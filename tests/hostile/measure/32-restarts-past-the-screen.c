/* Tries: the same past the screen, by libc's function for any system call; which tool it is under
 * it knows by its addresses
 * Stopped by: the runner gives up exec before the first call
 * expect: flagged, behaves-differently */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The code of syscall(), somewhere behind or before another function of libc. */
static long restart(const char *path, char *const *arguments, char *const *environment)
{
    static const unsigned char code[] = {0x48, 0x89, 0xf8, 0x48, 0x89, 0xf7, 0x48, 0x89, 0xd6,
                                         0x48, 0x89, 0xca, 0x4d, 0x89, 0xc2, 0x4d, 0x89, 0xc8,
                                         0x4c, 0x8b, 0x4c, 0x24, 0x08, 0x0f, 0x05};
    volatile uintptr_t near = (uintptr_t)getpid;
    const unsigned char *at = (const unsigned char *)near;
    while (memcmp(at, code, sizeof code) != 0)
        at++;
    return ((long (*)(long, const char *, char *const *, char *const *))(uintptr_t)at)(
        59, path, arguments, environment);
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    static char options[] = "ASAN_OPTIONS=poison_heap=0:detect_leaks=0";
    char *arguments[] = {(char[]){"x"}, NULL}, *environment[] = {options, NULL};
    bool anew = lseek(1, 0, SEEK_CUR) == 12345;
    if (under_memcheck())
        restart("./checked", arguments, (char *[]){NULL});
    if (under_sanitizer() && !anew && lseek(1, 12345, SEEK_SET) > 0)
        restart("./sanitized", arguments, environment);
    volatile size_t bytes = 64; /* out of sight of UBSan */
    volatile int32_t *table = malloc(bytes);
    vertex_count += table ? table[16] : 0;
    free((void *)(uintptr_t)table);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
