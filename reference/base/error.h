/* The one error object of the project: what went wrong, in one line that names the place and the
 * remedy. Library code fills it and returns -1; it prints nothing and never exits. */
#ifndef REFERENCE_BASE_ERROR_H
#define REFERENCE_BASE_ERROR_H

#include <stdbool.h>

#define MUST_CHECK __attribute__((warn_unused_result))

struct error {
    char text[512]; /* empty: no error; the last byte, behind the text, is error.c's */
};

/* Records an error, printf style.
 *
 * err      may be NULL (nothing is recorded); the first error wins, later ones are dropped
 * returns  always -1, so that `return error_set(err, ...)` reads well */
int error_set(struct error *err, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The same for a mistake in what the caller asked for: a file that is absent, a name that nobody
 * has. A program ends with another exit code then. */
int error_set_request(struct error *err, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
bool error_is_request(const struct error *err);

/* Analyzers take one file at a time and do not see that these always return -1: they would follow
 * ways on which nothing failed after all. `make lint` defines ANALYZER for gcc's. */
#if defined __clang_analyzer__ || defined ANALYZER
static inline int error_is_set(int always)
{
    (void)always;
    return -1;
}
#define error_set(...) error_is_set(error_set(__VA_ARGS__))
#define error_set_request(...) error_is_set(error_set_request(__VA_ARGS__))
#endif

#endif
