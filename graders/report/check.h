/* The format of a result, `meshgrade-result-1` (graders/report/README.md), as a check. */
#ifndef GRADERS_REPORT_CHECK_H
#define GRADERS_REPORT_CHECK_H

#include "reference/base/error.h"

#include <jansson.h>

/* Whether a value is a result that follows the format to the letter: every key that must be there
 * is, no other is, each has its type and range, names that go into paths are safe, and the parts
 * agree (points, classes of cases, lengths of arrays).
 *
 * returns  0, or -1 and *err "cases[3].message.en: expected a string, got an integer" */
int result_check(const json_t *result, struct error *err) MUST_CHECK;

#endif
