/* Exercises that ask several small functions; see questions.h. */
#include "graders/library/questions.h"

#include <math.h>
#include <string.h>

static const struct cause malformed = {"malformed-answer",
                                       {"incomplete answer", "respuesta incompleta"}};

int question_write(const struct question *question, const int64_t number[4], struct writer *input,
                   struct error *err)
{
    char name[QUESTION_NAME_BYTES] = "";
    strncpy(name, question->function, sizeof name - 1);
    write_array(input, name, 1, sizeof name);
    if (question->formula) {
        write_int(input, question->rows->count);
        write_array(input, question->rows->pairs, question->rows->count, 2 * sizeof(int32_t));
    }
    for (int i = 0; question->judge && i < 4; i++)
        write_int(input, number[i]);
    return input->failed ? error_set(err, "out of memory for a question") : 0;
}

/* The question of a packet, which the reader is moved behind; NULL when no case asks it. */
static const struct question *find_question(const struct judge *judge, struct reader *input)
{
    const char *name = read_array(input, 1, QUESTION_NAME_BYTES);
    for (size_t i = 0; name && i < judge->case_count; i++)
        if (strncmp(judge->cases[i].ask->function, name, QUESTION_NAME_BYTES) == 0)
            return judge->cases[i].ask;
    return NULL;
}

static void read_numbers(struct reader *input, int64_t number[4])
{
    for (int i = 0; i < 4; i++)
        number[i] = read_int(input);
}

size_t question_answer_bound(const struct judge *judge, struct span input)
{
    struct reader in = reader_of(input.bytes, input.count);
    const struct question *question = find_question(judge, &in);
    int64_t number[4];
    if (!question || question->number)
        return sizeof(double);
    if (question->formula)
        return sizeof(int64_t) * (size_t)read_int(&in);
    read_numbers(&in, number);
    return question->bound(number);
}

static int judge_formula(const struct question *question, struct reader *in, struct reader *said,
                         struct judgement *out, struct error *err)
{
    int64_t row_count = read_int(in);
    const int32_t *rows = read_array(in, row_count, 2 * sizeof *rows);
    const int64_t *answers = read_array(said, row_count, sizeof *answers);
    if (answers)
        return formula_judge(question->formula, rows, row_count, answers, out, err);
    judge_reject(out, &malformed, "The answer of %s is incomplete.",
                 "La respuesta de %s está incompleta.", question->function);
    return 0;
}

int question_judge(const struct task *task, struct judgement *out, struct error *err)
{
    struct reader in = reader_of(task->input.bytes, task->input.count);
    struct reader said = reader_of(task->said.bytes, task->said.count);
    const struct question *question = find_question(task->judge, &in);
    int64_t number[4];
    if (!question)
        return error_set(err, "judge %s: no case asks the function of this input",
                         task->judge->exercise);
    if (question->formula)
        return judge_formula(question, &in, &said, out, err);
    if (question->judge) {
        read_numbers(&in, number);
        return question->judge(number, &said, task->usage, out, err);
    }
    double value = read_real(&said);
    formula_judge_number(question->number, said.failed ? (double)NAN : value, out);
    return 0;
}
