/* What of ours can be measured, as workers (worker.h):
 *
 *     representation/NAME     one of representation_table, with its operations
 *     paper/NAME              one of paper_structures, with the paper's operations
 *     kernels/VARIANT         all kernels in that variant; "fastest": the best on one thread
 *     reader/meshgrade        our readers of mesh files
 */
#ifndef BENCH_COMPARE_SUBJECTS_H
#define BENCH_COMPARE_SUBJECTS_H

#include "reference/base/error.h"

#include <stdio.h>

/* Serves as the worker of that name on a mesh snapshot until the end of `in`; says `refused` on
 * `out` when the subject cannot hold the mesh. Returns 0, or -1 and *err: no such subject, no such
 * file, a line that is not understood. */
int subject_serve(const char *name, const char *snapshot_path, FILE *in, FILE *out,
                  struct error *err) MUST_CHECK;

#endif
