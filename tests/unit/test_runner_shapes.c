/* The runner's side of declared inputs and answers: each shape reads what its judge wrote, calls the
 * student's function once between the measures, and writes what the judge reads. The runner here has
 * nothing of the real one but these shapes. */
#include "graders/library/judge.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { OUT_OF_MEMORY = -1, ANSWER_BYTES = 1 << 16 };

static int begun, ended;
static bool said_out_of_memory;

#include "graders/runner/shapes.c"

void measure_begin(void)
{
    begun++;
}

void measure_end(void)
{
    ended++;
}

void look_at_result(const void *result, size_t bytes)
{
    assert_non_null(result);
    assert_true(bytes == sizeof(int64_t));
}

void look_at_table(const void *table, size_t bytes)
{
    assert_true(table || bytes == 0);
}

void call_out_of_memory(void)
{
    said_out_of_memory = true;
}

/* ------------------------------------------------------------------------ what students write */

/* The sum of a corner attribute's rows goes to each face. */
static int32_t sum_of_faces(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                            const float *attribute, float *sums)
{
    assert_non_null(triangles);
    assert_int_equal(vertex_count, 4);
    for (int32_t f = 0; f < triangle_count; f++)
        sums[f] = attribute[6 * f] + attribute[6 * f + 2] + attribute[6 * f + 4];
    return 0;
}

/* The heights above 0, and a flag for each sample. */
static int32_t hills(const float *samples, int32_t rows, int32_t columns, int32_t **found,
                     int32_t *is_hill)
{
    int32_t count = 0;
    *found = malloc(sizeof **found * (size_t)(rows * columns));
    assert_non_null(*found);
    for (int32_t i = 0; i < rows * columns; i++) {
        is_hill[i] = samples[i] > 0;
        if (is_hill[i])
            (*found)[count++] = i;
    }
    return count;
}

static double length_of(const float *points, int32_t point_count, int32_t is_closed)
{
    assert_non_null(points);
    return point_count + 100.0 * is_closed;
}

static int32_t first_of_soup(const float *corners, int32_t triangle_count, float *first)
{
    memcpy(first, corners, 9 * sizeof *first);
    return triangle_count > 1 ? 0 : -1;
}

void call_sums(struct reader *input, struct writer *answer);
void call_hills(struct reader *input, struct writer *answer);
void call_length(struct reader *input, struct writer *answer);
void call_first(struct reader *input, struct writer *answer);

#define FIELD_OF given_field, given.points, given.rows, given.columns
#define run_call call_sums
CALL_GIVEN(sum_of_faces, GIVEN(TRIANGLES, ATTRIBUTE(1)), float, 1, given.face_count)
#undef run_call
#define run_call call_hills
CALL_TABLE_GIVEN(hills, FIELD_OF, int32_t, 1, int32_t, (int64_t)given.rows *given.columns)
#undef run_call
#define run_call call_length
CALL_REAL(length_of, LINE)
#undef run_call
#define run_call call_first
CALL_GIVEN(first_of_soup, SOUP, float, 9, 1)
#undef run_call

/* -------------------------------------------------------------------------------------- tests */

static struct answer answered;
static struct judgement read_as;

/* Makes the input, calls, and reads the answer. */
static void call(const struct judge *judge, const struct judge_case *c,
                 void (*run)(struct reader *input, struct writer *answer), struct writer *input)
{
    static uint64_t bytes[ANSWER_BYTES / sizeof(uint64_t)];
    struct error err = {""};
    *input = writer_growing();
    if (judge_make(judge, c, NULL, input, &err) != 0)
        fail_msg("%s", err.text);
    struct reader reader = reader_of(input->bytes, input->count);
    struct writer writer = writer_into(bytes, sizeof bytes);
    begun = ended = 0;
    said_out_of_memory = false;
    run(&reader, &writer);
    assert_int_equal(begun, 1);
    assert_int_equal(ended, 1);
    assert_false(writer.failed);
    memset(&read_as, 0, sizeof read_as);
    if (!said_out_of_memory &&
        !answer_read(judge->answer, (struct input_sizes){4, 4, 12},
                     (struct span){(unsigned char *)bytes, writer.count}, &answered, &read_as))
        fail_msg("%s", read_as.message.en);
}

static void an_array_of_the_callers(void **state)
{
    static const struct answer_rule rule = {.function = "sum_of_faces",
                                            .parts = {ANSWER_PER_FACE("sums", TYPE_FLOAT, 1)}};
    const struct judge judge = {
        .input = INPUT_MESH,
        .answer = &rule,
        .attributes = {{PER_VERTEX, 3, ATTRIBUTE_UNIT}, {PER_CORNER, 2, ATTRIBUTE_WHOLE}}};
    const struct judge_case c = {.name = "c", .seed = 5, .mesh = {SHAPE_TETRAHEDRON}};
    struct writer input;
    (void)state;
    call(&judge, &c, call_sums, &input);
    assert_int_equal(answered.table[0].count, 4);
    struct reader reader = reader_of(input.bytes, input.count);
    struct given given = given_triangles(&reader);
    for (int64_t f = 0; f < 4; f++) {
        const float *row = given.attribute[1] + 6 * f;
        assert_true(answer_float(&answered.table[0], f, 0) == (double)(row[0] + row[2] + row[4]));
    }
    writer_release(&input);
}

static void a_table_and_an_array_of_a_field(void **state)
{
    static const struct answer_rule rule = {
        .function = "hills",
        .result = RESULT_COUNT,
        .counted = {"hills", "cimas"},
        .most = {.once = 63},
        .parts = {{.argument = "*found", .row = {"hill", "cima"}, .columns = 1},
                  {.argument = "is_hill",
                   .row = {"sample", "muestra"},
                   .columns = 1,
                   .rows = ROWS_FIXED,
                   .most = {.once = 63}}}};
    const struct judge judge = {.input = INPUT_FIELD, .answer = &rule};
    const struct judge_case c = {
        .name = "c", .seed = 5, .field = {FIELD_NOISE, .rows = 7, .columns = 9}};
    struct writer input;
    int64_t hill_count = 0;
    (void)state;
    call(&judge, &c, call_hills, &input);
    for (int64_t i = 0; i < 63; i++)
        if (answer_int(&answered.table[1], i, 0))
            assert_int_equal(answer_int(&answered.table[0], hill_count++, 0), i);
    assert_int_equal(answered.result, hill_count);
    assert_in_range(hill_count, 1, 62);
    writer_release(&input);
}

static void a_volume_has_layers(void **state)
{
    const struct judge judge = {.input = INPUT_FIELD};
    const struct judge_case c = {.seed = 5,
                                 .field = {FIELD_SPHERE, .rows = 4, .columns = 3, .layers = 5}};
    struct writer input = writer_growing();
    (void)state;
    assert_int_equal(judge_make(&judge, &c, NULL, &input, NULL), 0);
    struct reader reader = reader_of(input.bytes, input.count);
    struct given given = given_field(&reader);
    assert_int_equal(given.rows, 4);
    assert_int_equal(given.columns, 3);
    assert_int_equal(given.layers, 5);
    assert_non_null(given.points);
    assert_false(reader.failed);
    assert_int_equal(reader.at, reader.count);
    writer_release(&input);
}

static void a_real_of_a_line(void **state)
{
    static const struct answer_rule rule = {.function = "length_of", .result = RESULT_REAL};
    const struct judge judge = {.input = INPUT_LINE, .answer = &rule};
    const struct judge_case c = {.seed = 5, .line = {LINE_SPIRAL, .count = 40}};
    struct writer input;
    (void)state;
    call(&judge, &c, call_length, &input);
    struct reader reader = reader_of(input.bytes, input.count);
    struct line_view line = line_read(&reader);
    assert_true(answered.real == line.point_count + 100.0 * line.is_closed);
    writer_release(&input);
}

static void a_soup_and_memory_that_ran_out(void **state)
{
    static const struct answer_rule rule = {.function = "first_of_soup",
                                            .parts = {{.argument = "first",
                                                       .row = {"triangle", "triángulo"},
                                                       .type = TYPE_FLOAT,
                                                       .columns = 9,
                                                       .rows = ROWS_FIXED,
                                                       .most = {.once = 1}}}};
    const struct judge judge = {.input = INPUT_SOUP, .answer = &rule};
    const struct judge_case four = {.seed = 5, .mesh = {SHAPE_TETRAHEDRON}};
    const struct judge_case one = {.seed = 5, .mesh = {SHAPE_ONE_TRIANGLE}};
    struct writer input;
    (void)state;
    call(&judge, &four, call_first, &input);
    struct reader reader = reader_of(input.bytes, input.count);
    struct soup_view soup = soup_input_read(&reader);
    for (int i = 0; i < 9; i++)
        assert_true(answer_float(&answered.table[0], 0, i) == (double)soup.corners[i]);
    writer_release(&input);
    call(&judge, &one, call_first, &input);
    assert_true(said_out_of_memory);
    writer_release(&input);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_array_of_the_callers),
        cmocka_unit_test(a_table_and_an_array_of_a_field),
        cmocka_unit_test(a_volume_has_layers),
        cmocka_unit_test(a_real_of_a_line),
        cmocka_unit_test(a_soup_and_memory_that_ran_out),
    };
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    release_kept();
    return failed;
}
