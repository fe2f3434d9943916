/* From stored results to what people read: pictures, pages, gradebook, the table of marks. */
#ifndef GRADERS_COMMANDS_PUBLISH_H
#define GRADERS_COMMANDS_PUBLISH_H

#include "reference/base/error.h"

#include <stdbool.h>

/* Draws pictures, writes pages and grades.csv, prints the table of marks (or the results as JSON)
 * and where the class page is.
 *
 * returns  the program's exit code: 0 all passed, 1 something did not, 2 a fault (of a submission's
 *          grading, or *err) */
int publish(const char *out, bool pictures, bool json, struct error *err);

#endif
