/* The exporters, one file a format; report_export (report.h) chooses among them. */
#ifndef GRADERS_REPORT_EXPORT_H
#define GRADERS_REPORT_EXPORT_H

#include "graders/report/results.h"

#include <stdio.h>

/* What is exported: a gradebook, of the whole class or of the one student asked for. */
struct export_job {
    const struct gradebook *book;
    bool one_student; /* a student was asked for by name */
    enum language language;
    FILE *to;
};

/* Each writes all of it. 0, or -1 and *err; that the stream took everything is checked by the
 * caller. */
int export_csv(const struct export_job *job, struct error *err);
int export_gradescope(const struct export_job *job, struct error *err);
int export_junit(const struct export_job *job, struct error *err);
int export_vpl(const struct export_job *job, struct error *err);
int export_json(const struct export_job *job, struct error *err);

/* The cleaned text of a JSON string (clean.h), which the caller frees; NULL when out of memory. */
char *export_clean(const json_t *string, bool keep_lines);

#endif
