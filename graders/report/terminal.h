/* Results on a terminal of 80 columns. All text of others is cleaned (clean.h): nothing in it can
 * move the cursor, change colours or reorder what stands around it. */
#ifndef GRADERS_REPORT_TERMINAL_H
#define GRADERS_REPORT_TERMINAL_H

#include "reference/base/phrase.h"

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

struct terminal_style {
    bool colour; /* escape sequences for colour may be written */
    enum language language;
};

/* One result, for `meshgrade check`. Where something is wrong the first three lines say what, where
 * and how to see it again; then come the points by class and check, then the other rejected cases.
 *
 * result  follows graders/report/README.md (not checked again here; missing keys show as nothing)
 */
void terminal_print_result(FILE *to, const json_t *result, const struct terminal_style *style);

/* The table of marks of a class: students by exercises, and totals.
 *
 * results  an array of results in any order */
void terminal_print_marks(FILE *to, const json_t *results, const struct terminal_style *style);

#endif
