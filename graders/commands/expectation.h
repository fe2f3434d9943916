/* What a known-verdict submission is expected to get, as its folder and first comment say
 * (CONTRIBUTING.md). */
#ifndef GRADERS_COMMANDS_EXPECTATION_H
#define GRADERS_COMMANDS_EXPECTATION_H

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

/* Reads <kind>/<file>.c. Returns 0, or -1 and *err: no such folder kind and no `expect:` line, an
 * unknown verdict. */
int expectation_read(const char *path, struct expectation *expectation,
                     struct error *err) MUST_CHECK;

/* Whether the classes and checks that failed in `result` are exactly the expected ones (or none are
 * named). When not, `why` says which differ. */
bool expectation_failures_match(const struct expectation *expectation, const json_t *result,
                                char *why, size_t capacity);

#endif
