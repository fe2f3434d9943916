/* What came of a check: something that is looked at beside the answers. */
#ifndef GRADERS_ENGINE_RUN_CHECK_H
#define GRADERS_ENGINE_RUN_CHECK_H

#include "graders/engine/base/verdict.h"
#include "reference/base/phrase.h"

struct check_result {
    enum verdict verdict;   /* PASSED, NOT_REACHED, NOT_MEASURED, or what it found */
    char cause[CAUSE_SLUG]; /* empty when it passed */
    struct message cause_name, message;
};

/* Sets a check's verdict and both sentences (same arguments for both). The cause is copied; NULL
 * when the check passed. */
void check_say(struct check_result *check, enum verdict verdict, const struct cause *cause,
               const char *en, const char *es, ...)
    __attribute__((format(printf, 4, 6), format(printf, 5, 6)));

/* Something before it failed: a check or case was not looked at. */
extern const struct cause check_not_reached;

/* Blocks are left that nobody can free; cases and sized inputs show it. */
extern const struct cause check_leaked_blocks;

#endif
