/* bench.json and what is made of it: README.md here is their description. */
#ifndef BENCH_COMPARE_DOCUMENT_H
#define BENCH_COMPARE_DOCUMENT_H

#include "bench/compare/journal.h"
#include "bench/compare/plan.h"
#include "bench/measure/bandwidth.h"
#include "bench/measure/machine.h"

#include <jansson.h>
#include <stdio.h>

struct document_facts {
    const char *version; /* "meshgrade 0.3" */
    const char *mode;    /* "quick", "full" */
    const struct machine *machine;
    const struct copy_bandwidth *copy;
    int copy_count;
    json_t *claims;   /* array, taken over; NULL: none */
    json_t *accesses; /* the same (accesses.h) */
};

/* The whole document; the caller owns it. NULL and *err: out of memory. */
json_t *bench_document_make(const struct plan *plan, const struct journal *journal,
                            const struct document_facts *facts, struct error *err) MUST_CHECK;

/* Writes bench.json, bench.csv, google.json and, where accesses were counted, accesses.csv into the
 * folder. Returns 0, or -1 and *err. */
int bench_document_write(const json_t *document, const char *folder, struct error *err) MUST_CHECK;

/* The rows as CSV (RFC 4180, a header line first), and the times in google/benchmark's JSON schema
 * 1 (time unit ns, of one call). What failed is not among the latter. The caller owns the object.
 */
void bench_document_csv(const json_t *document, FILE *to);
void bench_accesses_csv(const json_t *document, FILE *to); /* the accesses alone */
json_t *bench_document_google(const json_t *document);

#endif
