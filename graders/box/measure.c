/* What can be read of the program from outside, while it runs. */
#include "graders/box/inside.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

int64_t measure_now_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * INT64_C(1000000000) + now.tv_nsec;
}

int64_t box_cpu_ns(const struct box *box)
{
    clockid_t clock;
    struct timespec used;
    if (box->program <= 0 || clock_getcpuclockid(box->program, &clock) != 0 ||
        clock_gettime(clock, &used) != 0)
        return -1;
    return used.tv_sec * INT64_C(1000000000) + used.tv_nsec;
}

static void program_folder(const struct box *box, char out[32])
{
    snprintf(out, 32, "/proc/%d", box->program);
}

int box_reset_peak(const struct box *box)
{
    char folder[32];
    program_folder(box, folder);
    return box->program > 0 ? text_put(folder, "clear_refs", "5") : -1;
}

int64_t box_peak_resident_bytes(const struct box *box)
{
    char folder[32], text[4096];
    program_folder(box, folder);
    if (box->program <= 0 || text_get(folder, "status", text, sizeof text) < 0)
        return -1;
    const char *at = strstr(text, "\nVmHWM:");
    return at ? strtoll(at + strlen("\nVmHWM:"), NULL, 10) * 1024 : -1;
}

int64_t measure_resident_bytes(const struct box *box)
{
    char folder[32], text[256];
    program_folder(box, folder);
    if (box->program <= 0 || text_get(folder, "statm", text, sizeof text) <= 0)
        return -1;
    const char *at = strchr(text, ' ');
    return at ? strtoll(at, NULL, 10) * sysconf(_SC_PAGESIZE) : -1;
}
