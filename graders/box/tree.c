/* The CPU time of all processes of a box, as /proc tells it: of those that live, and of those that
 * were waited for, whose time goes to who waited. So it is known without control groups, too. A
 * parent is read before its children: a child that ends in between is missed until the next look,
 * and none is counted twice. */
#include "graders/box/inside.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { PROCESSES_MAX = 256, FIELDS_BEFORE_TIMES = 12, TIMES = 4 };

struct family {
    pid_t members[PROCESSES_MAX];
    int count;
};

static void add_member(struct family *family, pid_t pid)
{
    for (int i = 0; i < family->count; i++)
        if (family->members[i] == pid)
            return;
    if (pid > 0 && family->count < PROCESSES_MAX)
        family->members[family->count++] = pid;
}

static void add_listed(struct family *family, const char *list)
{
    char *end;
    for (const char *at = list;; at = end) {
        long pid = strtol(at, &end, 10);
        if (end == at)
            return;
        add_member(family, (pid_t)pid);
    }
}

/* The children of each thread. Kernels without these lists tell of nobody. */
static void add_children(struct family *family, pid_t pid)
{
    char folder[64], path[352], list[4096];
    snprintf(folder, sizeof folder, "/proc/%d/task", (int)pid);
    DIR *threads = opendir(folder);
    struct dirent *thread;
    while (threads && (thread = readdir(threads))) {
        snprintf(path, sizeof path, "%s/%s", folder, thread->d_name);
        if (thread->d_name[0] != '.' && text_get(path, "children", list, sizeof list) > 0)
            add_listed(family, list);
    }
    if (threads)
        closedir(threads);
}

/* Clock ticks that the process used itself, and that those had which it waited for. */
static int64_t ticks_of(pid_t pid)
{
    char folder[32], text[1024];
    snprintf(folder, sizeof folder, "/proc/%d", (int)pid);
    if (text_get(folder, "stat", text, sizeof text) <= 0)
        return 0;
    char *at = strrchr(text, ')'); /* the name before it may hold anything */
    for (int field = 0; at && field < FIELDS_BEFORE_TIMES; field++)
        at = strchr(at + 1, ' ');
    int64_t ticks = 0;
    for (int time = 0; at && time < TIMES; time++)
        ticks += strtoll(at, &at, 10);
    return ticks;
}

int64_t tree_cpu_ns(const struct box *box)
{
    struct family family = {.count = 0};
    int64_t ticks = 0;
    add_member(&family, box->init);
    add_member(&family, box->program);
    for (int i = 0; i < family.count; i++) {
        ticks += ticks_of(family.members[i]);
        add_children(&family, family.members[i]);
    }
    return ticks * (INT64_C(1000000000) / sysconf(_SC_CLK_TCK));
}
