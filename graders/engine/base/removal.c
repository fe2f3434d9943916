/* Removes what hostile code may have left, of any depth; see files.h. By descriptors and without
 * recursion: a folder that holds others hands them up to the top one by one, and goes. So there is
 * never more than one name below the top, however long the whole path was, and three open folders. */
#include "graders/engine/base/files.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* The top folder, and how many were handed up to it: each gets a name of its own. */
struct removal {
    int top;
    dev_t device;
    unsigned long long moved;
};

static bool is_dots(const char *name)
{
    return strcmp(name, ".") == 0 || strcmp(name, "..") == 0;
}

/* Opens a folder for reading, whatever mode its maker gave it. -1: it is none, or not ours. */
static int open_folder(int above, const char *name)
{
    char itself[32];
    int handle = openat(above, name, O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (handle < 0)
        return -1;
    snprintf(itself, sizeof itself, "/proc/self/fd/%d", handle);
    chmod(itself, 0700); /* where this fails, reading may still be allowed */
    int folder = openat(handle, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    close(handle);
    return folder;
}

/* Whatever stands in the way of a new name was made to: another is tried. A folder can be moved by
 * who may write to it. */
static bool hand_up(struct removal *removal, int folder, const char *name)
{
    enum { TRIES = 100 };
    int itself = open_folder(folder, name);
    if (itself < 0)
        return false;
    close(itself);
    for (int try = 0; try < TRIES; try++) {
        char new_name[64];
        snprintf(new_name, sizeof new_name, ".removed-%llu", removal->moved++);
        if (renameat(folder, name, removal->top, new_name) == 0)
            return true;
        if (errno != EEXIST && errno != ENOTEMPTY && errno != ENOTDIR)
            return false;
    }
    return false;
}

/* What somebody mounted below the top is not ours. */
static bool is_mounted(const struct removal *removal, int folder)
{
    struct stat about;
    return fstat(folder, &about) != 0 || about.st_dev != removal->device;
}

/* Empties a folder below the top and removes it. Returns whether anything changed. */
static bool remove_folder(struct removal *removal, const char *name)
{
    int folder = open_folder(removal->top, name);
    DIR *entries = folder >= 0 && !is_mounted(removal, folder) ? fdopendir(folder) : NULL;
    struct dirent *entry;
    bool changed = false;
    if (folder >= 0 && !entries)
        close(folder);
    while (entries && (entry = readdir(entries))) {
        if (is_dots(entry->d_name))
            continue;
        changed |= unlinkat(folder, entry->d_name, 0) == 0 ||
                   unlinkat(folder, entry->d_name, AT_REMOVEDIR) == 0 ||
                   hand_up(removal, folder, entry->d_name);
    }
    if (entries)
        closedir(entries);
    return unlinkat(removal->top, name, AT_REMOVEDIR) == 0 || changed;
}

/* One pass over the top. Names come and go meanwhile, so passes follow until one changes nothing. */
static bool remove_entries(struct removal *removal)
{
    int again = openat(removal->top, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *entries = again >= 0 ? fdopendir(again) : NULL;
    struct dirent *entry;
    bool changed = false;
    if (again >= 0 && !entries)
        close(again);
    while (entries && (entry = readdir(entries)))
        if (!is_dots(entry->d_name))
            changed |= unlinkat(removal->top, entry->d_name, 0) == 0 ||
                       remove_folder(removal, entry->d_name);
    if (entries)
        closedir(entries);
    return changed;
}

void folder_remove(const char *path)
{
    struct removal removal = {.top = open_folder(AT_FDCWD, path)};
    if (removal.top < 0) {
        unlink(path); /* a file, or a link to something: that is not followed */
        return;
    }
    struct stat about;
    if (fstat(removal.top, &about) == 0) {
        removal.device = about.st_dev;
        while (remove_entries(&removal))
            continue;
    }
    close(removal.top);
    rmdir(path);
}
