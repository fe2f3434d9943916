/* Which line of a compiler's and linker's talk says what is wrong. */
#ifndef GRADERS_REPORT_DIAGNOSTICS_H
#define GRADERS_REPORT_DIAGNOSTICS_H

#include <stddef.h>

/* Writes the line that tells, without its newline, cut to `capacity` bytes: the first error of the
 * compiler or assembler at its place ("name.c:3:5: error: ..."), else what the linker misses or has
 * twice, else the first line that has no more to say than that. The words of the source, file names
 * among them, are not taken for any of these. Empty when there is no line. */
void diagnostics_telling_line(const char *diagnostics, char *line, size_t capacity);

#endif
