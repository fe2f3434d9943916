/* The worker's protocol, answers that can be compared, and the watch over the core. */
#include "bench/compare/answers.h"
#include "bench/measure/block.h"
#include "bench/measure/worker.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

struct counted {
    int runs, resets;
    char *piece;
    bool fails, was_fresh;
};

static int run_counted(void *context, struct error *err)
{
    struct counted *counted = context;
    counted->was_fresh = counted->piece[0] == 0;
    counted->piece[0] = 1;
    counted->runs++;
    return counted->fails ? error_set(err, "it cannot") : 0;
}

static void reset_counted(void *context)
{
    ((struct counted *)context)->resets++;
}

static int answer_counted(void *context, struct worker_answer *answer, struct error *err)
{
    (void)context;
    (void)err;
    answer_count(answer, 42);
    worker_fact(answer, "legs", 8);
    return 0;
}

/* Serves the lines and returns what was said; the caller frees it. */
static char *talk(struct counted *counted, const char *lines, int expected)
{
    struct worker_memory memory = {.piece_count = 0};
    struct worker_operation operation = {"walk", counted, run_counted, reset_counted,
                                         answer_counted};
    struct worker_subject subject = {&operation, 1, 1, &memory};
    char *said = NULL;
    size_t length;
    FILE *in = fmemopen((char *)(uintptr_t)lines, strlen(lines), "r");
    FILE *out = open_memstream(&said, &length);
    counted->piece = worker_memory_take(&memory, 100, NULL);
    assert_non_null(counted->piece);
    assert_int_equal(worker_serve(&subject, in, out, NULL), expected);
    fclose(in);
    fclose(out);
    worker_memory_release(&memory);
    return said;
}

static void samples_and_answers(void **state)
{
    struct counted counted = {0};
    double ns, before, after;
    int calls;
    (void)state;
    char *said = talk(&counted, "warm walk\nanswer walk\n", 0);
    assert_memory_equal(said, "ready walk\n", 11);
    assert_int_equal(sscanf(said + 11, "sample %lf %d %lf %lf", &ns, &calls, &before, &after), 4);
    assert_true(ns >= 0 && calls >= 1 && before > 0 && after > 0);
    assert_non_null(strstr(said, " 42 1 0 legs=8\n"));
    assert_int_equal(counted.runs, counted.resets);
    free(said);
}

static void cold_calls_get_fresh_pages(void **state)
{
    struct counted counted = {0};
    (void)state;
    free(talk(&counted, "warm walk\nwarm walk\n", 0));
    assert_false(counted.was_fresh);
    free(talk(&counted, "warm walk\ncold walk\n", 0));
    assert_true(counted.was_fresh);
    free(talk(&counted, "cold walk\nwarm walk\n", 0));
    assert_false(counted.was_fresh);
}

static void errors_are_told(void **state)
{
    struct counted counted = {.fails = true};
    (void)state;
    char *said = talk(&counted, "warm walk\nwarm run\nfly walk\n", 0);
    assert_string_equal(said, "ready walk\nerror it cannot\nerror there is no operation \"run\"\n"
                              "error do what? \"fly\"\n");
    free(said);
    said = talk(&counted, "nonsense\n", -1);
    free(said);
}

static void edges_agree_in_any_order(void **state)
{
    const int32_t one[] = {1, 2, 7, 3, 5, 9}, other[] = {9, 5, 2, 1, 3, 7};
    const int32_t wrong[] = {9, 5, 2, 1, 3, 8};
    struct worker_answer a = {0}, b = {0}, c = {0}, nothing = {0};
    (void)state;
    answer_edges(&a, one, 3);
    answer_edges(&b, other, 3);
    answer_edges(&c, wrong, 3);
    assert_int_equal(answers_agree(&a, &b), 1);
    assert_int_equal(answers_agree(&a, &c), 0);
    assert_int_equal(answers_agree(&a, &nothing), -1);
    answer_edges(&b, other, 2);
    assert_int_equal(answers_agree(&a, &b), 0);
}

static void strips_agree_when_they_hold_the_same_triangles(void **state)
{
    const int32_t long_strip[] = {0, 1, 2, 3}, two[] = {1, 3, 2, -1, 2, 0, 1};
    const int32_t turned_over[] = {1, 2, 3, -1, 2, 0, 1}, missing[] = {0, 1, 2};
    const int32_t twice[] = {0, 1, 2, 3, -1, 0, 1, 2};
    struct worker_answer a = {0}, b = {0};
    (void)state;
    answer_strips(&a, long_strip, 4);
    answer_strips(&b, two, 7);
    assert_int_equal(answers_agree(&a, &b), 1);
    assert_string_equal(b.facts, " indices=7");
    answer_strips(&b, turned_over, 7);
    assert_int_equal(answers_agree(&a, &b), 0);
    answer_strips(&b, missing, 3);
    assert_int_equal(answers_agree(&a, &b), 0);
    answer_strips(&b, twice, 8);
    assert_int_equal(answers_agree(&a, &b), 0);
}

static void read_meshes_agree_in_the_order_of_the_file(void **state)
{
    const float one[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1};
    const float rotated[] = {1, 0, 0, 0, 1, 0, -0.0F, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1};
    const float turned_over[] = {1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1};
    const float exchanged[] = {0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    const float about[] = {0, 0, 0, 1.0000001F, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1};
    struct worker_answer a = {0}, b = {0};
    (void)state;
    answer_read_mesh(&a, one, 2);
    answer_read_mesh(&b, rotated, 2);
    assert_int_equal(answers_agree(&a, &b), 1);
    answer_read_mesh(&b, turned_over, 2);
    assert_int_equal(answers_agree(&a, &b), 0);
    answer_read_mesh(&b, about, 2);
    assert_int_equal(answers_agree(&a, &b), 0);
    b.hash = 0;
    assert_int_equal(answers_agree(&a, &b), 1);
    answer_read_mesh(&b, exchanged, 2);
    b.hash = 0;
    assert_int_equal(answers_agree(&a, &b), 0);
}

static void normals_of_another_definition_are_near_ours(void **state)
{
    float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    int32_t triangles[] = {0, 1, 2};
    const struct mesh mesh = {
        .positions = positions, .vertex_count = 3, .triangles = triangles, .triangle_count = 1};
    const float exact[] = {0, 0, 1, 0, 0, 1, 0, 0, 1};
    const float near_by[] = {0.1F, 0, 0.99F, 0, 0, 1, 0, 0.1F, 0.99F};
    const float turned[] = {0, 0, 1, 0, 0, 1, 0, 1, 0};
    struct worker_answer a = {0}, b = {0};
    (void)state;
    answer_normals(&a, exact, 3);
    answer_normals_about(&b, near_by, &mesh);
    assert_int_equal(answers_agree(&a, &b), 1);
    answer_normals_about(&b, turned, &mesh);
    assert_int_equal(answers_agree(&a, &b), 0);
}

static void normals_and_areas_agree_within_tolerance(void **state)
{
    const float one[] = {1, 0, 0, 0, 1, 0}, other[] = {1, 1e-5F, 0, 0, 1, 0};
    const float exchanged[] = {0, 1, 0, 1, 0, 0}, turned[] = {0, 0, 1, 0, 1, 0};
    struct worker_answer a = {0}, b = {0}, c = {0};
    (void)state;
    answer_normals(&a, one, 2);
    answer_normals(&b, other, 2);
    assert_int_equal(answers_agree(&a, &b), 1);
    answer_normals(&c, exchanged, 2);
    assert_int_equal(answers_agree(&a, &c), 0);
    answer_normals(&c, turned, 2);
    assert_int_equal(answers_agree(&a, &c), 0);
    answer_normals(&c, one, 1);
    assert_int_equal(answers_agree(&a, &c), 0);
    a = b = c = (struct worker_answer){0};
    answer_area(&a, 1);
    answer_area(&b, 1 + 1e-8);
    answer_area(&c, 1 + 1e-4);
    assert_int_equal(answers_agree(&a, &b), 1);
    assert_int_equal(answers_agree(&a, &c), 0);
    c.value = strtod("nan", NULL);
    assert_int_equal(answers_agree(&a, &c), 0);
}

static void neighbours_are_told_apart(void **state)
{
    const int32_t one[] = {1, -1, -1, -1, 0, -1}, other[] = {1, -2, -1, -7, 0, -1};
    const int32_t turned[] = {-1, 1, -1, -1, 0, -1};
    struct worker_answer a = {0}, b = {0}, c = {0};
    (void)state;
    answer_neighbours(&a, one, 2);
    answer_neighbours(&b, other, 2);
    answer_neighbours(&c, turned, 2);
    assert_int_equal(answers_agree(&a, &b), 1); /* any negative number: none */
    assert_int_equal(answers_agree(&a, &c), 0);
}

/* A core at 10, a neighbour that takes half, and single looks that are too good to be true. */
static void slowed_samples_are_dropped(void **state)
{
    struct core_watch watch = {.samples = 0};
    (void)state;
    for (int i = 0; i < 100; i++)
        core_watch_accepts(&watch, 10 + 0.01 * (i % 10), i % 20 ? 10 : 14);
    assert_true(watch.dropped == 0);
    assert_true(core_watch_accepts(&watch, 9.7, 10));
    assert_false(core_watch_accepts(&watch, 5, 10));
    assert_false(core_watch_accepts(&watch, 10, 5));
    assert_int_equal(watch.samples, 103);
    assert_int_equal(watch.dropped, 2);
    for (int i = 0; i < 300; i++) /* the clock went down for good: that is the usual speed now */
        core_watch_accepts(&watch, 6, 6);
    assert_true(core_watch_accepts(&watch, 6, 6));
}

static void dead_and_refusing_programs_are_results(void **state)
{
    static const char *const dead[] = {"/bin/false", NULL}, *const missing[] = {"/nonexistent",
                                                                                NULL};
    static const char *const refuses[] = {"/bin/echo", "refused not today", NULL};
    const char *const *const programs[] = {dead, missing, refuses};
    static struct block_result results[3];
    struct core_watch watch = {.samples = 0};
    struct block_plan plan = {
        .programs = programs, .program_count = 3, .rounds = 1, .cold_rounds = 1, .seconds = 20};
    (void)state;
    for (plan.number = 0; plan.number < 4; plan.number++) {
        assert_int_equal(block_run(&plan, &watch, results, NULL), 0);
        assert_string_equal(results[0].refused, "the worker ended with 1");
        assert_string_equal(results[1].refused, "the worker could not be started");
        assert_string_equal(results[2].refused, "not today");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(samples_and_answers),
        cmocka_unit_test(cold_calls_get_fresh_pages),
        cmocka_unit_test(errors_are_told),
        cmocka_unit_test(edges_agree_in_any_order),
        cmocka_unit_test(strips_agree_when_they_hold_the_same_triangles),
        cmocka_unit_test(read_meshes_agree_in_the_order_of_the_file),
        cmocka_unit_test(normals_of_another_definition_are_near_ours),
        cmocka_unit_test(normals_and_areas_agree_within_tolerance),
        cmocka_unit_test(neighbours_are_told_apart),
        cmocka_unit_test(slowed_samples_are_dropped),
        cmocka_unit_test(dead_and_refusing_programs_are_results),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
