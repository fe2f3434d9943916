/* Refused system calls: told by the kernel, named, and answered. */
#include "graders/box/inside.h"

#include <errno.h>
#include <linux/seccomp.h>
#include <seccomp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/uio.h>
#include <unistd.h>

/* Calls that name a file, and which argument does. */
static const struct {
    const char *name;
    int argument;
} path_calls[] = {
    {"open", 0},      {"openat", 1},     {"openat2", 1},   {"creat", 0},    {"access", 0},
    {"faccessat", 1}, {"faccessat2", 1}, {"stat", 0},      {"lstat", 0},    {"newfstatat", 1},
    {"statx", 1},     {"statfs", 0},     {"execve", 0},    {"execveat", 1}, {"unlink", 0},
    {"unlinkat", 1},  {"rename", 0},     {"renameat", 1},  {"mkdir", 0},    {"mkdirat", 1},
    {"rmdir", 0},     {"chmod", 0},      {"fchmodat", 1},  {"chown", 0},    {"fchownat", 1},
    {"truncate", 0},  {"chdir", 0},      {"chroot", 0},    {"link", 0},     {"symlink", 0},
    {"mknod", 0},     {"mknodat", 1},    {"renameat2", 1},
};

/* What libc looks for on its own account, in honest programs too. */
static const char *const quiet_calls[] = {"open",       "openat", "access",     "faccessat",
                                          "faccessat2", "stat",   "newfstatat", "statx"};
static const char *const quiet_paths[] = {
    "/usr/lib/locale/",
    "/usr/share/locale/",
    "/usr/share/i18n/",
    "/usr/lib/gconv/",
    "/usr/lib/x86_64-linux-gnu/gconv/",
    "/usr/lib/aarch64-linux-gnu/gconv/",
    "/usr/lib64/gconv/",
    "/etc/localtime",
    "/usr/share/zoneinfo/",
    "/proc/meminfo",
    "/proc/stat",
    "/sys/devices/system/cpu/",
    "/proc/sys/vm/overcommit_memory",
    "/sys/kernel/mm/transparent_hugepage/",
};

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

bool refusal_is_process(const char *call)
{
    static const char *const makers[] = {"fork", "vfork", "clone", "clone3"};
    for (size_t i = 0; i < COUNT(makers); i++)
        if (strcmp(call, makers[i]) == 0)
            return true;
    return false;
}

/* Reads text from the program's memory, never across more than one page at a time, so that a text
 * which ends just before unmapped memory is read as well. Empty when it cannot be read. */
static void read_text(pid_t pid, uint64_t address, char *out, size_t capacity)
{
    size_t length = 0;
    out[0] = '\0';
    while (length + 1 < capacity) {
        size_t part = 4096 - (address + length) % 4096;
        if (part > capacity - 1 - length)
            part = capacity - 1 - length;
        struct iovec here = {out + length, part};
        struct iovec there = {(void *)(uintptr_t)(address + length), part};
        ssize_t got = process_vm_readv(pid, &here, 1, &there, 1, 0);
        if (got <= 0)
            break;
        out[length + (size_t)got] = '\0';
        length += (size_t)got;
        if (memchr(out, '\0', length))
            return;
    }
    out[length] = '\0';
}

static void make_printable(char *text)
{
    for (; *text; text++)
        if (*text < ' ' || *text > '~')
            *text = '?';
}

static const char *path_of(const struct seccomp_notif *notice, const char *name, char *out,
                           size_t capacity)
{
    for (size_t i = 0; i < COUNT(path_calls); i++)
        if (notice->pid && strcmp(name, path_calls[i].name) == 0) {
            read_text((pid_t)notice->pid, notice->data.args[path_calls[i].argument], out, capacity);
            return out;
        }
    return NULL;
}

/* Whatever the program writes into the path meanwhile: the answer is always "not there". */
static bool is_quiet(const char *name, const char *path)
{
    bool quiet = false;
    for (size_t i = 0; i < COUNT(quiet_calls); i++)
        quiet = quiet || strcmp(name, quiet_calls[i]) == 0;
    if (!quiet || strstr(path, ".."))
        return false;
    for (size_t i = 0; i < COUNT(quiet_paths); i++)
        if (strncmp(path, quiet_paths[i], strlen(quiet_paths[i])) == 0)
            return true;
    return false;
}

static void record(struct box *box, const struct seccomp_notif *notice, const char *name,
                   const char *path)
{
    const __u64 *arguments = notice->data.args;
    box->refused_count++;
    if (box->refused_call[0])
        return;
    snprintf(box->refused_call, sizeof box->refused_call, "%s", name);
    if (path)
        snprintf(box->refused_detail, sizeof box->refused_detail, "%s %s", name, path);
    else if (strcmp(name, "kill") == 0 || strcmp(name, "tkill") == 0)
        snprintf(box->refused_detail, sizeof box->refused_detail, "%s %d, signal %d", name,
                 (int)arguments[0], (int)arguments[1]);
    else
        snprintf(box->refused_detail, sizeof box->refused_detail, "%s", name);
}

bool refusal_take(struct box *box)
{
    struct seccomp_notif notice;
    char path[120];
    memset(&notice, 0, sizeof notice);
    if (ioctl(box->notify, SECCOMP_IOCTL_NOTIF_RECV, &notice)) {
        if (errno != EINTR && errno != ENOENT) { /* ENOENT: it died before it could be asked */
            close(box->notify);
            box->notify = -1;
        }
        return false;
    }
    char *resolved = seccomp_syscall_resolve_num_arch(SCMP_ARCH_NATIVE, notice.data.nr);
    char name[40];
    if (resolved)
        snprintf(name, sizeof name, "%s", resolved);
    else
        snprintf(name, sizeof name, "call-%d", notice.data.nr);
    free(resolved);
    const char *about = path_of(&notice, name, path, sizeof path);
    /* The process may have died and its id been given away while its memory was read. */
    if (ioctl(box->notify, SECCOMP_IOCTL_NOTIF_ID_VALID, &notice.id))
        about = NULL;
    if (about && box->profile == BOX_RUN && is_quiet(name, about)) {
        struct seccomp_notif_resp answer = {.id = notice.id, .error = -ENOENT};
        ioctl(box->notify, SECCOMP_IOCTL_NOTIF_SEND, &answer);
        return false;
    }
    if (about)
        make_printable(path);
    record(box, &notice, name, about);
    return true;
}
