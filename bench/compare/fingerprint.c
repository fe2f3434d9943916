/* The fingerprint of a run; see fingerprint.h. */
#include "bench/compare/fingerprint.h"

#include "reference/kernels/cpu.h"

#include <stdio.h>
#include <string.h>

/* FNV-1a of the file's bytes and of its length, going on from `hash`. */
static unsigned long long hash_file(const char *path, unsigned long long hash)
{
    const unsigned long long prime = 0x100000001B3U;
    unsigned char bytes[65536];
    size_t count;
    unsigned long long length = 0;
    FILE *file = fopen(path, "re");
    while (file && (count = fread(bytes, 1, sizeof bytes, file)) > 0) {
        for (size_t i = 0; i < count; i++)
            hash = (hash ^ bytes[i]) * prime;
        length += count;
    }
    if (file)
        fclose(file);
    return (hash ^ length) * prime;
}

/* Whether an earlier contender of the plan starts the same program. */
static bool was_seen(const struct plan *plan, int job, int contender)
{
    const char *program = plan->jobs[job].contenders[contender].program;
    for (int i = 0; i <= job; i++)
        for (int k = 0; k < (i < job ? plan->jobs[i].contender_count : contender); k++)
            if (strcmp(plan->jobs[i].contenders[k].program, program) == 0)
                return true;
    return false;
}

void fingerprint_write(const struct plan *plan, const char *program, const struct machine *machine,
                       char text[FINGERPRINT_BYTES])
{
    unsigned long long hash = hash_file(program, 0xCBF29CE484222325U);
    for (int i = 0; i < plan->job_count; i++)
        for (int k = 0; k < plan->jobs[i].contender_count; k++) {
            const struct contender *contender = &plan->jobs[i].contenders[k];
            if (contender->kind == CONTENDER_PEER && !was_seen(plan, i, k))
                hash = hash_file(contender->program, hash);
        }
    snprintf(text, FINGERPRINT_BYTES, "%016llx %s %d %s %s", hash, machine->cpu,
             machine->core_count, machine->kernel, cpu_vectors_name(cpu_vectors()));
}
