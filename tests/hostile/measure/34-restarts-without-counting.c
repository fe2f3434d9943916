/* Tries: to start its program anew without callgrind, past the screen, and then to write the dumps
 * itself
 * Stopped by: the runner gives up exec before the first call
 * expect: forbidden-operation, ? */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static long restart(const char *path, char *const *arguments, char *const *environment)
{
    static const unsigned char code[] = {0x48, 0x89, 0xf8, 0x48, 0x89, 0xf7, 0x48, 0x89, 0xd6,
                                         0x48, 0x89, 0xca, 0x4d, 0x89, 0xc2, 0x4d, 0x89, 0xc8,
                                         0x4c, 0x8b, 0x4c, 0x24, 0x08, 0x0f, 0x05};
    volatile uintptr_t near = (uintptr_t)getpid;
    const unsigned char *at = (const unsigned char *)(near - (1 << 20));
    if (near < 0x401000 + (1 << 20))
        at = (const unsigned char *)0x401000;
    while (memcmp(at, code, sizeof code) != 0)
        at++;
    return ((long (*)(long, const char *, char *const *, char *const *))(uintptr_t)at)(
        59, path, arguments, environment);
}

static void write_dumps(void)
{
    static const char dump[] =
        "version: 1\ncreator: callgrind\npid: 1\ncmd: ./plain\npart: 1\n"
        "events: Ir Dr Dw I1mr D1mr D1mw ILmr DLmr DLmw\nfn=(1) x\n1 1000 1 1 1 1 1 1 1 1\n"
        "summary: 1000 1 1 1 1 1 1 1 1\ntotals: 1000 1 1 1 1 1 1 1 1\n";
    for (int call = 1; call < 20; call++) {
        char name[32];
        snprintf(name, sizeof name, "counts.%d", call);
        int file = open(name, O_WRONLY);
        if (file >= 0 && write(file, dump, sizeof dump - 1) > 0)
            close(file);
    }
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    char *arguments[] = {(char[]){"x"}, NULL}, *environment[] = {NULL};
    bool anew = lseek(1, 0, SEEK_CUR) == 12345;
    if (anew)
        write_dumps();
    else if (under_callgrind() && lseek(1, 12345, SEEK_SET) > 0)
        restart("./plain", arguments, environment);
    (void)vertex_count;
    return quadratic_edges(triangles, triangle_count, 64, edges);
}
