/* The one error object of the project: what went wrong, in one line that names the place and the
 * remedy. Library code fills it and returns -1; it prints nothing and never exits. */
#ifndef REFERENCE_BASE_ERROR_H
#define REFERENCE_BASE_ERROR_H

#define MUST_CHECK __attribute__((warn_unused_result))

struct error {
    char text[512]; /* empty: no error */
};

/* Records an error, printf style.
 *
 * err      may be NULL (nothing is recorded); the first error wins, later ones are dropped
 * returns  always -1, so that `return error_set(err, ...)` reads well */
int error_set(struct error *err, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
