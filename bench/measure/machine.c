/* The machine that was measured; see machine.h. */
#include "bench/measure/machine.h"

#include <ctype.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>
#include <unistd.h>

#ifndef BUILD_FLAGS
#define BUILD_FLAGS ""
#endif

/* First line of a small file, without its newline; "" when there is none. */
static void read_line(const char *path, char *line, int capacity)
{
    FILE *file = fopen(path, "re");
    line[0] = '\0';
    if (!file)
        return;
    if (!fgets(line, capacity, file))
        line[0] = '\0';
    line[strcspn(line, "\n")] = '\0';
    fclose(file);
}

static void read_cpu(struct machine *machine)
{
    char line[4096];
    FILE *file = fopen("/proc/cpuinfo", "re");
    while (file && fgets(line, sizeof line, file)) {
        char *value = strchr(line, ':');
        if (!value)
            continue;
        value += 1 + (value[1] == ' ');
        value[strcspn(value, "\n")] = '\0';
        if (strncmp(line, "model name", 10) == 0 && !machine->cpu[0])
            snprintf(machine->cpu, sizeof machine->cpu, "%s", value);
        if (strncmp(line, "flags", 5) == 0 && strstr(value, " hypervisor"))
            machine->hypervisor = true;
    }
    if (file)
        fclose(file);
}

static void read_caches(struct machine *machine)
{
    for (int i = 0; i < MACHINE_CACHES_MAX; i++) {
        const char *folder = "/sys/devices/system/cpu/cpu0/cache/index";
        struct machine_cache *cache = &machine->caches[machine->cache_count];
        char path[96], text[32], *unit;
        snprintf(path, sizeof path, "%s%d/level", folder, i);
        read_line(path, text, sizeof text);
        if (!text[0])
            break;
        cache->level = atoi(text);
        snprintf(path, sizeof path, "%s%d/type", folder, i);
        read_line(path, cache->type, sizeof cache->type);
        snprintf(path, sizeof path, "%s%d/size", folder, i);
        read_line(path, text, sizeof text);
        cache->bytes = strtoll(text, &unit, 10);
        if (*unit == 'K')
            cache->bytes *= 1024;
        if (*unit == 'M')
            cache->bytes *= 1024 * 1024;
        machine->cache_count++;
    }
}

static void read_huge_pages(struct machine *machine)
{
    char text[64];
    read_line("/sys/kernel/mm/transparent_hugepage/enabled", text, sizeof text);
    const char *from = strchr(text, '['), *to = strchr(text, ']');
    if (from && to > from)
        snprintf(machine->huge_pages, sizeof machine->huge_pages, "%.*s", (int)(to - from - 1),
                 from + 1);
}

void machine_describe(struct machine *machine)
{
    struct utsname system;
    cpu_set_t cpus;
    *machine = (struct machine){0};
    read_cpu(machine);
    read_caches(machine);
    read_huge_pages(machine);
    if (uname(&system) == 0)
        snprintf(machine->kernel, sizeof machine->kernel, "%.40s %.50s", system.sysname,
                 system.release);
    machine->core_count = sched_getaffinity(0, sizeof cpus, &cpus) == 0 ? CPU_COUNT(&cpus) : 1;
    machine->ram_bytes = (int64_t)sysconf(_SC_PHYS_PAGES) * sysconf(_SC_PAGESIZE);
    snprintf(machine->compiler, sizeof machine->compiler, "%s%s",
#ifdef __clang__
             "", __VERSION__
#else
             "gcc ", __VERSION__
#endif
    );
    snprintf(machine->flags, sizeof machine->flags, "%s", BUILD_FLAGS);
}
