/* The attributes that let one function use instructions which the rest of the program must not;
 * what this processor has is asked in cpu.h. */
#ifndef REFERENCE_KERNELS_X86_H
#define REFERENCE_KERNELS_X86_H

#if defined(__x86_64__)

/* No fma here: a product and a sum rounded once would not equal the plain variants. */
#define TARGET_AVX2 __attribute__((target("avx2,bmi,bmi2,popcnt,prfchw")))
#define TARGET_AVX512                                                                              \
    __attribute__((target("avx512f,avx512vl,avx512bw,avx512dq,avx512cd,bmi,bmi2,popcnt,prfchw")))

#endif
#endif
