/* The rows of bench.json (README.md here): what the blocks of a journal say, summed up. */
#ifndef BENCH_COMPARE_ROWS_H
#define BENCH_COMPARE_ROWS_H

#include "bench/compare/journal.h"
#include "bench/compare/plan.h"
#include "bench/measure/bandwidth.h"

#include <jansson.h>

/* All rows of the plan for which something was measured; the caller owns the array. NULL: out of
 * memory. Times are interval_of over blocks, ratios of times in the same block. */
json_t *rows_of(const struct plan *plan, const struct journal *journal,
                const struct copy_bandwidth *copy, int copy_count);

/* {"samples": ..., "dropped": ..., "noisy_rows": ...} of these rows; the caller owns it. */
json_t *rows_noise(const json_t *rows);

#endif
