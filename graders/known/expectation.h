/* What a known-verdict submission is expected to get, as its folder and first comment say
 * (CONTRIBUTING.md). */
#ifndef GRADERS_KNOWN_EXPECTATION_H
#define GRADERS_KNOWN_EXPECTATION_H

#include "graders/library/quality.h"
#include "reference/base/error.h"

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

enum { EXPECTED_FAILURES = 32 };

struct expectation {
    char verdict[48];
    bool names_failures; /* whether `fails:` stands there */
    char failures[EXPECTED_FAILURES][64];
    int failure_count;
};

/* Reads what the first comment of a submission's text says.
 *
 * kind     its folder: right, wrong, ...
 * name     of the file, for errors
 * returns  0, or -1 and *err: no `expect:` line where the kind does not say the verdict, an unknown
 *          verdict */
int expectation_read(const char *kind, const char *name, const char *text,
                     struct expectation *expectation, struct error *err) MUST_CHECK;

/* Whether a result is what was expected: the verdict, and when failures are named, exactly those
 * classes and checks failed. A right answer also keeps a margin to the bands of work and memory.
 * When not, `why` says what differs. */
bool expectation_is_met(const struct expectation *expected, const json_t *result, char *why,
                        size_t capacity);

/* The steps after the cases that do not decide it, bits of TRIAL_CHECKS (trial.h): a wrong answer that
 * fails no check is decided by its cases, a slow one by its counts, a right one by everything. */
unsigned expectation_left_out(const struct expectation *expected);

/* Whether of a list of failed classes ("open,closed") just this one failed, and bands of quality:
 * stricter ones when it is a band, any when it is a class of right answers. */
bool expectation_fails_just(const char *failed, const char *class_name,
                            const struct quality_rule *rule);

/* The classes that failed, "open,several-components"; empty when none did. */
void expectation_failed_classes(const json_t *result, char *names, size_t capacity);

#endif
