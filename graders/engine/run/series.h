/* A series: many calls of one program in one session, the input rewritten before each.
 *
 * Used where a fresh process for every call would cost too much (valgrind, sanitizers), or where
 * calls must follow each other in one process (paired timing). */
#ifndef GRADERS_ENGINE_RUN_SERIES_H
#define GRADERS_ENGINE_RUN_SERIES_H

#include "graders/engine/run/attempt.h"
#include "graders/engine/run/dumps.h"

enum series_tool {
    SERIES_PLAIN,        /* natively, in a run box */
    SERIES_CALLGRIND,    /* counted: a dump a call, and one at the program's end */
    SERIES_INSTRUCTIONS, /* the same without cache misses: half the time */
    SERIES_SANITIZER,    /* the program with ASan and UBSan; no allocation is counted */
    SERIES_MEMCHECK      /* the dynamic program under memcheck; no allocation is counted */
};

/* Exit code of a program in which a sanitizer or memcheck found an error. */
enum { SERIES_FOUND = 86 };

/* The runner's function that calls the submission's, the one that callgrind dumps before, and what
 * a dump says that was made by it or by the end of the program. */
#define SERIES_CALLER "run_call"
#define SERIES_PREPARER "run_prepare" /* and the one that prepares for that */
#define SERIES_DUMPER "counted_call_ends"
#define SERIES_DUMPED_CALL "--dump-before=" SERIES_DUMPER
#define SERIES_DUMPED_END "Program termination"

/* Where work is counted: libc chooses its functions for strings and its mathematics by the processor,
 * and must choose the same everywhere. Without all that a processor may have beyond x86-64-v2, and
 * without libc's preferences among what is left. tests/unit/test_pinned.c looks at what it chose. */
#define SERIES_PINNED_FUNCTIONS                                                                    \
    ("GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX,-AVX2,-AVX512F,-AVX512VL,-FMA,-FMA4,-SSSE3,-ERMS,"      \
     "-FSRM,-AVX_Fast_Unaligned_Load,-Fast_Unaligned_Load,-Fast_Unaligned_Copy")

/* What to start. Zero it, then fill it. */
struct series_plan {
    const struct inputs *inputs;
    const struct build *build;
    enum series_tool tool;
    size_t input_bytes, answer_bytes; /* capacities: the largest of all calls, or more where
                                         session.input_page is used */
    int call_count;                   /* SERIES_CALLGRIND, SERIES_INSTRUCTIONS: at most */
    uint32_t mode;                    /* further runner_mode flags */
    int cpu;                          /* pin to it, -1: not */
};

struct series {
    struct region input;
    struct session session;
    struct dumps dumps;    /* what callgrind dumped */
    char folder[PATH_MAX]; /* /work of the box; empty for SERIES_PLAIN */
    enum call_end end;     /* of the last call */
    bool started;
};

/* The series that is not started: series_release leaves it alone. */
struct series series_none(void);

/* Starts the program. Returns 0, or -1 and *err: a fault. series_release must follow in any case.
 */
int series_start(struct series *series, const struct series_plan *plan,
                 struct error *err) MUST_CHECK;

/* Calls once on `input`; claims go to attempt->claims. After anything but CALL_ANSWERED the series
 * must be ended. */
enum call_end series_call(struct series *series, const struct input *input,
                          int64_t failing_allocation, const struct call_limits *limits,
                          struct attempt *attempt);

/* Ends the program. When the last call did not come back, `attempt` gets verdict and texts for it;
 * its output and outcome are filled in any case. Returns 0, or -1 and *err: a fault. */
int series_end(struct series *series, struct attempt *attempt, struct error *err) MUST_CHECK;

/* Why a tool may know nothing of its program: valgrind reads symbols from the file by its name, and
 * where a box has no private root, that name must lead through folders which the box's user may
 * pass. Returns 0, or -1 and *err with the remedy: a fault. */
int series_check_way(const struct series *series, struct error *err) MUST_CHECK;

void series_release(struct series *series);

#endif
