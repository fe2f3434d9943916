/* The machines that grant less than this one, as far as a process can play them: see box_bench.h.
 */
#include "tests/unit/box_bench.h"

#include <errno.h>
#include <fcntl.h>
#include <grp.h>
#include <linux/capability.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <seccomp.h>
#include <stdio.h>
#include <string.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

enum { NOBODY = 65534 };

static int put(const char *path, const char *text)
{
    int fd = open(path, O_WRONLY | O_CLOEXEC);
    ssize_t written = fd >= 0 ? write(fd, text, strlen(text)) : -1;
    if (fd >= 0)
        close(fd);
    return written > 0 ? 0 : -1;
}

int box_bench_become_nobody(void)
{
    if (geteuid() != 0)
        return 0;
    if (setgroups(0, NULL) || setresgid(NOBODY, NOBODY, NOBODY) ||
        setresuid(NOBODY, NOBODY, NOBODY))
        return -1;
    return prctl(PR_SET_DUMPABLE, 1); /* a user's own program is; /proc/self then belongs to it */
}

/* A user namespace of our own, in which we are `inner` and no further one may be made. */
static int enter_last_namespace(unsigned inner)
{
    char user[64], group[64];
    snprintf(user, sizeof user, "%u %u 1", inner, geteuid());
    snprintf(group, sizeof group, "%u %u 1", inner, getegid());
    if (unshare(CLONE_NEWUSER) || put("/proc/self/setgroups", "deny") ||
        put("/proc/self/uid_map", user) || put("/proc/self/gid_map", group))
        return -1;
    return put("/proc/sys/user/max_user_namespaces", "0");
}

/* Being first in a user namespace gave all capabilities in it, which a plain user has not. */
static int drop_capabilities(void)
{
    struct __user_cap_header_struct header = {_LINUX_CAPABILITY_VERSION_3, 0};
    struct __user_cap_data_struct none[2] = {{0, 0, 0}, {0, 0, 0}};
    return syscall(SYS_capset, &header, none) ? -1 : 0;
}

int box_bench_lose_namespaces(void)
{
    if (box_bench_become_nobody() || enter_last_namespace(NOBODY))
        return -1;
    return drop_capabilities();
}

int box_bench_lose_namespaces_as_root(void)
{
    return enter_last_namespace(0);
}

int box_bench_see_version_2(void)
{
    /* In a mount namespace of its own, so that nobody else sees it. */
    return unshare(CLONE_NEWNS) || mount(NULL, "/", NULL, MS_REC | MS_PRIVATE, NULL) ||
                   mount("/sys/fs/cgroup/unified", "/sys/fs/cgroup", NULL, MS_BIND, NULL)
               ? -1
               : 0;
}

static int refuse(scmp_filter_ctx context, int error, const char *const *calls)
{
    for (; *calls; calls++)
        if (seccomp_rule_add(context, SCMP_ACT_ERRNO(error), seccomp_syscall_resolve_name(*calls),
                             0) != 0)
            return -1;
    return 0;
}

static int load(scmp_filter_ctx context)
{
    int failed = seccomp_load(context);
    seccomp_release(context);
    return failed ? -1 : 0;
}

int box_bench_enter_container(void)
{
    static const char *const not_permitted[] = {
        "mount",         "umount2", "pivot_root", "open_tree",   "move_mount",
        "mount_setattr", "unshare", "setns",      "personality", NULL};
    static const char *const not_there[] = {"clone3", "landlock_create_ruleset", NULL};
    scmp_filter_ctx context = seccomp_init(SCMP_ACT_ALLOW);
    if (!context || refuse(context, EPERM, not_permitted) || refuse(context, ENOSYS, not_there))
        return -1;
    static const unsigned long flags[] = {CLONE_NEWUSER, CLONE_NEWPID, CLONE_NEWNS,
                                          CLONE_NEWNET,  CLONE_NEWIPC, CLONE_NEWUTS};
    for (size_t i = 0; i < sizeof flags / sizeof flags[0]; i++)
        if (seccomp_rule_add(context, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), 1,
                             SCMP_A0(SCMP_CMP_MASKED_EQ, flags[i], flags[i])) != 0)
            return -1;
    return load(context);
}

int box_bench_lose_listener(void)
{
    scmp_filter_ctx context = seccomp_init(SCMP_ACT_ALLOW);
    unsigned long flag = SECCOMP_FILTER_FLAG_NEW_LISTENER;
    if (!context || seccomp_rule_add(context, SCMP_ACT_ERRNO(EBUSY), SCMP_SYS(seccomp), 1,
                                     SCMP_A1(SCMP_CMP_MASKED_EQ, flag, flag)) != 0)
        return -1;
    return load(context);
}

int box_bench_lose_seccomp(void)
{
    static const char *const calls[] = {"seccomp", NULL};
    scmp_filter_ctx context = seccomp_init(SCMP_ACT_ALLOW);
    return !context || refuse(context, EPERM, calls) ? -1 : load(context);
}
