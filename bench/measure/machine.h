/* The machine that was measured, as results describe it. */
#ifndef BENCH_MEASURE_MACHINE_H
#define BENCH_MEASURE_MACHINE_H

#include <stdbool.h>
#include <stdint.h>

enum { MACHINE_CACHES_MAX = 8 };

struct machine_cache {
    int level;
    char type[16]; /* "Data", "Instruction", "Unified" */
    int64_t bytes; /* of one instance */
};

struct machine {
    char cpu[96];
    int core_count;  /* that this process may use */
    bool hypervisor; /* runs in a virtual machine */
    int64_t ram_bytes;
    char kernel[96];
    char compiler[64], flags[160]; /* of this program */
    char huge_pages[16];           /* "always", "madvise", "never", "" */
    struct machine_cache caches[MACHINE_CACHES_MAX];
    int cache_count;
};

/* Describes this machine; what the system does not tell stays "" or 0. */
void machine_describe(struct machine *machine);

#endif
