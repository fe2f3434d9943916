/* Control groups that an engine left behind when it was killed. The name of a group tells whose it
 * is: the engine's process id, when that process started, since ids are given anew, and the id's
 * namespace, since in another the same id is another process. */
#include "graders/box/inside.h"

#include <dirent.h>
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char prefix[] = "meshgrade.";

enum { DEPTH_MAX = 12, FOLDERS_MAX = 10000, PATH_BYTES = 1024 };

/* When the process started, in clock ticks since the machine did; 0: not known. */
static unsigned long long start_of(pid_t pid)
{
    enum { FIELD = 20 }; /* counted from the one behind the name, which may hold anything */
    char folder[32], text[1024];
    snprintf(folder, sizeof folder, "/proc/%d", (int)pid);
    if (text_get(folder, "stat", text, sizeof text) <= 0)
        return 0;
    char *at = strrchr(text, ')');
    for (int field = 0; at && field < FIELD; field++)
        at = strchr(at + 1, ' ');
    return at ? strtoull(at, NULL, 10) : 0;
}

static unsigned long long own_namespace(void)
{
    struct stat about;
    return stat("/proc/self/ns/pid", &about) == 0 ? about.st_ino : 0;
}

void leftovers_name(char out[LEFTOVERS_NAME], unsigned number)
{
    snprintf(out, LEFTOVERS_NAME, "%s%d.%llu.%llu.%u", prefix, (int)getpid(), start_of(getpid()),
             own_namespace(), number);
}

/* Whether the group is of an engine that is no more: a process of our own namespace that is gone,
 * or whose id another has now. */
static bool is_left_over(const char *name)
{
    int pid, end = 0;
    unsigned long long start, namespace;
    unsigned number;
    if (sscanf(name, "meshgrade.%d.%llu.%llu.%u%n", &pid, &start, &namespace, &number, &end) != 4 ||
        name[end] || pid <= 0 || namespace != own_namespace())
        return false;
    if (kill(pid, 0) != 0 && errno == ESRCH)
        return true;
    unsigned long long present = start_of(pid);
    return present && start && present != start;
}

/* Removes what is left over in the folder, and goes on in those that are below it. */
static void sweep(const char *folder, int depth, int *folders)
{
    DIR *open_folder = opendir(folder);
    struct dirent *entry;
    while (open_folder && (entry = readdir(open_folder))) {
        char path[PATH_BYTES];
        int length = snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        if (entry->d_type != DT_DIR || entry->d_name[0] == '.' || length >= (int)sizeof path)
            continue;
        if (strncmp(entry->d_name, prefix, sizeof prefix - 1) == 0) {
            if (is_left_over(entry->d_name))
                rmdir(path); /* a group with processes in it is not empty, and stays */
        } else if (depth < DEPTH_MAX && ++*folders < FOLDERS_MAX) {
            sweep(path, depth + 1, folders);
        }
    }
    if (open_folder)
        closedir(open_folder);
}

void leftovers_sweep(const char *root)
{
    int folders = 0;
    sweep(root, 0, &folders);
}
