/* The policy on source text as it was handed in: directives that the preprocessor obeys and of which
 * its output tells nothing.
 *
 * Refused: line markers made by hand (`# 1 "/usr/include/stdio.h" 1 3`), which would make what
 * follows look like a system header to the compiler and to policy.h alike, as the preprocessor's
 * own do; #ident and #sccs, whose text gcc hands to the assembler.
 *
 * Comments are known for what they are only when the text is read as gcc reads it. Where that may
 * differ (raw strings, `<` and a comment in the name of a header), the text is refused. */
#ifndef GRADERS_ENGINE_BUILD_DIRECTIVES_H
#define GRADERS_ENGINE_BUILD_DIRECTIVES_H

#include "graders/engine/base/refusal.h"

/* Judges one file, of which the name is shown.
 *
 * text, bytes  any bytes
 * refusal      filled when refused; the sentence begins with "file:line: ". Causes: forbidden-line,
 *              forbidden-directive, forbidden-include, raw-string
 * returns      the line, 0 when not refused. Cost: one pass. */
int directives_check(const char *name, const char *text, size_t bytes, struct refusal *refusal);

#endif
