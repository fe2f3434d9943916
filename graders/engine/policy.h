/* The policy on source text: what a submission may not say to the compiler. Looks at preprocessed
 * text, where macros can hide nothing, and there at what stands in the student's own files.
 *
 * Refused:
 *   - inline assembly, at file scope, in functions, and as register or symbol names
 *   - attributes constructor, destructor, naked, ifunc, target_clones, section, symver, alias,
 *     weakref, no_sanitize and its kin, optimize, target
 *   - pragmas GCC optimize, target, dependency, pch_preprocess, redefine_extname, weak
 *   - #line and hand-made line markers; #include by absolute or parent paths
 * Intrinsics (__builtin_ia32_...) are allowed, and so are <immintrin.h> and the like.
 *
 * Line markers can be forged by the text, so they are never trusted to hide anything dangerous: in
 * what claims to be a system header only what the real ones contain is let through (symbol names
 * given to declarations, and target pragmas and attributes). */
#ifndef GRADERS_ENGINE_POLICY_H
#define GRADERS_ENGINE_POLICY_H

#include "graders/engine/refusal.h"

struct policy {
    struct refusal refusal; /* the sentence names file and line */
    char file[REFUSAL_NAME];
    int line;
};

/* Judges one preprocessed file.
 *
 * text, bytes    output of gcc -E (with line markers), made with the flags of the compilation, or
 *                best the very text that is then compiled; may be anything
 * public_folder  folder of the public header as given to gcc's -I, when it is absolute; else NULL
 * policy         zeroed and filled
 * Cost: one pass. Causes: inline-assembly, forbidden-attribute, forbidden-pragma, forbidden-line,
 * forbidden-include. */
void policy_check(const char *text, size_t bytes, const char *public_folder, struct policy *policy);

#endif
