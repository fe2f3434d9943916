/* The runner's side of exercises that ask several functions (graders/library/questions.h).
 *
 *     static const struct asked asked[] = {ASKED_FORMULA_OF_TWO(strips_bytes),
 *                                          ASKED_NUMBER(strips_kilobytes),
 *                                          ASKED_END};
 *
 *     void run_call(struct reader *input, struct writer *answer)
 *     {
 *         const char *builder = ask(asked, input, answer);
 *         if (!builder)
 *             return;
 *         ... the case's four numbers are next in the packet: build, measure, write
 *     }
 *
 * Builders are called from run_call itself, because that is whose calls are counted. */
#ifndef GRADERS_RUNNER_QUESTIONS_H
#define GRADERS_RUNNER_QUESTIONS_H

#include "graders/runner/call.h"

struct asked {
    const char *function;
    int64_t (*formula_of_two)(int32_t a, int32_t b);
    int64_t (*formula_of_one)(int32_t a);
    double (*number)(void);
    int32_t (*count)(void); /* answered as a number, too */
};

#define ASKED_FORMULA_OF_TWO(name)                                                                 \
    {                                                                                              \
        .function = #name, .formula_of_two = (name)                                                \
    }
#define ASKED_FORMULA_OF_ONE(name)                                                                 \
    {                                                                                              \
        .function = #name, .formula_of_one = (name)                                                \
    }
#define ASKED_NUMBER(name)                                                                         \
    {                                                                                              \
        .function = #name, .number = (name)                                                        \
    }
#define ASKED_COUNT(name)                                                                          \
    {                                                                                              \
        .function = #name, .count = (name)                                                         \
    }
#define ASKED_END                                                                                  \
    {                                                                                              \
        .function = 0                                                                              \
    }

/* Reads which function is asked, and asks it when it is in the table.
 *
 * returns  NULL when the answer is written; otherwise the name, which is not in the table: a
 * builder's. It ends in a zero byte, and the reader stands behind it. */
const char *ask(const struct asked *table, struct reader *input, struct writer *answer);

#endif
