/* One attempt: a program is called in a fresh box on one input, and what came of it is judged. */
#ifndef GRADERS_ENGINE_RUN_ATTEMPT_H
#define GRADERS_ENGINE_RUN_ATTEMPT_H

#include "graders/engine/base/verdict.h"
#include "graders/engine/build/build.h"
#include "graders/engine/run/examine.h"
#include "graders/engine/run/inputs.h"
#include "graders/engine/run/session.h"
#include "reference/base/phrase.h"

enum { ATTEMPT_OUTPUT = 4096 };

struct attempt {
    enum verdict verdict;      /* PASSED: the answer was accepted */
    char cause[CAUSE_SLUG];    /* empty when it passed */
    struct message cause_name; /* for people */
    struct message element;    /* the first and smallest at fault; may be empty */
    struct message message;    /* what is wrong, where, what is right */
    json_t *scene;             /* may be NULL; owned */
    double quality;            /* of a right answer, when has_quality */
    bool has_quality;
    struct control claims; /* of the call; all zero when it never came back */
    bool uncounted;        /* the program has no allocation shim: the judge hears of no usage */
    int64_t cpu_ns;        /* charged to the call */
    struct box_outcome outcome;
    char output[ATTEMPT_OUTPUT]; /* what it printed, untrusted */
};

/* Runs the plain program of `build` on case `index`, whose input is made, and judges the answer: is
 * it right, and good enough for the case's class?
 *
 * limits   of CPU and idle time
 * returns  0, or -1 and *err: a fault. attempt_release must follow. */
int attempt_run(const struct inputs *inputs, const struct build *build, size_t index,
                const struct call_limits *limits, struct attempt *attempt,
                struct error *err) MUST_CHECK;

/* Judges whether the answer of a call that came back is right: copies it, checks the claims, asks
 * the judge.
 *
 * attempt->claims must be filled; verdict, texts and scene are set */
int attempt_judge(const struct inputs *inputs, const struct input *input,
                  const struct session *session, struct attempt *attempt,
                  struct error *err) MUST_CHECK;

/* Takes over what a judge said: verdict, texts, quality and scene. */
void attempt_take(struct attempt *attempt, struct examination *examination);

/* Sets verdict and texts for a program that did not come back. Returns 0, or -1 and *err for a
 * fault: it was killed by a signal that it cannot send itself and that no limit of ours sends, or
 * the runner could not get ready (CALL_NOT_READY; exit codes mean something only then). */
int attempt_explain_death(enum call_end end, const struct control *claims,
                          const struct box_outcome *outcome, struct attempt *attempt,
                          struct error *err) MUST_CHECK;

/* Sets verdict, cause and both sentences (same arguments for both). */
void attempt_say(struct attempt *attempt, enum verdict verdict, const struct cause *cause,
                 const char *en, const char *es, ...)
    __attribute__((format(printf, 4, 6), format(printf, 5, 6)));

/* Whether the answer was right, be it too poor for its class. */
static inline bool attempt_is_right(const struct attempt *attempt)
{
    return attempt->verdict == VERDICT_PASSED || attempt->verdict == VERDICT_POOR_QUALITY;
}

/* The cause of an attempt, borrowed from it. */
struct cause attempt_cause(const struct attempt *attempt);

/* The limit of CPU time was reached; or that of all runs of the submission together, with the
 * sentences for it, which tell BUDGET_SECONDS. */
extern const struct cause attempt_cpu_limit, attempt_budget_spent;
#define ATTEMPT_SPENT_EN                                                                           \
    "All runs of your program together took more than %d s of work and waiting: it works, or "     \
    "waits, far too much, and nothing further was looked at."
#define ATTEMPT_SPENT_ES                                                                           \
    "Todas las ejecuciones de tu programa juntas tardaron más de %d s entre trabajo y espera: "   \
    "trabaja, o espera, demasiado, y no se examinó nada más."

void attempt_release(struct attempt *attempt);

#endif
