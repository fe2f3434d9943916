/* Exercises that ask several small functions: a formula at many parameters, a number, a structure
 * that is built. A case names a question; runner and judge find its function by name.
 *
 *     static const struct formula bytes = {...};
 *     static const struct question ask_bytes = {.function = "strips_bytes", .formula = &bytes,
 *                                               .rows = &large_rows};
 *     static const struct judge_case cases[] = {
 *         {"bytes-of-large", "formula-large", 16, HIDDEN | QUICK, .ask = &ask_bytes}, ...
 *
 * The runner's side is graders/runner/questions.h. Packet: the function's name as 32 bytes, then
 * for a formula the number of rows and pairs of int32, for a builder four int64. Answer: a
 * formula's values (int64 a row), a number (a double), or what the builder's runner writes. */
#ifndef GRADERS_LIBRARY_QUESTIONS_H
#define GRADERS_LIBRARY_QUESTIONS_H

#include "graders/library/formula.h"
#include "graders/library/judge.h"

enum { QUESTION_NAME_BYTES = 32 };

/* Parameters at which a formula is asked, the smallest first; the second of a row is 0 if there is
 * one parameter. */
struct question_rows {
    const int32_t *pairs;
    int64_t count;
};
#define QUESTION_ROWS(array)                                                                       \
    {                                                                                              \
        (array), (int64_t)(sizeof(array) / sizeof *(array) / 2)                                    \
    }

struct question {
    const char *function; /* shorter than QUESTION_NAME_BYTES */
    /* one of these three */
    const struct formula *formula;
    const struct number *number;
    /* a builder: judges what it built. `asked` is the case's numbers; `said` reads the answer. */
    int (*judge)(const int64_t asked[4], struct reader *said, const struct usage *usage,
                 struct judgement *out, struct error *err);

    const struct question_rows *rows;        /* of a formula */
    size_t (*bound)(const int64_t asked[4]); /* of a builder: most bytes of its answer */
};

/* Writes the packet. Returns 0, or -1 and *err. */
int question_write(const struct question *question, const int64_t number[4], struct writer *input,
                   struct error *err) MUST_CHECK;

size_t question_answer_bound(const struct judge *judge, struct span input);

/* Judges an answer to a packet that question_write wrote, with the question found among the cases
 * of the task's judge. Returns 0, or -1 and *err. */
int question_judge(const struct task *task, struct judgement *out, struct error *err) MUST_CHECK;

#endif
