/* What a box takes of the host's disk: in its writable folder, and by what it has written to files
 * that have no name any more. Looked at where no file system of bounded size stands in between. */
#include "graders/box/inside.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Of honest tools; more is as much as too many bytes. */
enum { DEPTH_MAX = 16, ENTRIES_MAX = 4096, BLOCK_BYTES = 512 };
static const int64_t TOO_MUCH = INT64_MAX / 4;

struct tally {
    int64_t bytes;
    int entries;
};

static void add_folder(struct tally *tally, int above, const char *name, int depth);

static void add_entry(struct tally *tally, int folder, const char *name, int depth)
{
    struct stat about;
    if (++tally->entries > ENTRIES_MAX)
        tally->bytes = TOO_MUCH;
    if (tally->bytes >= TOO_MUCH || fstatat(folder, name, &about, AT_SYMLINK_NOFOLLOW) != 0)
        return;
    tally->bytes += about.st_blocks * (int64_t)BLOCK_BYTES;
    if (S_ISDIR(about.st_mode))
        add_folder(tally, folder, name, depth + 1);
}

/* A folder that was closed to us hides what is in it. */
static void add_folder(struct tally *tally, int above, const char *name, int depth)
{
    int fd = openat(above, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (depth > DEPTH_MAX || (fd < 0 && errno == EACCES))
        tally->bytes = TOO_MUCH;
    DIR *entries = fd >= 0 ? fdopendir(fd) : NULL;
    struct dirent *entry;
    if (fd >= 0 && !entries)
        close(fd);
    while (entries && tally->bytes < TOO_MUCH && (entry = readdir(entries)))
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0)
            add_entry(tally, fd, entry->d_name, depth);
    if (entries)
        closedir(entries);
}

/* What the kernel charged the program for writing to disks, whether it still has a name or not; 0
 * where the kernel does not tell. */
static int64_t written_bytes(const struct box *box)
{
    char folder[32];
    snprintf(folder, sizeof folder, "/proc/%d", box->program);
    return (int64_t)text_get_number(folder, "io", "\nwrite_bytes: ");
}

int64_t disk_bytes(const struct box *box)
{
    struct tally tally = {0, 0};
    add_folder(&tally, box->work_fd, ".", 0);
    int64_t written = box->profile == BOX_TOOLS ? written_bytes(box) : 0;
    return written > tally.bytes ? written : tally.bytes;
}
