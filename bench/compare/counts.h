/* Instructions, simulated cache misses and allocations of single calls: what repeats exactly. */
#ifndef BENCH_COMPARE_COUNTS_H
#define BENCH_COMPARE_COUNTS_H

#include "bench/compare/run.h"

enum { COUNTED_TRIANGLES_MAX = 110000 }; /* valgrind is some 50 times slower: small meshes only */

/* Counts every operation of every contender on the plan's small meshes, once: allocations with
 * build/bench-allocations.so preloaded (which stands beside the program), the rest under callgrind.
 * Adds entries {"job", "block": -1, "contender", "counts": {OPERATION: {...}}} to the journal.
 * Where valgrind or the library is missing those numbers are left out. Returns 0, or -1 and *err.
 */
int count_plan(const struct run_wish *wish, struct journal *journal, struct error *err) MUST_CHECK;

/* The counts of that operation, an object, or NULL. */
const json_t *counts_find(const struct journal *journal, const char *job, const char *contender,
                          const char *operation);

/* argv of a contender on a mesh: `argv` has room for 6. Returns argv. */
const char *const *contender_command(const struct contender *contender, const char *mesh_path,
                                     const char **argv);

#endif
