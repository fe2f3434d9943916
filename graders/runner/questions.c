/* Asking formulas and numbers; see questions.h. */
#include "graders/runner/questions.h"

#include <string.h>

enum { NAME_BYTES = 32 }; /* QUESTION_NAME_BYTES */

static void ask_formula(const struct asked *asked, struct reader *input, struct writer *answer)
{
    int64_t row_count = read_int(input);
    const int32_t *rows = read_array(input, row_count, 2 * sizeof *rows);
    measure_begin();
    for (int64_t i = 0; rows && i < row_count; i++)
        write_int(answer, asked->formula_of_two
                              ? asked->formula_of_two(rows[2 * i], rows[2 * i + 1])
                              : asked->formula_of_one(rows[2 * i]));
    measure_end();
}

static void ask_number(const struct asked *asked, struct writer *answer)
{
    measure_begin();
    double value = asked->number ? asked->number() : asked->count();
    measure_end();
    write_real(answer, value);
}

const char *ask(const struct asked *table, struct reader *input, struct writer *answer)
{
    const char *name = read_array(input, 1, NAME_BYTES);
    for (const struct asked *asked = table; name && asked->function; asked++) {
        if (strncmp(asked->function, name, NAME_BYTES) != 0)
            continue;
        if (asked->number || asked->count)
            ask_number(asked, answer);
        else
            ask_formula(asked, input, answer);
        return NULL;
    }
    return name;
}
