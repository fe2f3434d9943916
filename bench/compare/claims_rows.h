/* Adding a row to the claims; for the claims*.c files. */
#ifndef BENCH_COMPARE_CLAIMS_ROWS_H
#define BENCH_COMPARE_CLAIMS_ROWS_H

#include "bench/compare/claims.h"

/* Adds a copy of the row with the name of the mesh. Returns 0, or -1 and *err (out of memory). */
int claims_add(struct claims *claims, const struct claim *row, const char *mesh,
               struct error *err) MUST_CHECK;

#endif
