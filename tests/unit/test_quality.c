/* Quality of right answers: what a band of a class rejects and what it leaves alone, from the judge
 * through the stored result to terminal and page. */
#include "graders/library/quality.h"

#include "graders/engine/result/score.h"
#include "graders/report/check.h"
#include "graders/report/report.h"
#include "graders/report/terminal.h"
#include "tests/unit/report_sample.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SAYS_NOTHING = -2, SAYS_WRONG = -1 };

static const struct cause mistaken = {"mistaken", {"mistaken", "equivocada"}};

/* The answer is its own quality. */
static int judge_number(const struct task *task, struct judgement *out, struct error *err)
{
    struct reader reader = reader_of(task->said.bytes, task->said.count);
    double value = read_real(&reader);
    (void)err;
    if (!(value <= SAYS_NOTHING) || value < SAYS_NOTHING)
        judge_quality(out, value);
    if (value <= SAYS_WRONG && value > SAYS_NOTHING)
        judge_reject(out, &mistaken, "The answer is %g.", "La respuesta es %g.", value);
    else
        judge_accept(out);
    return 0;
}

enum { RIGHT, FAIR, GOOD, CASES };

static const struct judge_case cases[CASES] = {
    {.name = "plain", .class_name = "closed", .seed = 1, .runs = PUBLIC | QUICK},
    {.name = "strip", .class_name = "quality-fair", .seed = 2, .runs = PUBLIC},
    {.name = "strip-2", .class_name = "quality-good", .seed = 3, .runs = PUBLIC},
};

static const struct judge less = {
    .exercise = "edge-table-any",
    .cases = cases,
    .case_count = CASES,
    .judge = judge_number,
    .quality = {.name = {"indices per triangle", "índices por triángulo"},
                .less_is_better = true,
                .bands = {{"quality-fair", 1.6}, {"quality-good", 1.25}}}};

static const struct judge more = {
    .exercise = "edge-table-any",
    .cases = cases,
    .case_count = CASES,
    .judge = judge_number,
    .quality = {.name = {"smallest angle", "ángulo mínimo"},
                .unit = {"degrees", "grados"},
                .bands = {{"quality-good", 25, {"sound", "sólida"}}}}};

static const struct judge undeclared = {
    .exercise = "edge-table-any", .cases = cases, .case_count = CASES, .judge = judge_number};

static struct span span_of(const double *value)
{
    return (struct span){(const unsigned char *)value, sizeof *value};
}

static struct judgement ask(const struct judge *judge, int c, double value)
{
    struct judgement judgement = {0};
    struct error err = {""};
    if (judge_case_answer(judge, c < 0 ? NULL : &cases[c], (struct span){0}, span_of(&value), NULL,
                          &judgement, &err) != 0)
        fail_msg("%s", err.text);
    return judgement;
}

static void assert_fault(const struct judge *judge, int c, double value, const char *expected)
{
    struct judgement judgement = {0};
    struct error err = {""};
    assert_int_equal(judge_case_answer(judge, c < 0 ? NULL : &cases[c], (struct span){0},
                                       span_of(&value), NULL, &judgement, &err),
                     -1);
    assert_string_equal(err.text, expected);
}

static void a_band_rejects_only_its_class(void **state)
{
    (void)state;
    static const struct {
        int c;
        double value;
        bool accepted;
    } asked[] = {{RIGHT, 3, true},   {FAIR, 1.6, true},       {FAIR, 1.7, false},
                 {GOOD, 1.25, true}, {GOOD, 1.5, false},      {-1, 3, true},
                 {FAIR, 0, true},    {GOOD, 1.2500001, false}};
    for (size_t i = 0; i < sizeof asked / sizeof *asked; i++) {
        struct judgement judgement = ask(&less, asked[i].c, asked[i].value);
        assert_int_equal(judgement.accepted, asked[i].accepted);
        assert_true(judgement.has_quality);
        assert_true(fabs(judgement.quality - asked[i].value) < 1e-12);
        assert_string_equal(judgement.cause, asked[i].accepted ? "" : "poor-quality");
    }
}

static void a_rejection_names_number_and_limit(void **state)
{
    (void)state;
    struct judgement judgement = ask(&less, GOOD, 1.31);
    assert_string_equal(judgement.cause_name.en, "poor quality");
    assert_string_equal(judgement.cause_name.es, "poca calidad");
    assert_string_equal(judgement.message.en,
                        "The answer is right but poor: 1.31 indices per triangle (at most 1.25).");
    assert_string_equal(judgement.message.es, "Respuesta correcta pero pobre: 1.31 índices por "
                                              "triángulo (máximo 1.25).");
    judgement = ask(&more, GOOD, 23.125);
    assert_string_equal(
        judgement.message.en,
        "The answer is right but poor: smallest angle 23.12 degrees (at least 25).");
    assert_string_equal(judgement.message.es,
                        "Respuesta correcta pero pobre: ángulo mínimo 23.12 grados (mínimo 25).");
    assert_true(ask(&more, GOOD, 25).accepted);
    judgement = ask(&less, GOOD, 1.2500001);
    assert_non_null(strstr(judgement.message.en, "1.2500001 indices"));
}

static void a_wrong_answer_stays_wrong_and_has_no_quality(void **state)
{
    (void)state;
    struct judgement judgement = ask(&less, GOOD, SAYS_WRONG);
    assert_false(judgement.accepted);
    assert_false(judgement.has_quality);
    assert_string_equal(judgement.cause, "mistaken");
}

static void what_a_judge_forgot_is_a_fault(void **state)
{
    (void)state;
    assert_fault(&less, GOOD, (double)NAN,
                 "the quality of a right answer is nan; judge_quality() takes finite numbers only");
    assert_fault(&less, -1, (double)INFINITY,
                 "the quality of a right answer is inf; judge_quality() takes finite numbers only");
    assert_fault(&less, GOOD, SAYS_NOTHING,
                 "class quality-good has a band of quality, and the judge accepted an answer "
                 "without a number; call judge_quality()");
    assert_fault(&undeclared, RIGHT, 1,
                 "the judge told a quality that it does not declare; name it in .quality");
    struct judgement judgement = ask(&less, RIGHT, SAYS_NOTHING);
    assert_true(judgement.accepted && !judgement.has_quality);
}

static void a_fault_names_the_exercise(void **state)
{
    struct examination examination;
    struct error err = {""};
    double value = (double)NAN;
    (void)state;
    assert_int_equal(
        examine(&less, &cases[GOOD], (struct span){0}, span_of(&value), NULL, &examination, &err),
        -1);
    assert_non_null(strstr(err.text, "judge edge-table-any: the quality of a right answer is nan"));
}

/* ---------------------------------------------------------------- the result */

static struct exercise exercise_of_classes(void)
{
    struct exercise exercise = {.name = "edge-table-any",
                                .group = "edges",
                                .problem = "4.5 (a)",
                                .title = {"Strips", "Tiras"},
                                .classes = {{"closed", {"Closed meshes", "Mallas cerradas"}, 7},
                                            {"quality-fair", {"Fair strips", "Tiras pasables"}, 2},
                                            {"quality-good", {"Good strips", "Tiras buenas"}, 1}},
                                .class_count = CASES,
                                .max_score = 10};
    return exercise;
}

/* The result of a submission that answers `values`. */
static json_t *grade(const struct judge *judge, const double values[CASES])
{
    struct exercise exercise = exercise_of_classes();
    struct yardstick yardstick = {.inputs = {.exercise = &exercise, .judge = judge}};
    struct case_result results[CASES] = {{.run = false}};
    struct trial trial = {.yardstick = &yardstick, .student = "ana", .cases = results};
    struct submitter submitter = {"ana", "ana-garcia"};
    struct outcome outcome = {NULL, NULL};
    struct error err = {""};
    for (int c = 0; c < CASES; c++) {
        struct examination examination;
        assert_int_equal(examine(judge, &cases[c], (struct span){0}, span_of(&values[c]), NULL,
                                 &examination, &err),
                         0);
        results[c].run = true;
        attempt_take(&results[c].attempt, &examination);
        assert_true(attempt_is_right(&results[c].attempt));
    }
    if (score_trial(&trial, &submitter, &outcome, &err) != 0)
        fail_msg("%s", err.text);
    json_t *result = json_incref(outcome.result);
    outcome_release(&outcome);
    if (result_check(result, &err) != 0)
        fail_msg("%s", err.text);
    return result;
}

static char *print(const json_t *result, enum language language)
{
    char *text = NULL;
    size_t length = 0;
    struct terminal_style style = {.language = language};
    FILE *to = open_memstream(&text, &length);
    assert_non_null(to);
    terminal_print_result(to, result, &style);
    fclose(to);
    return text;
}

static void assert_says(const char *text, const char *part)
{
    if (!strstr(text, part))
        fail_msg("no \"%s\" in:\n%s", part, text);
}

static const double poor[CASES] = {3, 1.5, 1.31};

static void a_poor_answer_keeps_its_points_of_correctness(void **state)
{
    (void)state;
    json_t *result = grade(&less, poor);
    assert_string_equal(json_string_value(json_object_get(result, "verdict")), "poor-quality");
    assert_string_equal(json_string_value(json_object_get(result, "cause")), "poor-quality");
    assert_true(fabs(json_number_value(json_object_get(result, "score")) - 9) < 1e-9);
    const json_t *strip = json_array_get(json_object_get(result, "cases"), GOOD);
    assert_true(fabs(json_number_value(json_object_get(strip, "quality")) - 1.31) < 1e-12);
    json_t *quality = json_object_get(json_object_get(result, "measures"), "quality");
    assert_true(fabs(json_number_value(json_object_get(quality, "worst")) - 1.5) < 1e-12);
    json_decref(result);
}

static void the_terminal_tells_it(void **state)
{
    (void)state;
    json_t *result = grade(&less, poor);
    char *text = print(result, LANGUAGE_EN);
    assert_says(text,
                "✗ The answer is right but poor: 1.31 indices per triangle (at most 1.25).\n");
    assert_says(text, "\n  where   case strip-2 (Good strips)\n");
    assert_says(text, "\n  quality: 1.5 indices per triangle (fair 1.6, good 1.25)\n");
    free(text);
    text = print(result, LANGUAGE_ES);
    assert_says(text, "\n  calidad: 1.5 índices por triángulo (aceptable 1.6, buena 1.25)\n");
    free(text);
    json_decref(result);

    result = grade(&more, (const double[CASES]){3, 4, 23.125});
    text = print(result, LANGUAGE_EN);
    assert_says(text, "\n  quality: smallest angle 23.12 degrees (sound 25)\n");
    free(text);
    json_decref(result);

    result = grade(&less, (const double[CASES]){3, 1.5, 1.25});
    assert_string_equal(json_string_value(json_object_get(result, "verdict")), "passed");
    json_decref(result);
}

/* A result without a number is what it was before there was quality. */
static void without_a_number_nothing_is_told(void **state)
{
    (void)state;
    json_t *result = grade(&undeclared, (const double[CASES]){-2, -2, -2});
    char *text = print(result, LANGUAGE_EN);
    assert_null(strstr(text, "quality:"));
    assert_null(json_object_get(json_object_get(result, "measures"), "quality"));
    assert_null(json_object_get(json_array_get(json_object_get(result, "cases"), 0), "quality"));
    free(text);
    json_decref(result);
}

static void the_page_and_the_export_show_it(void **state)
{
    char out[64];
    struct error err = {""};
    (void)state;
    json_t *result = grade(&less, poor);
    sample_copy(out);
    json_object_set_new(result, "student", json_string("ana-garcia"));
    sample_store(out, result);
    if (report_pages(out, ".", &err) != 0)
        fail_msg("%s", err.text);
    char *text = sample_read(out, "students/ana-garcia.html");
    assert_says(text, "1.5 indices per triangle (fair 1.6, good 1.25)");
    assert_says(text, "1.5 índices por triángulo (aceptable 1.6, buena 1.25)");
    assert_says(text, "<code>strip-2</code>");
    assert_says(text, ">1.31</td>");
    assert_says(text, ">at most<");
    assert_says(text, ">Cases without a limit<");
    free(text);
    size_t length = 0;
    FILE *to = open_memstream(&text, &length);
    struct export_selection selection = {.student = "ana-garcia"};
    assert_non_null(to);
    if (report_export(out, "json", &selection, to, &err) != 0)
        fail_msg("%s", err.text);
    fclose(to);
    assert_says(text, "\"worst\"");
    free(text);
    sample_remove(out);
    json_decref(result);
}

static void the_check_knows_every_key(void **state)
{
    static const char *const needed[] = {"name", "less_is_better", "worst", "bands"};
    (void)state;
    for (size_t i = 0; i < sizeof needed / sizeof *needed; i++) {
        struct error err = {""};
        json_t *result = grade(&less, poor);
        json_t *measures = json_object_get(result, "measures");
        json_object_del(json_object_get(measures, "quality"), needed[i]);
        assert_int_equal(result_check(result, &err), -1);
        assert_says(err.text, needed[i]);
        json_decref(result);
    }
    struct error err = {""};
    json_t *result = grade(&less, poor);
    json_object_del(json_object_get(result, "measures"), "quality");
    assert_int_equal(result_check(result, &err), -1);
    assert_string_equal(err.text, "cases[0].quality: measures.quality, which names it, is missing");
    json_decref(result);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_band_rejects_only_its_class),
        cmocka_unit_test(a_rejection_names_number_and_limit),
        cmocka_unit_test(a_wrong_answer_stays_wrong_and_has_no_quality),
        cmocka_unit_test(what_a_judge_forgot_is_a_fault),
        cmocka_unit_test(a_fault_names_the_exercise),
        cmocka_unit_test(a_poor_answer_keeps_its_points_of_correctness),
        cmocka_unit_test(the_terminal_tells_it),
        cmocka_unit_test(without_a_number_nothing_is_told),
        cmocka_unit_test(the_page_and_the_export_show_it),
        cmocka_unit_test(the_check_knows_every_key)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
