/* Which vector instructions the kernels use: those that this processor has, unless the environment
 * takes some of them away. This is the one place that asks.
 *
 *     MESHGRADE_CPU=plain     portable C only, as on a machine without AVX2
 *     MESHGRADE_CPU=avx2      at most vectors of 256 bits
 *     MESHGRADE_CPU=avx512    all that the processor has, as when it is not set or empty
 *
 * The variable can only take away: what the processor lacks stays unused whatever it says. The
 * command line refuses any other value (cpu_check_limit); within the library, which cannot fail
 * there, another value counts as plain. */
#ifndef REFERENCE_KERNELS_CPU_H
#define REFERENCE_KERNELS_CPU_H

#include "reference/base/error.h"

#include <stdbool.h>

enum cpu_vectors { CPU_PLAIN, CPU_AVX2, CPU_AVX512, CPU_VECTORS_COUNT };

/* The widest that this processor has; of AVX-512 the parts that every processor since Skylake-X
 * (2017) and Zen 4 (2022) has. CPU_PLAIN on processors that are not x86-64. */
enum cpu_vectors cpu_processor_vectors(void);

/* The widest that kernels may use. Reads the environment each time. */
enum cpu_vectors cpu_vectors(void);

/* "plain", "avx2", "avx512": static. */
const char *cpu_vectors_name(enum cpu_vectors vectors);

/* Whether MESHGRADE_CPU has one of its values. Returns 0, or -1 and *err, which names them. */
int cpu_check_limit(struct error *err) MUST_CHECK;

static inline bool cpu_has_avx2(void)
{
    return cpu_vectors() >= CPU_AVX2;
}

static inline bool cpu_has_avx512(void)
{
    return cpu_vectors() >= CPU_AVX512;
}

#endif
