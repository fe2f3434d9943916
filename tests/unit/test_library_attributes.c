/* Attributes per vertex, corner and face: as inputs, written beside a mesh and found by its judge, and
 * as answers. */
#include "graders/library/judge.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const struct answer_rule rule = {.function = "attributes",
                                        .parts = {ANSWER_PER_VERTEX("normals", TYPE_DOUBLE, 3),
                                                  ANSWER_PER_CORNER("uv", TYPE_FLOAT, 2),
                                                  ANSWER_PER_FACE("labels", TYPE_INT32, 1)}};

/* What judge() saw. */
static struct task seen;
static int64_t written_beside;

static int look(const struct task *task, struct judgement *out, struct error *err)
{
    struct reader beside = task->beside;
    (void)err;
    seen = *task;
    written_beside = read_int(&beside);
    judge_accept(out);
    return 0;
}

static int write_sizes(const struct task *task, uint64_t seed, struct writer *beside,
                       struct error *err)
{
    (void)seed;
    (void)err;
    write_int(beside, 1000 * task->sizes.corners + task->number[1]);
    return 0;
}

static const struct judge_case prism = {
    .name = "prism", .seed = 3, .mesh = {SHAPE_COURSE_PRISM}, .number = {8, 9}};
static const struct judge judge = {
    .exercise = "attributes",
    .cases = &prism,
    .case_count = 1,
    .input = INPUT_POLYGONS,
    .attributes = {{PER_CORNER, 2, ATTRIBUTE_RANDOM}, {PER_FACE, 1, ATTRIBUTE_WHOLE}},
    .answer = &rule,
    .judge = look,
    .write_beside = write_sizes,
};

static struct writer make(const struct judge *of, uint64_t seed)
{
    struct judge_case c = prism;
    struct writer input = writer_growing();
    struct error err = {""};
    c.seed = seed;
    if (judge_make(of, &c, NULL, &input, &err) != 0)
        fail_msg("%s", err.text);
    return input;
}

/* Judges an answer of 6 vertices, 18 corners and 5 faces. */
static void answer(const struct writer *input, const double *normals, const float *uv,
                   struct judgement *out)
{
    static const int32_t labels[5] = {0, 1, 2, 3, 4};
    static uint64_t bytes[256];
    struct writer writer = writer_into(bytes, sizeof bytes);
    struct error err = {""};
    write_int(&writer, 0);
    write_table(&writer, normals, 6, 3 * sizeof *normals);
    write_table(&writer, uv, 18, 2 * sizeof *uv);
    write_table(&writer, labels, 5, sizeof *labels);
    assert_false(writer.failed);
    memset(out, 0, sizeof *out);
    if (judge_answer(&judge, (struct span){input->bytes, input->count},
                     (struct span){(unsigned char *)bytes, writer.count}, NULL, out, &err) != 0)
        fail_msg("%s", err.text);
    scene_release(&out->scene);
}

static void the_judge_finds_what_was_written(void **state)
{
    static const double normals[18];
    static const float uv[36] = {[35] = 0.5F};
    struct writer input = make(&judge, 3);
    struct judgement out;
    (void)state;
    answer(&input, normals, uv, &out);
    assert_true(out.accepted);
    assert_int_equal(seen.attribute[0].row_count, 18);
    assert_int_equal(seen.attribute[0].columns, 2);
    assert_int_equal(seen.attribute[1].row_count, 5);
    assert_int_equal(seen.attribute[1].columns, 1);
    for (int i = 0; i < 36; i++)
        assert_true(fabs((double)seen.attribute[0].values[i]) <= 1);
    for (int i = 0; i < 5; i++)
        assert_true(floorf(seen.attribute[1].values[i]) == seen.attribute[1].values[i]);
    assert_int_equal(seen.number[0], 8);
    assert_int_equal(written_beside, 18009);
    assert_int_equal(seen.answer.table[0].count, 6);
    assert_int_equal(seen.answer.table[1].count, 18);
    assert_true(answer_float(&seen.answer.table[1], 17, 1) == 0.5);
    assert_int_equal(answer_int(&seen.answer.table[2], 4, 0), 4);
    writer_release(&input);
}

static void the_seed_decides_the_values(void **state)
{
    struct writer one = make(&judge, 3), same = make(&judge, 3), other = make(&judge, 4);
    (void)state;
    assert_int_equal(one.count, same.count);
    assert_memory_equal(one.bytes, same.bytes, one.count);
    assert_int_equal(one.count, other.count);
    assert_memory_not_equal(one.bytes, other.bytes, one.count);
    writer_release(&one);
    writer_release(&same);
    writer_release(&other);
}

static void unit_rows_have_length_one(void **state)
{
    const struct attribute_rule rules[ATTRIBUTES_MOST] = {{PER_VERTEX, 3, ATTRIBUTE_UNIT}};
    struct attribute_view views[ATTRIBUTES_MOST];
    struct writer writer = writer_growing();
    (void)state;
    assert_int_equal(attributes_write(rules, (struct input_sizes){500, 7, 9}, 1, &writer, NULL), 0);
    struct reader reader = reader_of(writer.bytes, writer.count);
    attributes_read(&reader, views);
    assert_int_equal(views[0].row_count, 500);
    assert_null(views[1].values);
    for (int i = 0; i < 500; i++) {
        const float *row = views[0].values + 3 * i;
        double square = (double)row[0] * (double)row[0] + (double)row[1] * (double)row[1] +
                        (double)row[2] * (double)row[2];
        assert_true(fabs(square - 1) < 1e-6);
    }
    writer_release(&writer);
}

static void columns_have_a_limit(void **state)
{
    const struct attribute_rule rules[ATTRIBUTES_MOST] = {{PER_VERTEX, 9, ATTRIBUTE_UNIT}};
    struct writer writer = writer_growing();
    struct error err = {""};
    (void)state;
    assert_int_equal(attributes_write(rules, (struct input_sizes){5, 7, 9}, 1, &writer, &err), -1);
    assert_string_equal(err.text, "an attribute has 1 to 8 columns, not 9");
    writer_release(&writer);
}

static void what_is_no_number_is_refused(void **state)
{
    double normals[18] = {0};
    float uv[36] = {0};
    struct writer input = make(&judge, 3);
    struct judgement out;
    (void)state;
    uv[2 * 7 + 1] = NAN;
    answer(&input, normals, uv, &out);
    assert_false(out.accepted);
    assert_string_equal(out.cause, "not-finite");
    assert_string_equal(out.element.en, "corner 7");
    uv[2 * 7 + 1] = 0;
    normals[4] = INFINITY;
    answer(&input, normals, uv, &out);
    assert_string_equal(out.message.en, "vertex 1: normals holds inf, which is no number.");
    writer_release(&input);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_judge_finds_what_was_written),
        cmocka_unit_test(the_seed_decides_the_values),
        cmocka_unit_test(unit_rows_have_length_one),
        cmocka_unit_test(columns_have_a_limit),
        cmocka_unit_test(what_is_no_number_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
