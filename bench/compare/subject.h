/* What the kinds of subjects share: an open snapshot, memory for output, and the worker that serves
 * it. For subjects.c and the subject_*.c files. */
#ifndef BENCH_COMPARE_SUBJECT_H
#define BENCH_COMPARE_SUBJECT_H

#include "bench/compare/snapshot.h"
#include "bench/measure/worker.h"

/* Each opens a subject on a snapshot and serves; `name` is what stands behind the slash. */
int subject_serve_representation(const char *name, const struct snapshot *snapshot, FILE *in,
                                 FILE *out, struct error *err) MUST_CHECK;
int subject_serve_kernels(const char *variant, const struct snapshot *snapshot, FILE *in, FILE *out,
                          struct error *err) MUST_CHECK;
int subject_serve_paper(const char *name, const struct snapshot *snapshot, FILE *in, FILE *out,
                        struct error *err) MUST_CHECK;
int subject_serve_reader(const char *snapshot_path, FILE *in, FILE *out,
                         struct error *err) MUST_CHECK;

#endif
