/* Known submissions against a judge, without the engine: a submission is compiled, linked with the
 * exercise's real runner (build/runner/<group>/<name>.plain.o) and run on a case in a process of
 * its own. There is no box, so nothing hostile may be run with this. Tests run in the root of the
 * tree. */
#ifndef TESTS_UNIT_SUBMISSIONS_H
#define TESTS_UNIT_SUBMISSIONS_H

#include "graders/library/judge.h"

/* A compiled submission; lives until submission_release. */
struct submission {
    char program[64]; /* path of the executable */
};

enum submission_end {
    SUBMISSION_ANSWERED,
    SUBMISSION_OUT_OF_MEMORY, /* it said that memory ran out */
    SUBMISSION_DIED           /* by a signal or exit, or was stopped after 20 s */
};

struct submission_answer {
    enum submission_end end;
    unsigned char *bytes; /* the answer packet */
    size_t count;
    struct usage usage;
    int64_t left_bytes; /* still allocated after the runner freed what was returned: the leak */
    int64_t bad_free_count;
};

/* Compiles the C file `source` of exercise `group`/`name`. Fails the test when it does not compile.
 */
void submission_build(struct submission *submission, const char *group, const char *name,
                      const char *source);
void submission_release(struct submission *submission);

/* Runs one call. failing_allocation: the how-manieth allocation gets NULL, 0: none. Release the
 * answer with submission_answer_release. Fails the test when the run itself cannot be made. */
void submission_run(const struct submission *submission, struct span input, size_t answer_bound,
                    int64_t failing_allocation, struct submission_answer *answer);
void submission_answer_release(struct submission_answer *answer);

#endif
