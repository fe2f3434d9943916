/* How the allocation shim (graders/runner/shim.h) comes between a program and libc: options of
 * objcopy for the submission's object, and of the link of the whole. */
#ifndef GRADERS_ENGINE_BUILD_WRAPPED_H
#define GRADERS_ENGINE_BUILD_WRAPPED_H

/* What the submission asks for itself. These are the shim's and nobody else's: by them it knows who
 * asks. A function of its own that is called so is renamed as well, and stays its own. */
#define WRAPPED_ONE(name) " --redefine-sym " #name "=student_" #name
#define WRAPPED_OBJECT                                                                             \
    WRAPPED_ONE(malloc)                                                                            \
    WRAPPED_ONE(calloc)                                                                            \
    WRAPPED_ONE(realloc)                                                                           \
    WRAPPED_ONE(reallocarray)                                                                      \
    WRAPPED_ONE(aligned_alloc)                                                                     \
    WRAPPED_ONE(posix_memalign)                                                                    \
    WRAPPED_ONE(memalign)                                                                          \
    WRAPPED_ONE(valloc)                                                                            \
    WRAPPED_ONE(malloc_usable_size)                                                                \
    WRAPPED_ONE(strdup)                                                                            \
    WRAPPED_ONE(__strdup)                                                                          \
    WRAPPED_ONE(strndup)                                                                           \
    WRAPPED_ONE(__strndup)                                                                         \
    WRAPPED_ONE(wcsdup)                                                                            \
    WRAPPED_ONE(getline)                                                                           \
    WRAPPED_ONE(getdelim)                                                                          \
    WRAPPED_ONE(__getdelim)                                                                        \
    WRAPPED_ONE(asprintf)                                                                          \
    WRAPPED_ONE(__asprintf)                                                                        \
    WRAPPED_ONE(__asprintf_chk)                                                                    \
    WRAPPED_ONE(vasprintf)                                                                         \
    WRAPPED_ONE(__vasprintf_chk)                                                                   \
    WRAPPED_ONE(open_memstream)                                                                    \
    WRAPPED_ONE(open_wmemstream)                                                                   \
    WRAPPED_ONE(fmemopen)                                                                          \
    WRAPPED_ONE(fclose)                                                                            \
    WRAPPED_ONE(tsearch)

/* What libc asks for, and all that is given back. */
#define WRAPPED_LINK                                                                               \
    "-Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=free,--wrap=aligned_alloc,"             \
    "--wrap=posix_memalign,--wrap=memalign,--wrap=valloc"

#endif
