/* Tries: to find out which files the host has; each one found would be a compile error
 * Stopped by: the build box: none is there. Without a private root Landlock opens none, but what is
 * there can be told from what is not
 * expect: passed
 * expect(private-root): compile-error, syntax */
#include "edge-table-closed.h"
#include "honest.h"

#if __has_include("/etc/passwd") ||                                                                \
                  __has_include(                                                                   \
                      "/etc/shadow") ||                                                            \
                      __has_include(                                                               \
                          "/root/.bashrc") ||                                                      \
                          __has_include(                                                           \
                              "/proc/self/maps") ||                                                \
                              __has_include("../reference/base/error.h") ||                        \
                                            __has_include("/home") ||                              \
                                                          __has_include("/var/log/syslog")
#error "found"
#endif

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
