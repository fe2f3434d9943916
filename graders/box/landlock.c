/* Landlock: what files the program may reach at all, whatever its user id may; and no TCP, no
 * signals out of the box, where the kernel knows how. A second wall behind the private root, and
 * the only one where there are no mount namespaces. */
#include "graders/box/inside.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

/* As in kernels newer than Debian 12's headers. */
struct ruleset {
    uint64_t files, net, scoped;
};

enum {
    ACCESS_TRUNCATE = 1 << 14,
    ACCESS_IOCTL = 1 << 15,
    ACCESS_READ = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR,
    ACCESS_RUN = ACCESS_READ | LANDLOCK_ACCESS_FS_EXECUTE,
    ACCESS_OF_FILES = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE |
                      LANDLOCK_ACCESS_FS_READ_FILE | ACCESS_TRUNCATE | ACCESS_IOCTL
};

/* Every right that this ABI can take away. */
static uint64_t all_rights(int abi)
{
    if (abi >= 5)
        return 0xffff;
    if (abi >= 3)
        return 0x7fff;
    return abi == 2 ? 0x3fff : 0x1fff;
}

static int create_ruleset(int abi)
{
    struct ruleset ruleset = {all_rights(abi), abi >= 4 ? 3 : 0, abi >= 6 ? 3 : 0};
    size_t size = sizeof ruleset.files;
    if (abi >= 4)
        size += sizeof ruleset.net;
    if (abi >= 6)
        size += sizeof ruleset.scoped;
    return (int)syscall(SYS_landlock_create_ruleset, &ruleset, size, 0);
}

static int allow_fd(int ruleset, int fd, uint64_t rights)
{
    struct stat about;
    struct landlock_path_beneath_attr rule = {.allowed_access = rights, .parent_fd = fd};
    if (fstat(fd, &about))
        return -1;
    if (!S_ISDIR(about.st_mode))
        rule.allowed_access &= ACCESS_OF_FILES;
    /* EBADFD: a memory file; it has no path, and Landlock does not stand in its way. */
    if (syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) &&
        errno != EBADFD)
        return -1;
    return 0;
}

static int allow_below(int ruleset, int folder, const char *path, uint64_t rights)
{
    int fd = openat(folder, path, O_PATH | O_CLOEXEC);
    if (fd < 0)
        return errno == ENOENT ? 0 : -1;
    int failed = allow_fd(ruleset, fd, rights);
    close(fd);
    return failed;
}

static int allow_path(int ruleset, const char *path, uint64_t rights)
{
    return allow_below(ruleset, AT_FDCWD, path, rights);
}

/* Returns NULL, or what failed, with errno. */
static const char *allow_files(const struct inside *inside, int ruleset, uint64_t all)
{
    static const char *const common[] = {"/usr", "/lib", "/lib64", "/bin"};
    const struct box_plan *plan = inside->plan;
    if (plan->program_fd >= 0 &&
        allow_fd(ruleset, SLOT_PROGRAM, LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE))
        return "program";
    if (plan->profile == BOX_RUN)
        return NULL;
    for (size_t i = 0; i < sizeof common / sizeof common[0]; i++)
        if (allow_path(ruleset, common[i], ACCESS_RUN))
            return common[i];
    for (int i = 0; i < BOX_PATH_LIMIT && plan->readable[i]; i++)
        if (allow_path(ruleset, plan->readable[i], ACCESS_RUN))
            return plan->readable[i];
    uint64_t write = all & ~(uint64_t)LANDLOCK_ACCESS_FS_EXECUTE;
    uint64_t given = all & (ACCESS_RUN | LANDLOCK_ACCESS_FS_WRITE_FILE | ACCESS_TRUNCATE);
    uint64_t work = plan->profile == BOX_TOOLS ? given : write;
    if (inside->work_fd >= 0 && allow_fd(ruleset, SLOT_WORK, work))
        return "/work";
    /* What is mounted there is another folder than the one that it covers. */
    if (inside->work_fd >= 0 && plan->profile == BOX_TOOLS &&
        (layer_active(&inside->report, BOX_PRIVATE_ROOT)
             ? allow_path(ruleset, "/work/tmp", write)
             : allow_below(ruleset, SLOT_WORK, "tmp", write)))
        return "/work/tmp";
    if (allow_path(ruleset, "/dev/null",
                   LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE))
        return "/dev/null";
    /* The host's /proc, too: the kernel guards the processes outside of a Landlock domain. */
    if (plan->profile == BOX_TOOLS && allow_path(ruleset, "/proc", ACCESS_READ))
        return "/proc";
    if (layer_active(&inside->report, BOX_PRIVATE_ROOT) && allow_path(ruleset, "/tmp", write))
        return "/tmp";
    return NULL;
}

void landlock_apply(struct inside *inside)
{
    struct report *report = &inside->report;
    if (!layer_wanted(inside->plan, BOX_LANDLOCK))
        return;
    int abi = (int)syscall(SYS_landlock_create_ruleset, NULL, 0, LANDLOCK_CREATE_RULESET_VERSION);
    if (abi < 1) {
        layer_fails(report, BOX_LANDLOCK, "landlock_create_ruleset", errno);
        return;
    }
    int ruleset = create_ruleset(abi);
    const char *failed = ruleset < 0 ? "landlock_create_ruleset" : NULL;
    if (!failed)
        failed = allow_files(inside, ruleset, all_rights(abi));
    if (!failed && syscall(SYS_landlock_restrict_self, ruleset, 0))
        failed = "landlock_restrict_self";
    if (failed) {
        layer_fails(report, BOX_LANDLOCK, failed, errno);
    } else {
        layer_works(report, BOX_LANDLOCK);
        report->landlock_abi = abi;
    }
    if (ruleset >= 0)
        close(ruleset);
}
