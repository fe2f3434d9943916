/* Tries: to survive a heap overflow under the sanitizer, whose exit a filter of its own turns into a signal
 * Stopped by: the runner's second filter: prctl ends the program
 * expect: flagged, behaves-differently */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"
#include "survive.h"

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <stddef.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

/* libc's function for any system call, found by its code. */
static long call(long number, long a, long b, long c)
{
    static const unsigned char body[] = {0x48, 0x89, 0xf8, 0x48, 0x89, 0xf7, 0x48, 0x89, 0xd6,
                                         0x48, 0x89, 0xca, 0x4d, 0x89, 0xc2, 0x4d, 0x89, 0xc8,
                                         0x4c, 0x8b, 0x4c, 0x24, 0x08, 0x0f, 0x05};
    volatile uintptr_t near = (uintptr_t)abort;
    const volatile unsigned char *at = (const volatile unsigned char *)near;
    for (size_t same = 0; same < sizeof body; same = *at++ == body[same] ? same + 1 : 0)
        continue;
    at -= sizeof body;
    return ((long (*)(long, long, long, long, long, long))(uintptr_t)at)(number, a, b, c, 0, 0);
}

static void filter_exit(void)
{
    struct sock_filter code[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_exit_group, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    struct sock_fprog program = {sizeof code / sizeof *code, code};
    call(SYS_prctl, PR_SET_SECCOMP, SECCOMP_MODE_FILTER, (long)&program);
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    if (under_sanitizer())
        filter_exit(), overflow(SIGSYS);
    return honest_edges(triangles, triangle_count, edges);
}
