/* The policy on source text: what a submission may not say to the compiler. Looks at preprocessed
 * text, where macros can hide nothing.
 *
 * Refused:
 *   - inline assembly, at file scope, in functions, and as register or symbol names
 *   - attributes that are not on the list of harmless ones, in either syntax (constructor, naked,
 * ifunc, section, alias, no_sanitize, optimize, target, copy ...)
 *   - pragmas that are not on the list of harmless ones (GCC optimize, target, redefine_extname ...)
 *   - any other line that begins with # but the preprocessor's markers; #line with another name;
 * markers made by hand are found in the source itself (directives.h)
 *   - #include by absolute or parent paths, also where <> leads out of the folders that the compiler
 * itself searches
 *   - raw strings, which are not C and would be read differently here and by the compiler
 * Intrinsics (__builtin_ia32_..., <immintrin.h>) are allowed.
 *
 * System headers contain assembly and target pragmas themselves. Line markers tell where, but can
 * be forged, so they hide nothing dangerous: in what claims to be a system header only what the
 * real ones contain is let through (names given to declarations, target options, the few
 * instructions of the intrinsics' headers). Measured: all headers of C17, POSIX threads and x86
 * intrinsics pass. */
#ifndef GRADERS_ENGINE_BUILD_POLICY_H
#define GRADERS_ENGINE_BUILD_POLICY_H

#include "graders/engine/base/refusal.h"

struct policy {
    struct refusal refusal;  /* the sentence begins with "file:line: " */
    char file[REFUSAL_NAME]; /* as it stands in the line markers; untrusted text */
    int line;
};

/* Judges one preprocessed file.
 *
 * text, bytes    output of gcc -E (with line markers, without -C), best the very text that is then
 *                compiled (gcc -fpreprocessed), else made with the same flags; may be anything
 * public_folder  folder of the public header as given to gcc's -I, when it is absolute; else NULL
 * policy         zeroed and filled
 * Cost: one pass. Causes: inline-assembly, forbidden-attribute, forbidden-pragma, forbidden-line,
 * forbidden-directive, forbidden-include, raw-string. */
void policy_check(const char *text, size_t bytes, const char *public_folder, struct policy *policy);

#endif
