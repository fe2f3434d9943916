/* Verdicts: the one word for how a submission ended, in a fixed order of precedence. */
#ifndef GRADERS_ENGINE_BASE_VERDICT_H
#define GRADERS_ENGINE_BASE_VERDICT_H

#include "reference/base/phrase.h"

/* In order of precedence: of several that hold, the first one is the verdict. */
enum verdict {
    VERDICT_FAULT,   /* the harness failed; never scored */
    VERDICT_FLAGGED, /* withheld for a person; never scored */
    VERDICT_COMPILE_ERROR,
    VERDICT_FORBIDDEN_OPERATION,
    VERDICT_OUT_OF_MEMORY,
    VERDICT_TOO_MANY_PROCESSES,
    VERDICT_TOO_MUCH_OUTPUT,
    VERDICT_TOO_MUCH_DISK,
    VERDICT_CPU_TIME,
    VERDICT_IDLE_TIME,
    VERDICT_CRASH,
    VERDICT_UNDEFINED_BEHAVIOUR,
    VERDICT_WRONG_ANSWER,
    VERDICT_LEAK,
    VERDICT_GROWS_TOO_FAST,
    VERDICT_TOO_MUCH_WORK,
    VERDICT_TOO_MUCH_MEMORY,
    VERDICT_POOR_QUALITY, /* a right answer beyond the band of its class */
    VERDICT_PASSED,
    VERDICT_NOT_MEASURED, /* of a check: the probe is missing on this machine */
    VERDICT_NOT_REACHED,  /* of a check or case: something earlier failed */
    VERDICT_COUNT
};

/* "wrong-answer", ... as in results. */
const char *verdict_name(enum verdict verdict);

/* VERDICT_COUNT when there is no such name. */
enum verdict verdict_of_name(const char *name);

/* The verdict in a few words, for headings: "wrong answer", "respuesta incorrecta". */
struct phrase verdict_words(enum verdict verdict);

/* What sort of verdict it is, for its colour and symbol. */
enum standing {
    STANDING_PASSED,
    STANDING_PARTIAL, /* never a verdict's: some points were given and some lost */
    STANDING_FAILED,
    STANDING_UNSCORED, /* fault or flagged: a person must look */
    STANDING_ABSENT    /* nothing submitted, not measured, not reached */
};
enum { STANDING_COUNT = STANDING_ABSENT + 1 };
enum standing verdict_standing(enum verdict verdict);

#endif
