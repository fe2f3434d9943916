/* The journal of a bench run: what each finished block measured, one JSON object a line, so that a
 * run that was stopped, even with kill -9, goes on where it was.
 *
 * The first line says what was measured and where (the fingerprint: program and machine); results
 * of another program or machine are never mixed with these. */
#ifndef BENCH_COMPARE_JOURNAL_H
#define BENCH_COMPARE_JOURNAL_H

#include "reference/base/error.h"

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

struct journal {
    FILE *file;
    json_t *entries; /* array of all lines but the first */
    bool is_resumed; /* there were lines of this fingerprint */
    bool was_other;  /* there were lines of another one, now in journal.jsonl.old */
};

/* Opens DIR/journal.jsonl, or makes it. A last line that was cut is dropped. The caller owns it
 * (journal_close). Returns 0, or -1 and *err. */
int journal_open(struct journal *journal, const char *folder, const char *fingerprint,
                 struct error *err) MUST_CHECK;

/* Adds an entry, which the journal then owns, and writes its line at once. Returns 0, or -1. */
int journal_add(struct journal *journal, json_t *entry, struct error *err) MUST_CHECK;

/* The entry of that job and block, or NULL. */
const json_t *journal_find(const struct journal *journal, const char *job, int block);

void journal_close(struct journal *journal);

#endif
