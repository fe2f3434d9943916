/* The build: from a submission's C files to programs that a box can run.
 *
 * Compiling is hostile input too: the compiler runs in a build box that holds the submission's
 * files, the exercise's public header and the runner's objects, nothing else. The same flags serve
 * students and references.
 *
 *   *.c --gcc -E--> text --policy--> gcc -c --> object --screen--> ld -r, objcopy --> static
 * program
 *
 * Every symbol of the submission but the exercise's functions is made local before it meets the
 * runner. Three programs come out: plain (static, counted allocations), sanitized (ASan and UBSan),
 * checked (dynamic, for valgrind's memcheck). */
#ifndef GRADERS_ENGINE_BUILD_BUILD_H
#define GRADERS_ENGINE_BUILD_BUILD_H

#include "graders/box/box.h"
#include "graders/engine/base/budget.h"
#include "graders/engine/base/exercise.h"
#include "graders/engine/base/refusal.h"

#include <limits.h>
#include <stdbool.h>
#include <stddef.h>

struct source {
    const char *name;  /* [A-Za-z0-9._-]+, ends in .c or .h */
    const char *bytes; /* borrowed */
    size_t count;
};

enum program_kind { PROGRAM_PLAIN, PROGRAM_SANITIZED, PROGRAM_CHECKED, PROGRAM_COUNT };

/* Which programs are wanted: the plain one costs a third of all three. */
enum build_extent { BUILD_PLAIN, BUILD_ALL };

enum { BUILD_DIAGNOSTICS = 16384 };

struct build {
    struct refusal refusal; /* why it cannot be run; causes: syntax, link, compiler-time,
                               compiler-memory, compiler-output, and those of policy.h, screen.h */
    char diagnostics[BUILD_DIAGNOSTICS]; /* of the compiler, as it came: untrusted, may be cut */
    char folder[PATH_MAX];               /* work folder of this build; holds the programs */
    int program_fd[PROGRAM_COUNT];       /* open for reading; -1 when refused or not wanted */
    int64_t static_bytes;                /* .data and .bss of the submission */
    char chance[24];        /* a function it calls whose answer differs from run to run:
                               the time, random bytes; empty: none is known */
    uint32_t active_layers; /* of the build box */
    struct budget *budget;  /* what all runs of its programs may take together, set and owned by who
                               runs them; NULL: no bound */
};

/* Nothing built: what build_release may be given before anything was. All zero is something else:
 * it would own descriptor 0. */
void build_clear(struct build *build);

/* Builds. Returns 0 (look at build->refusal: a submission that does not compile is no error of
 * ours), or -1 and *err: a fault. build_release must follow in both cases. */
int build_submission(const struct exercise *exercise, const struct source *sources,
                     int source_count, enum build_extent extent, struct build *build,
                     struct error *err) MUST_CHECK;

/* Copies a program into `folder` under its kind's name ("plain", "sanitized", "checked"), so that
 * it can be run as /work/<name> in a tools box. */
int build_copy_program(const struct build *build, enum program_kind kind, const char *folder,
                       struct error *err) MUST_CHECK;

/* Closes the programs and removes the scratch folder. */
void build_release(struct build *build);

#endif
