/* What a journal's blocks were measured with: blocks of other programs or machines are never mixed
 * with these. */
#ifndef BENCH_COMPARE_FINGERPRINT_H
#define BENCH_COMPARE_FINGERPRINT_H

#include "bench/compare/plan.h"
#include "bench/measure/machine.h"

enum { FINGERPRINT_BYTES = 256 };

/* Writes a line that changes with the contents of any program that the plan starts, our own and
 * each peer once, with the machine, and with the vectors that kernels may use (cpu.h). A program
 * that cannot be read counts as an empty one.
 *
 * program  ours
 * Cost     reading the programs */
void fingerprint_write(const struct plan *plan, const char *program, const struct machine *machine,
                       char text[FINGERPRINT_BYTES]);

#endif
