/* What the format writers share: numbers in the C locale, and whether everything was written. */
#ifndef REFERENCE_FORMATS_TEXT_OUT_H
#define REFERENCE_FORMATS_TEXT_OUT_H

#include "reference/mesh/mesh.h"

#include <locale.h>
#include <stdio.h>

struct text_out {
    FILE *out;
    locale_t c_locale, previous;
};

/* Between begin and end, this thread prints numbers as the C locale does. Both return 0, or -1 and
 * *err; end flushes and reports whether `out` took everything. */
int text_out_begin(struct text_out *text, FILE *out, struct error *err) MUST_CHECK;
int text_out_end(struct text_out *text, struct error *err) MUST_CHECK;

/* A line of three coordinates a vertex, with as many digits as a float needs to come back exactly.
 */
void text_out_positions(FILE *out, const char *line_start, const struct mesh *mesh);

#endif
