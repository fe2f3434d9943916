/* The vector instructions that may be used; see cpu.h. */
#include "reference/kernels/cpu.h"

#include <stdlib.h>
#include <string.h>

static const char *const names[CPU_VECTORS_COUNT] = {
    [CPU_PLAIN] = "plain", [CPU_AVX2] = "avx2", [CPU_AVX512] = "avx512"};

#if defined(__x86_64__)

enum cpu_vectors cpu_processor_vectors(void)
{
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("bmi") ||
        !__builtin_cpu_supports("bmi2") || !__builtin_cpu_supports("popcnt"))
        return CPU_PLAIN;
    if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512vl") ||
        !__builtin_cpu_supports("avx512bw") || !__builtin_cpu_supports("avx512dq") ||
        !__builtin_cpu_supports("avx512cd"))
        return CPU_AVX2;
    return CPU_AVX512;
}

#else

enum cpu_vectors cpu_processor_vectors(void)
{
    return CPU_PLAIN;
}

#endif

/* What the environment allows; CPU_VECTORS_COUNT when it says something unknown. */
static enum cpu_vectors read_limit(const char **value)
{
    *value = getenv("MESHGRADE_CPU");
    if (!*value || !**value)
        return CPU_AVX512;
    enum cpu_vectors limit = CPU_PLAIN;
    while (limit < CPU_VECTORS_COUNT && strcmp(names[limit], *value) != 0)
        limit++;
    return limit;
}

enum cpu_vectors cpu_vectors(void)
{
    const char *value;
    enum cpu_vectors limit = read_limit(&value), most = cpu_processor_vectors();
    if (limit == CPU_VECTORS_COUNT)
        return CPU_PLAIN;
    return limit < most ? limit : most;
}

const char *cpu_vectors_name(enum cpu_vectors vectors)
{
    return names[vectors];
}

int cpu_check_limit(struct error *err)
{
    const char *value;
    if (read_limit(&value) < CPU_VECTORS_COUNT)
        return 0;
    return error_set(err, "MESHGRADE_CPU is \"%s\": it can be plain, avx2 or avx512", value);
}
