/* Control groups, version 2 or 1: one group a box, for memory, processes and CPU time. It stands
 * below the engine's own group, so that the engine's limits hold for boxes too. Version 2 hands
 * controllers down only from groups without processes of their own; there it stands beside the
 * engine's group. */
#include "graders/box/inside.h"

#include <errno.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

static const char mount_point[] = "/sys/fs/cgroup";

enum { PATH_BYTES = sizeof((struct box *)0)->cgroup_memory };

static void fails(struct box *box, enum box_layer layer, const char *what, int error)
{
    struct report report = {.active = box->active};
    layer_fails(&report, layer, what, error);
    box->active = report.active;
    box->reason[layer] = report.reason[layer];
}

/* Whether `controller` is one of the comma-separated `list`. */
static bool has_controller(const char *list, const char *controller)
{
    size_t length = strlen(controller);
    for (const char *at = list; (at = strstr(at, controller)); at += length)
        if ((at == list || at[-1] == ',') && (at[length] == '\0' || at[length] == ','))
            return true;
    return false;
}

/* The engine's own group as /proc/self/cgroup tells it; lines are "id:controllers:path". An empty
 * controller means version 2. Returns 0 or -1. */
static int own_path(const char *controller, char *out, size_t capacity)
{
    char text[4096], *rest = text, *line;
    if (text_get("/proc/self", "cgroup", text, sizeof text) < 0)
        return -1;
    while ((line = strsep(&rest, "\n"))) {
        strsep(&line, ":");
        char *controllers = line ? strsep(&line, ":") : NULL;
        if (!line)
            continue;
        if (*controller ? has_controller(controllers, controller) : !*controllers) {
            snprintf(out, capacity, "%s", strcmp(line, "/") ? line : "");
            return 0;
        }
    }
    return -1;
}

/* The folder of the engine's own group. In a container the path in /proc can be the host's; its own
 * group is then the mounted root. */
static int find_parent(const char *controller, char *out, size_t capacity)
{
    char own[PATH_BYTES] = "";
    const char *slash = *controller ? "/" : "";
    if (own_path(controller, own, sizeof own))
        return -1;
    snprintf(out, capacity, "%s%s%s%s", mount_point, slash, controller, own);
    if (access(out, F_OK) == 0)
        return 0;
    snprintf(out, capacity, "%s%s%s", mount_point, slash, controller);
    return access(out, F_OK);
}

/* Once an engine, before it makes its first group. An engine that was killed may have had another
 * group of its own, so root looks everywhere; others may remove groups only in their own. */
static void sweep_once(bool version_2)
{
    static const char *const controllers[] = {"memory", "pids", "cpuacct"};
    static atomic_flag swept = ATOMIC_FLAG_INIT; /* workers inherit it */
    if (atomic_flag_test_and_set(&swept))
        return;
    for (size_t i = 0; i < (version_2 ? 1 : sizeof controllers / sizeof controllers[0]); i++) {
        const char *controller = version_2 ? "" : controllers[i];
        char root[PATH_BYTES];
        snprintf(root, sizeof root, "%s/%s", mount_point, controller);
        if (geteuid() == 0)
            leftovers_sweep(root);
        else if (find_parent(controller, root, sizeof root) == 0)
            leftovers_sweep(root);
    }
}

/* Makes a group in `parent`. Leaves `out` empty when it cannot, with errno. */
static int make_group(const char *parent, char *out)
{
    static atomic_uint sequence;
    char name[LEFTOVERS_NAME];
    leftovers_name(name, atomic_fetch_add(&sequence, 1));
    int length = snprintf(out, PATH_BYTES, "%s/%s", parent, name);
    if (length >= PATH_BYTES || mkdir(out, 0755)) {
        int error = length >= PATH_BYTES ? ENAMETOOLONG : errno;
        out[0] = '\0';
        errno = error;
        return -1;
    }
    return 0;
}

static int put_number(const char *group, const char *name, uint64_t value)
{
    char text[32];
    snprintf(text, sizeof text, "%llu", (unsigned long long)value);
    return text_put(group, name, text);
}

/* init and program, and in a build its children. */
static uint64_t process_limit(const struct box_plan *plan)
{
    return plan->profile == BOX_BUILD ? plan->process_count + 1ull : 2;
}

static void set_active(struct box *box, enum box_layer layer)
{
    box->active |= 1u << layer;
}

static bool has_file(const char *group, const char *name)
{
    char path[PATH_BYTES + 32];
    snprintf(path, sizeof path, "%s/%s", group, name);
    return access(path, F_OK) == 0;
}

/* Below the engine's group, or beside it when only there memory can be limited. */
static int make_version_2_group(char *out)
{
    char below[PATH_BYTES], beside[PATH_BYTES];
    if (find_parent("", below, sizeof below) || make_group(below, out))
        return -1;
    memcpy(beside, below, sizeof beside);
    char *last = strrchr(beside, '/');
    if (has_file(out, "memory.max") || !last || last < beside + sizeof mount_point - 1)
        return 0;
    *last = '\0';
    char other[PATH_BYTES];
    if (make_group(beside, other))
        return 0;
    bool better = has_file(other, "memory.max");
    rmdir(better ? out : other);
    if (better)
        memcpy(out, other, sizeof other);
    return 0;
}

/* One folder serves all controllers, as far as the parent hands them down. */
static void make_version_2(const struct box_plan *plan, struct box *box)
{
    static const enum box_layer layers[] = {BOX_CGROUP_MEMORY, BOX_CGROUP_PIDS, BOX_CGROUP_CPU};
    char group[PATH_BYTES];
    box->cgroup_version = 2;
    if (make_version_2_group(group)) {
        for (size_t i = 0; i < sizeof layers / sizeof layers[0]; i++)
            if (layer_wanted(plan, layers[i]))
                fails(box, layers[i], "mkdir", errno);
        return;
    }
    /* cpu.stat is in every group, so that this layer always keeps the folder for the others. */
    memcpy(box->cgroup_cpu, group, sizeof group);
    set_active(box, BOX_CGROUP_CPU);
    if (layer_wanted(plan, BOX_CGROUP_MEMORY)) {
        if (put_number(group, "memory.max", plan->memory_bytes)) {
            fails(box, BOX_CGROUP_MEMORY, "memory.max", errno);
        } else {
            text_put(group, "memory.swap.max", "0");
            text_put(group, "memory.oom.group", "1");
            memcpy(box->cgroup_memory, group, sizeof group);
            set_active(box, BOX_CGROUP_MEMORY);
        }
    }
    if (layer_wanted(plan, BOX_CGROUP_PIDS)) {
        if (put_number(group, "pids.max", process_limit(plan))) {
            fails(box, BOX_CGROUP_PIDS, "pids.max", errno);
        } else {
            memcpy(box->cgroup_pids, group, sizeof group);
            set_active(box, BOX_CGROUP_PIDS);
        }
    }
}

/* A group of version 1, with its limit when there is one. */
static void make_one(const struct box_plan *plan, struct box *box, enum box_layer layer,
                     const char *controller, char *group, const char *limit, uint64_t value)
{
    if (!layer_wanted(plan, layer))
        return;
    char parent[PATH_BYTES];
    if (find_parent(controller, parent, sizeof parent) || make_group(parent, group)) {
        fails(box, layer, controller, errno);
        return;
    }
    if (limit && put_number(group, limit, value)) {
        fails(box, layer, limit, errno);
        rmdir(group);
        group[0] = '\0';
        return;
    }
    set_active(box, layer);
}

void cgroup_make(const struct box_plan *plan, struct box *box)
{
    uint32_t all = 1u << BOX_CGROUP_MEMORY | 1u << BOX_CGROUP_PIDS | 1u << BOX_CGROUP_CPU;
    if ((plan->disabled_layers & all) == all)
        return;
    bool version_2 = access("/sys/fs/cgroup/cgroup.controllers", F_OK) == 0;
    sweep_once(version_2);
    if (version_2) {
        make_version_2(plan, box);
        return;
    }
    box->cgroup_version = 1;
    make_one(plan, box, BOX_CGROUP_MEMORY, "memory", box->cgroup_memory, "memory.limit_in_bytes",
             plan->memory_bytes);
    if (box->cgroup_memory[0]) /* there where swap is accounted */
        put_number(box->cgroup_memory, "memory.memsw.limit_in_bytes", plan->memory_bytes);
    make_one(plan, box, BOX_CGROUP_PIDS, "pids", box->cgroup_pids, "pids.max", process_limit(plan));
    make_one(plan, box, BOX_CGROUP_CPU, "cpuacct", box->cgroup_cpu, NULL, 0);
}

void cgroup_join(struct box *box)
{
    const struct {
        enum box_layer layer;
        const char *group;
    } groups[] = {{BOX_CGROUP_MEMORY, box->cgroup_memory},
                  {BOX_CGROUP_PIDS, box->cgroup_pids},
                  {BOX_CGROUP_CPU, box->cgroup_cpu}};
    for (size_t i = 0; i < sizeof groups / sizeof groups[0]; i++)
        if (groups[i].group[0] && put_number(groups[i].group, "cgroup.procs", (uint64_t)box->init))
            fails(box, groups[i].layer, "cgroup.procs", errno);
}

static bool is_active(const struct box *box, enum box_layer layer)
{
    return box->active >> layer & 1;
}

/* Kills what a group still holds; needed only where no pid namespace does it. */
static void kill_members(const struct box *box, const char *group)
{
    char text[8192];
    if (box->cgroup_version == 2 && text_put(group, "cgroup.kill", "1") == 0)
        return;
    for (int round = 0; round < 200; round++) {
        char *end;
        int killed = 0;
        if (text_get(group, "cgroup.procs", text, sizeof text) <= 0)
            return;
        for (const char *at = text;; at = end) {
            long pid = strtol(at, &end, 10);
            if (end == at)
                break;
            if (pid > 1 && pid != box->init && kill((pid_t)pid, SIGKILL) == 0)
                killed++;
        }
        if (!killed)
            return;
        nanosleep(&(struct timespec){.tv_nsec = 500000}, NULL);
    }
}

void cgroup_kill(const struct box *box)
{
    const char *group = box->cgroup_pids[0] ? box->cgroup_pids : box->cgroup_memory;
    if (!group[0])
        group = box->cgroup_cpu;
    if (group[0])
        kill_members(box, group);
}

uint64_t cgroup_oom_kills(const struct box *box)
{
    if (!is_active(box, BOX_CGROUP_MEMORY))
        return 0;
    return text_get_number(box->cgroup_memory,
                           box->cgroup_version == 2 ? "memory.events" : "memory.oom_control",
                           "oom_kill ");
}

uint64_t cgroup_peak_bytes(const struct box *box)
{
    if (!is_active(box, BOX_CGROUP_MEMORY))
        return 0;
    return text_get_number(box->cgroup_memory,
                           box->cgroup_version == 2 ? "memory.peak" : "memory.max_usage_in_bytes",
                           NULL);
}

int64_t cgroup_cpu_ns(const struct box *box)
{
    if (!is_active(box, BOX_CGROUP_CPU))
        return -1;
    if (box->cgroup_version == 2)
        return (int64_t)text_get_number(box->cgroup_cpu, "cpu.stat", "usage_usec ") * 1000;
    return (int64_t)text_get_number(box->cgroup_cpu, "cpuacct.usage", NULL);
}

/* A group is busy for a moment after its last process is gone. */
static bool remove_group(char *group)
{
    if (!group[0])
        return true;
    for (int round = 0; rmdir(group) && errno != ENOENT; round++) {
        if (errno != EBUSY || round == 2000)
            return false;
        nanosleep(&(struct timespec){.tv_nsec = 200000}, NULL);
    }
    group[0] = '\0';
    return true;
}

bool cgroup_remove(struct box *box)
{
    bool memory = remove_group(box->cgroup_memory);
    bool pids = remove_group(box->cgroup_pids);
    bool cpu = remove_group(box->cgroup_cpu);
    return memory && pids && cpu;
}
