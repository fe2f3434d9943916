/* Answers of rows of unequal length, as they are read: none at all, and a row that names what is
 * not there. */
#include "graders/library/answer.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static const struct answer_rule rule = {.function = "loops",
                                        .result = RESULT_COUNT,
                                        .counted = {"loops", "bucles"},
                                        .most = {.once = 8},
                                        .parts = {{.argument = "*first or *vertices",
                                                   .row = {"loop", "bucle"},
                                                   .columns = 1,
                                                   .of = OF_VERTEX,
                                                   .rows = ROWS_OF_ROWS,
                                                   .most = {.once = 24}}}};

/* Reads an answer of `count` rows. */
static bool read_rows(int64_t count, const int32_t *first, const int32_t *values,
                      struct answer *answer, struct judgement *out)
{
    static char bytes[1024];
    struct writer writer = writer_into(bytes, sizeof bytes);
    write_int(&writer, count);
    write_table(&writer, first, count > 0 ? count + 1 : 0, sizeof *first);
    write_table(&writer, values, first && count > 0 ? first[count] : 0, sizeof *values);
    return answer_read(&rule, (struct input_sizes){.vertices = 5},
                       (struct span){bytes, writer.count}, answer, out);
}

static void no_row_needs_no_table(void **state)
{
    (void)state;
    struct answer answer;
    struct judgement out = {0};
    if (!read_rows(0, NULL, NULL, &answer, &out))
        fail_msg("%s", out.message.en);
    assert_int_equal(answer.table[0].row_count, 0);
    assert_int_equal(answer.table[0].count, 0);
    assert_int_equal(answer.table[0].first[0], 0);
    assert_false(read_rows(1, NULL, NULL, &answer, &out));
    assert_string_equal(out.cause, "no-table");
}

static void the_row_is_named_and_not_the_value(void **state)
{
    (void)state;
    const int32_t first[] = {0, 3, 3, 6}, values[] = {0, 1, 2, 2, 5, 4};
    struct answer answer;
    struct judgement out = {0};
    assert_false(read_rows(3, first, values, &answer, &out));
    assert_string_equal(out.element.en, "loop 2");
    assert_string_equal(out.message.en, "loop 2: 5 is out of range; vertices are numbered 0 to 4. "
                                        "Is counting from 1?");
}

static void expect_place(const struct answer_rule *declared, uint32_t table, int64_t byte,
                         const char *en, const char *es)
{
    struct message place;
    answer_place(declared, table, byte, &place);
    assert_string_equal(place.en, en);
    assert_string_equal(place.es, es);
}

static void places_are_named_as_the_student_knows_them(void **state)
{
    (void)state;
    static const struct answer_rule rows = {
        .function = "loops",
        .parts = {{.argument = "*first or *values",
                   .offsets = "*first",
                   .values = "*values",
                   .columns = 1,
                   .rows = ROWS_OF_ROWS},
                  {.argument = "*edges",
                   .columns = 2,
                   .type = TYPE_DOUBLE,
                   .column = {{.name = "vi"}, {.name = "vf"}}}}};
    expect_place(&rows, 0, 0, "what loops returns", "lo que devuelve loops");
    expect_place(&rows, 1, 5, "entry 1 of *first", "la entrada 1 de *first");
    expect_place(&rows, 2, 40, "entry 10 of *values", "la entrada 10 de *values");
    expect_place(&rows, 3, 56, "vf of row 3 of *edges", "vf de la fila 3 de *edges");
    expect_place(&rows, 4, 9, "byte 9 of array 4 of the answer",
                 "el byte 9 de la tabla 4 de la respuesta");
    expect_place(NULL, 1, 9, "byte 9 of array 1 of the answer",
                 "el byte 9 de la tabla 1 de la respuesta");
    expect_place(NULL, 0, 0, "what the function returns", "lo que devuelve la función");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(places_are_named_as_the_student_knows_them),
                                       cmocka_unit_test(no_row_needs_no_table),
                                       cmocka_unit_test(the_row_is_named_and_not_the_value)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
