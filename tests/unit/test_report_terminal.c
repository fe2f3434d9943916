/* Results on a terminal: three telling lines, 80 columns, nothing of others that acts. */
#include "graders/report/check.h"
#include "graders/report/terminal.h"

#include "graders/report/clean.h"
#include "tests/unit/report_sample.h"

#include <glob.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static char *print(const json_t *result, struct terminal_style style)
{
    char *text = NULL;
    size_t length = 0;
    FILE *to = open_memstream(&text, &length);
    assert_non_null(to);
    if (json_is_array(result))
        terminal_print_marks(to, result, &style);
    else
        terminal_print_result(to, result, &style);
    fclose(to);
    assert_int_equal(strlen(text), length);
    return text;
}

/* Every line within 80 columns, but for the command that is there to be copied. */
static void assert_fits(const char *text)
{
    char *copy = strdup(text);
    char *rest = copy;
    for (char *line; (line = strsep(&rest, "\n"));) {
        bool is_command = strstr(line, "meshgrade check ") != NULL;
        if (clean_columns(line) > 80 && !is_command)
            fail_msg("%zu columns: %s", clean_columns(line), line);
    }
    free(copy);
}

static void assert_inert(const char *text)
{
    for (const char *c = text; *c; c++)
        assert_true((unsigned char)*c >= 0x20 || *c == '\n');
    assert_null(strstr(text, "\xe2\x80\xae"));
}

static void test_three_lines_say_what_where_and_how(void **state)
{
    (void)state;
    json_t *result = sample_result("ana-garcia", "edge-table-any");
    char *text = print(result, (struct terminal_style){0});
    static const char start[] =
        "✗ Edge (0,17) lies on the boundary and is listed twice, at 41 and 58.\n"
        "  where   edge 41 (0,17), case disc (Open meshes)\n"
        "  again   meshgrade check edge-table-any FILE... --case disc\n\n"
        "4.5 (a) Edge table of any mesh                                           8 / 10\n"
        "  ✓ Closed meshes                          2 of 2 cases                   2 / 2\n"
        "  ✗ Open meshes                            1 of 3 cases                   0 / 2\n";
    if (strncmp(text, start, strlen(start)) != 0)
        fail_msg("got:\n%s", text);
    assert_non_null(strstr(text, "Other rejected cases\n  grid-hole: Edge (12,25)"));
    free(text);

    text = print(result, (struct terminal_style){.language = LANGUAGE_ES});
    assert_non_null(strstr(text, "  dónde   arista 41 (0,17), caso disc (Mallas abiertas)\n"));
    assert_non_null(strstr(text, "Otros casos rechazados\n"));
    free(text);
    json_decref(result);
}

static void set_both(json_t *object, const char *key, const char *en, const char *es)
{
    assert_int_equal(json_object_set_new(object, key, json_pack("{s:s, s:s}", "en", en, "es", es)),
                     0);
}

/* A new exercise brings causes and nouns that nobody here knows. */
static void test_new_causes_and_nouns_read_in_both_languages(void **state)
{
    (void)state;
    json_t *result = sample_result("ana-garcia", "edge-table-any");
    size_t i;
    json_t *one;
    json_object_set_new(result, "cause", json_string("lost-loop"));
    json_array_foreach(json_object_get(result, "cases"), i, one)
    {
        if (strcmp(json_string_value(json_object_get(one, "name")), "disc") != 0)
            continue;
        json_object_set_new(one, "cause", json_string("lost-loop"));
        set_both(one, "cause_name", "lost loop", "falta un bucle");
        set_both(one, "element", "loop 0, side (1,36)", "bucle 0, lado (1,36)");
    }
    char *text = print(result, (struct terminal_style){0});
    assert_non_null(strstr(text, "  where   loop 0, side (1,36), case disc (Open meshes)\n"));
    free(text);
    text = print(result, (struct terminal_style){.language = LANGUAGE_ES});
    assert_non_null(strstr(text, "  dónde   bucle 0, lado (1,36), caso disc (Mallas abiertas)\n"));
    free(text);
    json_decref(result);
}

/* A call on a large input that goes wrong ends growth, work and memory: said once. */
static void test_checks_that_were_not_reached_say_why(void **state)
{
    (void)state;
    static const char why[] = "With the input fan of size 8192: one edge is missing.";
    json_t *result = sample_result("ana-garcia", "edge-table-any");
    size_t i;
    json_t *check;
    json_array_foreach(json_object_get(result, "checks"), i, check)
    {
        json_object_set_new(check, "verdict", json_string("not-reached"));
        json_object_set_new(check, "cause", json_string(i < 3 ? "missing-edge" : "not-reached"));
        set_both(check, "message", i < 3 ? why : "Not looked at.", "No.");
    }
    char *text = print(result, (struct terminal_style){0});
    const char *first = strstr(text, why);
    assert_non_null(first);
    assert_null(strstr(first + 1, why));
    assert_null(strstr(text, "Not looked at."));
    free(text);
    json_decref(result);
}

static void test_a_long_message_is_cut_and_then_told_whole(void **state)
{
    (void)state;
    json_t *result = sample_result("ana-garcia", "edge-table-any");
    size_t i;
    json_t *one;
    char message[401] = "";
    for (int word = 0; word < 40; word++)
        strcat(message, "longwords ");
    json_array_foreach(json_object_get(result, "cases"), i, one)
    {
        json_object_set_new(json_object_get(one, "message"), "en", json_string(message));
    }
    char *text = print(result, (struct terminal_style){0});
    assert_fits(text);
    const char *first_end = strchr(text, '\n');
    assert_int_equal(strncmp(first_end - 3, "...", 3), 0);
    assert_int_equal(strncmp(first_end, "\n  where   edge 41", 18), 0);
    assert_non_null(strstr(text, "\n\n  longwords longwords"));
    free(text);
    json_decref(result);
}

static void test_the_first_sentence_stands_alone(void **state)
{
    (void)state;
    json_t *result = sample_result("ana-garcia", "edge-table-any");
    size_t i;
    json_t *one;
    json_array_foreach(json_object_get(result, "cases"), i, one)
    {
        json_object_set_new(json_object_get(one, "message"), "en",
                            json_string("Edge 3 (1,0) is listed twice. Entries that repeat an "
                                        "earlier one: 6. That is too many."));
    }
    char *text = print(result, (struct terminal_style){0});
    assert_int_equal(strncmp(text, "✗ wrong answer: Edge 3 (1,0) is listed twice.\n  where ", 54),
                     0);
    assert_non_null(strstr(text, "\n\n  Edge 3 (1,0) is listed twice. Entries that"));
    assert_non_null(strstr(text, "  grid-hole: Edge 3 (1,0) is listed twice.\n"));
    free(text);
    json_decref(result);
}

/* Also of a result of an earlier version, whose reasons are plain strings. */
static void test_what_was_not_measured_is_told_in_the_language(void **state)
{
    (void)state;
    json_t *result = sample_result("ana-garcia", "edge-table-any");
    json_object_set_new(result, "not_measured",
                        json_pack("[{s:{s:s, s:s}, s:{s:s, s:s}}, {s:s, s:s}]", "name", "en",
                                  "counts", "es", "cuentas", "reason", "en", "no valgrind", "es",
                                  "falta valgrind", "name", "memcheck", "reason", "none here"));
    assert_int_equal(result_check(result, NULL), 0);
    char *text = print(result, (struct terminal_style){0});
    assert_non_null(strstr(text, "\n  Not measured: counts: no valgrind\n"));
    assert_non_null(strstr(text, "\n  Not measured: memcheck: none here\n"));
    free(text);
    text = print(result, (struct terminal_style){.language = LANGUAGE_ES});
    assert_non_null(strstr(text, "\n  No medido: cuentas: falta valgrind\n"));
    assert_non_null(strstr(text, "\n  No medido: memcheck: none here\n"));
    free(text);
    json_decref(result);
}

static void test_every_verdict_fits_and_is_inert(void **state)
{
    (void)state;
    glob_t found;
    assert_int_equal(glob("tests/unit/data/results/*/*.json", 0, NULL, &found), 0);
    json_t *all = json_array();
    for (size_t i = 0; i < found.gl_pathc; i++) {
        json_t *result = json_load_file(found.gl_pathv[i], JSON_ALLOW_NUL, NULL);
        for (int language = 0; language < LANGUAGE_COUNT; language++) {
            char *text =
                print(result, (struct terminal_style){.language = (enum language)language});
            assert_fits(text);
            assert_inert(text);
            free(text);
        }
        json_array_append_new(all, result);
    }
    globfree(&found);
    char *text = print(all, (struct terminal_style){0});
    assert_fits(text);
    assert_inert(text);
    assert_non_null(strstr(text, "Ana García Ñíguez"));
    assert_non_null(strstr(text, "17.5 + ?"));
    free(text);
    json_decref(all);
}

static void test_colour_only_when_asked_for(void **state)
{
    (void)state;
    json_t *result = sample_result("s5", "edge-table-any");
    char *plain = print(result, (struct terminal_style){0});
    char *coloured = print(result, (struct terminal_style){.colour = true});
    assert_null(strchr(plain, 0x1b));
    assert_non_null(strstr(coloured, "\x1b[1;31m"));
    assert_null(strstr(coloured, "\x1b[2J")); /* what the student wrote */
    assert_null(strstr(coloured, "\x1b]8"));
    free(plain);
    free(coloured);
    json_decref(result);
}

/* Two students who hand in the same result `count` times, as exercises of other names. */
static json_t *make_class(size_t count, bool has_problems)
{
    json_t *all = json_array(), *one = sample_result("s5", "edge-table-any");
    for (size_t i = 0; i < 2 * count; i++) {
        json_t *result = json_deep_copy(one);
        char text[32];
        json_object_set_new(result, "student", json_string(i % 2 ? "Ana" : "Bruno"));
        json_object_set_new(result, "student_folder", json_string(i % 2 ? "ana" : "bruno"));
        snprintf(text, sizeof text, "some-exercise-%02zu", i / 2);
        json_object_set_new(result, "exercise", json_string(text));
        snprintf(text, sizeof text, "%zu.%zu (a)", 4 + i / 40, i / 2 % 20 + 1);
        json_object_set_new(result, "problem", json_string(has_problems ? text : ""));
        json_object_set_new(result, "score", json_real(8.25));
        json_object_set_new(result, "verdict", json_string("wrong-answer"));
        json_array_append_new(all, result);
    }
    json_decref(one);
    return all;
}

static size_t count_of(const char *text, const char *what)
{
    size_t count = 0;
    for (const char *at = text; (at = strstr(at, what)); at += strlen(what))
        count++;
    return count;
}

static void assert_table(size_t count, bool has_problems, enum language language)
{
    char total[32];
    json_t *all = make_class(count, has_problems);
    char *text = print(all, (struct terminal_style){.language = language});
    assert_fits(text);
    assert_int_equal(count_of(text, "◐ 8.25"), 2 * count);
    size_t blocks = (count + 6) / 7;
    assert_int_equal(count_of(text, "\nAna  "), blocks);
    assert_int_equal(count_of(text, " total\n"), 1);
    snprintf(total, sizeof total, " %.15g\n", 8.25 * (double)count);
    assert_int_equal(count_of(text, total), 2);
    for (size_t e = 0; e < count && !has_problems && count > 3; e++) {
        char name[32];
        snprintf(name, sizeof name, "#%zu some-exercise-%02zu", e + 1, e);
        assert_int_equal(count_of(text, name), 1);
    }
    free(text);
    json_decref(all);
}

static void test_the_table_of_marks_fits_up_to_80_exercises(void **state)
{
    (void)state;
    for (size_t count = 1; count <= 80; count++) {
        assert_table(count, true, LANGUAGE_EN);
        assert_table(count, false, LANGUAGE_ES);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_three_lines_say_what_where_and_how),
        cmocka_unit_test(test_new_causes_and_nouns_read_in_both_languages),
        cmocka_unit_test(test_checks_that_were_not_reached_say_why),
        cmocka_unit_test(test_a_long_message_is_cut_and_then_told_whole),
        cmocka_unit_test(test_the_first_sentence_stands_alone),
        cmocka_unit_test(test_what_was_not_measured_is_told_in_the_language),
        cmocka_unit_test(test_every_verdict_fits_and_is_inert),
        cmocka_unit_test(test_colour_only_when_asked_for),
        cmocka_unit_test(test_the_table_of_marks_fits_up_to_80_exercises),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
