/* The private root: a small read-only tmpfs that holds copies of the few host folders which the
 * program may see, and nothing else. */
#include "graders/box/inside.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

enum { COVER_BYTES = 1 << 20 /* of folders and names; it holds no file's bytes */ };

static void add_tree(struct inside *inside, const char *source, const char *target,
                     uint64_t attributes)
{
    for (int i = 0; i < inside->tree_count; i++)
        if (strcmp(inside->trees[i].target, target) == 0)
            return;
    inside->trees[inside->tree_count++] = (struct bound_tree){
        .source = source, .target = target, .fd = -1, .attributes = attributes | MOUNT_ATTR_NOSUID};
}

void root_plan(struct inside *inside)
{
    static const char *const common[] = {"/usr", "/lib", "/lib64", "/bin"};
    const struct box_plan *plan = inside->plan;
    uint64_t fixed = MOUNT_ATTR_RDONLY | MOUNT_ATTR_NODEV;
    if (plan->profile == BOX_RUN)
        return;
    for (size_t i = 0; i < sizeof common / sizeof common[0]; i++)
        add_tree(inside, common[i], common[i], fixed);
    add_tree(inside, "/dev/null", "/dev/null", MOUNT_ATTR_RDONLY | MOUNT_ATTR_NOEXEC);
    if (plan->covered)
        add_tree(inside, NULL, plan->covered, fixed); /* before what shall be seen in it */
    for (int i = 0; i < BOX_PATH_LIMIT && plan->readable[i]; i++)
        add_tree(inside, plan->readable[i], plan->readable[i], fixed);
    /* A compiler writes there and executes nothing; a tool is given programs there. */
    if (plan->writable)
        add_tree(inside, plan->writable, "/work",
                 MOUNT_ATTR_NODEV |
                     (plan->profile == BOX_BUILD ? MOUNT_ATTR_NOEXEC : MOUNT_ATTR_RDONLY));
}

static int take_tree(struct bound_tree *tree)
{
    struct stat about;
    if (!tree->source)
        return 0;
    if (lstat(tree->source, &about))
        return errno == ENOENT ? 0 : -1; /* no /lib64 here: nothing to show */
    if (S_ISLNK(about.st_mode)) {
        ssize_t length = readlink(tree->source, tree->link, sizeof tree->link - 1);
        tree->link[length > 0 ? length : 0] = '\0';
        return length > 0 ? 0 : -1;
    }
    tree->is_folder = S_ISDIR(about.st_mode);
    int fd = open_tree(AT_FDCWD, tree->source, OPEN_TREE_CLONE | OPEN_TREE_CLOEXEC | AT_RECURSIVE);
    if (fd < 0)
        return -1;
    struct mount_attr attributes = {.attr_set = tree->attributes, .propagation = MS_PRIVATE};
    if (mount_setattr(fd, "", AT_EMPTY_PATH | AT_RECURSIVE, &attributes, sizeof attributes)) {
        int error = errno;
        close(fd);
        errno = error;
        return -1;
    }
    tree->fd = fd;
    return 0;
}

int root_take_trees(struct inside *inside)
{
    for (int i = 0; i < inside->tree_count; i++)
        if (inside->trees[i].fd < 0 && !inside->trees[i].link[0] && take_tree(&inside->trees[i]))
            return -1;
    return 0;
}

void root_close_trees(struct inside *inside)
{
    for (int i = 0; i < inside->tree_count; i++) {
        if (inside->trees[i].fd >= 0)
            close(inside->trees[i].fd);
        inside->trees[i].fd = -1;
    }
}

/* Makes the folders above `path`, which is relative to the new root. */
static void make_parents(const char *path)
{
    char part[512];
    snprintf(part, sizeof part, "%s", path);
    for (char *at = part; *at; at++)
        if (*at == '/') {
            *at = '\0';
            mkdir(part, 0755);
            *at = '/';
        }
}

static int mount_scratch(const char *target, uint64_t bytes, int mode)
{
    char options[80];
    snprintf(options, sizeof options, "size=%llu,nr_inodes=%d,mode=%o", (unsigned long long)bytes,
             4096, (unsigned)mode);
    return mount("tmpfs", target, "tmpfs", MS_NOSUID | MS_NODEV | MS_NOEXEC, options);
}

/* Puts one tree into the new root, which is the current folder. */
static int attach_tree(const struct bound_tree *tree)
{
    const char *target = tree->target + 1; /* relative to the new root */
    if (!tree->source)
        return mount_scratch(target, COVER_BYTES, 0755);
    make_parents(target);
    if (tree->link[0])
        return symlink(tree->link, target);
    if (tree->fd < 0)
        return 0;
    if (tree->is_folder && mkdir(target, 0755) && errno != EEXIST)
        return -1;
    if (!tree->is_folder) {
        int fd = open(target, O_CREAT | O_WRONLY | O_CLOEXEC, 0644);
        if (fd < 0)
            return -1;
        close(fd);
    }
    return move_mount(tree->fd, "", AT_FDCWD, target, MOVE_MOUNT_F_EMPTY_PATH);
}

/* A cover is written to while it is furnished: its user would else be the program's. */
static int close_cover(const struct bound_tree *tree)
{
    unsigned long flags = MS_REMOUNT | MS_BIND | MS_RDONLY | MS_NOSUID | MS_NODEV | MS_NOEXEC;
    return tree->source ? 0 : mount(NULL, tree->target + 1, NULL, flags, NULL);
}

/* Fills the new root. Returns NULL, or what failed, with errno. */
static const char *furnish(struct inside *inside)
{
    const struct box_plan *plan = inside->plan;
    for (int i = 0; i < inside->tree_count; i++)
        if (attach_tree(&inside->trees[i]))
            return inside->trees[i].target;
    for (int i = 0; i < inside->tree_count; i++)
        if (close_cover(&inside->trees[i]))
            return inside->trees[i].target;
    root_close_trees(inside);
    if (plan->profile == BOX_RUN)
        return NULL;
    if (plan->profile == BOX_TOOLS && plan->writable &&
        mount_scratch("work/tmp", plan->scratch_bytes, 01777) && errno != ENOENT)
        return "/work/tmp";
    if (mkdir("tmp", 0755) || mount_scratch("tmp", plan->scratch_bytes, 01777))
        return "tmp";
    /* Before the host's /proc goes: the kernel grants a new one only beside a whole one. */
    if (plan->profile == BOX_TOOLS &&
        (mkdir("proc", 0755) ||
         mount("proc", "proc", "proc", MS_NOSUID | MS_NODEV | MS_NOEXEC, NULL)))
        return "proc";
    return NULL;
}

/* The new root is the current folder. Returns NULL, or what failed, with errno. */
static const char *change_root(void)
{
    unsigned long flags = MS_REMOUNT | MS_BIND | MS_RDONLY | MS_NOSUID | MS_NODEV;
    if (mount(NULL, ".", NULL, flags, NULL))
        return "mount MS_RDONLY";
    /* Puts the old root on top of the new one, from where it is taken away. */
    if (syscall(SYS_pivot_root, ".", "."))
        return "pivot_root";
    if (umount2(".", MNT_DETACH) || chdir("/"))
        return "umount2";
    return NULL;
}

void root_enter(struct inside *inside)
{
    const struct box_plan *plan = inside->plan;
    if (!layer_wanted(plan, BOX_PRIVATE_ROOT))
        return;
    if (!layer_active(&inside->report, BOX_MOUNT_NAMESPACE)) {
        layer_lacks(
            &inside->report, BOX_PRIVATE_ROOT,
            (struct phrase){"needs a mount namespace", "necesita un espacio de montajes propio"});
        return;
    }
    const char *failed = NULL;
    if (mount(NULL, "/", NULL, MS_REC | MS_PRIVATE, NULL))
        failed = "mount MS_PRIVATE";
    else if (root_take_trees(inside))
        failed = "open_tree";
    else if (mount_scratch("/tmp", 1 << 20, 0755) || chdir("/tmp"))
        failed = "tmpfs";
    else {
        failed = furnish(inside);
        if (!failed)
            failed = change_root();
        if (failed) {
            int error = errno;
            if (chdir("/") || umount2("/tmp", MNT_DETACH))
                failed = "umount2 /tmp";
            errno = error;
        }
    }
    if (failed)
        layer_fails(&inside->report, BOX_PRIVATE_ROOT, failed, errno);
    else
        layer_works(&inside->report, BOX_PRIVATE_ROOT);
}
