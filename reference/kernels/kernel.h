/* The reference kernels: the operations on an indexed mesh that the project times against other
 * libraries and against the machine's limit. Each is one function, kept in several variants:
 *
 *   plain     portable C, always there; the measure of what is right
 *   avx2      x86-64 vectors of 256 bits    } only where the processor has them and the environment
 *   avx512    x86-64 vectors of 512 bits    } does not take them away, asked at run time (cpu.h)
 *   threads   the best of these on every CPU that the process may use
 *
 * They are for benchmarks. The reference solutions that the grader compiles and holds students
 * against stand in reference/GROUP/NAME.c and are written for readers;
 * tests/unit/test_kernels_yardstick.c proves that both give equal answers.
 *
 * All variants of a kernel give the same output bit for bit, except the area (area.h states the
 * bound). To run the plain one on any machine, name it: kernel_find("twins", "plain").
 *
 * Contract of every kernel:
 *   mesh      valid (mesh_check): the kernels look at no index twice
 *   scratch   scratch_bytes(...) bytes, 64-byte aligned, of any content; may be NULL where that
 *             is 0. Nothing in it needs keeping between calls.
 *   output    output_bytes(...) bytes, 64-byte aligned, overlapping neither mesh nor scratch. The
 *             records come first; up to a vector after them may be overwritten with anything.
 *   returns   how many records stand in output (edges, sides, normals, areas)
 * Kernels allocate nothing, keep no state and cannot fail: a thread that cannot be started has its
 * work done by the caller. */
#ifndef REFERENCE_KERNELS_KERNEL_H
#define REFERENCE_KERNELS_KERNEL_H

#include "reference/mesh/mesh.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct kernel {
    const char *name;        /* edges-closed, edges-any, twins, area, ... */
    const char *variant;     /* plain, avx2, avx512, threads */
    const char *record;      /* what one record of the output is: "edge", "side", ... */
    bool needs_closed_mesh;  /* asks for a closed, coherently oriented mesh without degenerate
                                triangles; the output for others is safe but means nothing */
    bool (*available)(void); /* whether it can run here (cpu.h) */

    size_t (*scratch_bytes)(int64_t vertex_count, int64_t triangle_count);
    size_t (*output_bytes)(int64_t vertex_count, int64_t triangle_count); /* capacity to give */

    /* Bytes that any implementation must move: the input read once, the output of record_count
     * records written once. Divided by the copy bandwidth this is the least time. */
    int64_t (*moved_bytes)(int64_t vertex_count, int64_t triangle_count, int64_t record_count);

    int64_t (*run)(const struct mesh *mesh, void *scratch, void *output);

    /* Of threads variants only, else NULL: the same on 1 ... KERNEL_MOST_THREADS threads. run takes
     * as many of kernel_thread_count() as the size of the mesh is worth. */
    int64_t (*run_on_threads)(const struct mesh *mesh, void *scratch, void *output,
                              int thread_count);
};

/* All kernels, the variants of one kernel together and plain first; ends with a NULL name. */
extern const struct kernel kernel_table[];

/* The variant of a kernel, or NULL when there is no such or it cannot run here. variant
 * NULL asks for the fastest that runs on one thread here. */
const struct kernel *kernel_find(const char *name, const char *variant);

/* How many threads the threads variants use: the CPUs that this process may run on, at most
 * KERNEL_MOST_THREADS. */
enum { KERNEL_MOST_THREADS = 64 };
int kernel_thread_count(void);

#endif
