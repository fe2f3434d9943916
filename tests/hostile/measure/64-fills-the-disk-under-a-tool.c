/* Tries: to fill the disk of the host where a tool needs files to be allowed, and to leave there
 * folders too deep for any path
 * Stopped by: where tools work there is a file system of its own, small and gone with the box; what
 * is left elsewhere is removed whatever its depth
 * expect: passed
 * expect(private-root): flagged, behaves-differently */
#include "edge-table-closed.h"
#include "honest.h"

#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

static void fill(void)
{
    static const char zeros[1 << 20];
    char name[32];
    for (int i = 0; i < 100; i++) {
        snprintf(name, sizeof name, i % 2 ? "file%d" : "tmp/file%d", i);
        int fd = open(name, O_CREAT | O_WRONLY, 0600);
        for (int k = 0; fd >= 0 && k < 8; k++)
            if (write(fd, zeros, sizeof zeros) <= 0)
                break;
        close(fd);
    }
    int folder = open("tmp", O_RDONLY | O_DIRECTORY);
    for (int i = 0; i < 5000 && mkdirat(folder, "deep", 0700) == 0; i++) {
        int deeper = openat(folder, "deep", O_RDONLY | O_DIRECTORY);
        close(folder);
        folder = deeper;
    }
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    static int calls;
    if (under_sanitizer() && calls++ == 0)
        fill();
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
