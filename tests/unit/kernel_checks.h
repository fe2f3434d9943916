/* What the tests of the kernels share: many meshes, and runs between guard bytes. */
#ifndef TESTS_UNIT_KERNEL_CHECKS_H
#define TESTS_UNIT_KERNEL_CHECKS_H

#include "reference/kernels/kernel.h"

/* Calls check with every mesh that kernels are tested on: all generators, as they come, scrambled,
 * adversarially numbered, flipped; sizes around every vector width; boundaries, isolated vertices,
 * repeated and degenerate triangles, non-manifold edges, valences up to 10^5, scattered tables. */
void with_every_mesh(void (*check)(const struct mesh *mesh));

/* Runs a kernel on scratch and output of exactly the promised sizes, full of rubbish, and fails the
 * test when a byte before or after them changed. The caller frees the output (free_guarded). */
void *run_guarded(const struct kernel *kernel, const struct mesh *mesh, int64_t *record_count);

/* The same on a number of threads; for a kernel that has run_on_threads. */
void *run_guarded_on_threads(const struct kernel *kernel, const struct mesh *mesh, int thread_count,
                             int64_t *record_count);
void free_guarded(void *output);

/* Runs all variants of a kernel that this processor has, those on threads with 1, 2, 3 and 7 of
 * them, and fails unless each gives the same records, of record_bytes each, as the plain one. */
void check_variants_equal(const char *name, const struct mesh *mesh, size_t record_bytes);

#endif
