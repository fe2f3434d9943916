/* What the vector variants for x86-64 share: the attributes that let one function use instructions
 * which the rest of the program must not, and the questions whether this processor has them. */
#ifndef REFERENCE_KERNELS_X86_H
#define REFERENCE_KERNELS_X86_H

#include <stdbool.h>

#if defined(__x86_64__)

/* No fma here: a product and a sum rounded once would not equal the plain variants. */
#define TARGET_AVX2 __attribute__((target("avx2,bmi,bmi2,popcnt,prfchw")))
#define TARGET_AVX512                                                                              \
    __attribute__((target("avx512f,avx512vl,avx512bw,avx512dq,avx512cd,bmi,bmi2,popcnt,prfchw")))

static inline bool cpu_has_avx2(void)
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2") &&
           __builtin_cpu_supports("popcnt");
}

/* The parts of AVX-512 that every processor since Skylake-X (2017) and Zen 4 (2022) has. */
static inline bool cpu_has_avx512(void)
{
    return cpu_has_avx2() && __builtin_cpu_supports("avx512f") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512cd");
}

#endif
#endif
