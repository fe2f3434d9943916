/* The last steps of the process that becomes the program: limits, Landlock, filter, exec. */
#include "graders/box/inside.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/capability.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

/* Sends the report, with the descriptor that tells refused calls when there is one. The filter lets
 * sendmsg pass on this descriptor alone, and exec closes it. */
static void send_report(struct inside *inside, enum report_kind kind, int listener)
{
    inside->report.kind = kind;
    struct iovec part = {&inside->report, sizeof inside->report};
    union {
        char bytes[CMSG_SPACE(sizeof(int))];
        struct cmsghdr header;
    } control = {.bytes = {0}};
    struct msghdr message = {.msg_iov = &part, .msg_iovlen = 1};
    if (listener >= 0) {
        message.msg_control = control.bytes;
        message.msg_controllen = sizeof control.bytes;
        struct cmsghdr *header = CMSG_FIRSTHDR(&message);
        header->cmsg_level = SOL_SOCKET;
        header->cmsg_type = SCM_RIGHTS;
        header->cmsg_len = CMSG_LEN(sizeof(int));
        memcpy(CMSG_DATA(header), &listener, sizeof listener);
    }
    if (sendmsg(SLOT_NOTES, &message, MSG_NOSIGNAL) < 0)
        _exit(1);
}

static _Noreturn void fail(struct inside *inside, const char *what, int error)
{
    snprintf(inside->report.failure, sizeof inside->report.failure, "%s%s%s", what,
             error ? ": " : "", error ? strerrordesc_np(error) : "");
    send_report(inside, REPORT_FAILED, -1);
    _exit(1);
}

static void enter_working_folder(struct inside *inside)
{
    const struct box_plan *plan = inside->plan;
    bool rooted = layer_active(&inside->report, BOX_PRIVATE_ROOT);
    /* Without a private root the host's folder itself is where the program works. */
    if (inside->work_fd >= 0 && (rooted ? chdir("/work") : fchdir(inside->work_fd)))
        fail(inside, "cannot enter the writable folder", errno);
    if (inside->work_fd < 0 && chdir("/"))
        fail(inside, "cannot enter /", errno);
    if (plan->working_folder && chdir(plan->working_folder))
        fail(inside, "cannot enter the working folder", errno);
}

static void set_no_new_privileges(struct inside *inside)
{
    if (!layer_wanted(inside->plan, BOX_NO_NEW_PRIVILEGES))
        return;
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0))
        layer_fails(&inside->report, BOX_NO_NEW_PRIVILEGES, "prctl", errno);
    else
        layer_works(&inside->report, BOX_NO_NEW_PRIVILEGES);
}

static void drop_capabilities(struct inside *inside)
{
    struct __user_cap_header_struct header = {_LINUX_CAPABILITY_VERSION_3, 0};
    struct __user_cap_data_struct none[2] = {{0, 0, 0}, {0, 0, 0}};
    if (syscall(SYS_capset, &header, none))
        fail(inside, "capset", errno);
}

static void settle(struct inside *inside)
{
    const struct box_plan *plan = inside->plan;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    setpgid(0, 0);
    if (plan->cpu >= 0) {
        cpu_set_t set;
        CPU_ZERO(&set);
        CPU_SET((size_t)plan->cpu, &set);
        if (sched_setaffinity(0, sizeof set, &set))
            fail(inside, "cannot pin to a cpu", errno);
    }
    /* The same addresses in every run; and gcc 12's AddressSanitizer fails at random on hosts with
     * much address randomness. Where a container refuses this, it is as it was. */
    if (plan->profile == BOX_TOOLS)
        personality(ADDR_NO_RANDOMIZE);
}

static const char *nothing_without(const struct report *report, enum box_layer layer)
{
    static char text[160];
    snprintf(text, sizeof text, "nothing is run without %s: %s", box_layer_name(layer),
             report->reason[layer].en);
    return text;
}

/* The layers without which no program of others is started. NULL: all is well. */
static const char *missing_layer(const struct inside *inside)
{
    const struct box_plan *plan = inside->plan;
    const struct report *report = &inside->report;
    if (!layer_waived(plan, BOX_SECCOMP) && !layer_active(report, BOX_SECCOMP))
        return nothing_without(report, BOX_SECCOMP);
    if (!layer_waived(plan, BOX_RLIMITS) && !layer_active(report, BOX_RLIMITS))
        return nothing_without(report, BOX_RLIMITS);
    /* A root that has no other id, as in a container of one user: harmless without capabilities,
     * and no_new_privs keeps exec from giving them back. */
    if (getuid() == 0 && !layer_active(report, BOX_NO_NEW_PRIVILEGES))
        return "the program would run with root's capabilities";
    bool may_see_host =
        layer_waived(plan, BOX_LANDLOCK) &&
        (layer_waived(plan, BOX_PRIVATE_ROOT) || layer_waived(plan, BOX_MOUNT_NAMESPACE));
    if (plan->profile != BOX_RUN && !may_see_host && !layer_active(report, BOX_PRIVATE_ROOT) &&
        !layer_active(report, BOX_LANDLOCK))
        return "the program would see the host's files: neither private root nor Landlock";
    return NULL;
}

static void execute(const struct inside *inside)
{
    const struct box_plan *plan = inside->plan;
    /* Relative, since the program's user may not pass all folders above. */
    char folder[] = "TMPDIR=/tmp", here[] = "TMPDIR=.", below[] = "TMPDIR=tmp";
    bool rooted = layer_active(&inside->report, BOX_PRIVATE_ROOT);
    char path[] = "PATH=/usr/bin:/bin", language[] = "LC_ALL=C";
    char *const plain[] = {path, language,
                           rooted                       ? folder
                           : plan->profile == BOX_TOOLS ? below
                                                        : here,
                           NULL};
    char *const *environment = plan->envp ? plan->envp : plain;
    if (plan->program_fd >= 0)
        execveat(SLOT_PROGRAM, "", plan->argv, environment, AT_EMPTY_PATH);
    else
        execve(plan->argv[0], plan->argv, environment);
}

_Noreturn void program_main(struct inside *inside)
{
    close(SLOT_INIT);
    settle(inside);
    enter_working_folder(inside);
    limits_apply(inside);
    set_no_new_privileges(inside);
    landlock_apply(inside);
    drop_capabilities(inside);
    close_range(SLOT_WORK, ~0u, 0);
    limits_apply_address_space(inside);
    int listener = filter_load(inside);
    const char *missing = missing_layer(inside);
    if (missing)
        fail(inside, missing, 0);
    send_report(inside, REPORT_READY, listener);
    if (listener >= 0)
        close(listener);
    if (inside->probe)
        _exit(inside->probe(inside->probe_argument));
    execute(inside);
    fail(inside,
         inside->plan->program_fd >= 0 ? "cannot execute the program" : inside->plan->argv[0],
         errno);
}
