/* Each exporter's file is read back, with the hostile names and texts of the sample class in it. */
#include "graders/report/report.h"

#include "tests/unit/report_sample.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static char *export(const char *out, const char *format, const char *student, struct error *err)
{
    struct export_selection selection = {.student = student};
    char *text = NULL;
    size_t length = 0;
    FILE *to = open_memstream(&text, &length);
    assert_non_null(to);
    int status = report_export(out, format, &selection, to, err);
    fclose(to);
    if (status == 0) {
        assert_int_equal(strlen(text), length); /* no NUL in any format */
        return text;
    }
    free(text);
    return NULL;
}

static char *export_sample(const char *format, const char *student)
{
    struct error err = {""};
    char *text = export("tests/unit/data", format, student, &err);
    if (!text)
        fail_msg("%s: %s", format, err.text);
    return text;
}

/* No control character but the line's end, no bidi override, in any format. */
static void assert_inert(const char *text)
{
    for (const char *c = text; *c; c++)
        assert_true((unsigned char)*c >= 0x20 || *c == '\n' || *c == '\r');
    assert_null(strstr(text, "\xe2\x80\xae"));
    assert_null(strstr(text, "\xc2\x9b"));
}

/* ---------------------------------------------------------------- CSV */

/* Takes one field off a CSV text as RFC 4180 says; *end is ',' or '\r'. */
static char *take_field(const char **at, char *end)
{
    char *field = calloc(strlen(*at) + 1, 1);
    assert_non_null(field);
    char *to = field;
    const char *c = *at;
    if (*c == '"') {
        for (c++; *c != '"' || c[1] == '"'; c++) {
            assert_true(*c != '\0');
            c += *c == '"';
            *to++ = *c;
        }
        c++;
    } else {
        while (*c != ',' && *c != '\r') {
            assert_true(*c != '\0' && *c != '"' && *c != '\n');
            *to++ = *c++;
        }
    }
    *end = *c;
    assert_true(*c == ',' || (*c == '\r' && c[1] == '\n'));
    *at = c + (*c == ',' ? 1 : 2);
    return field;
}

static void test_csv_reads_back(void **state)
{
    (void)state;
    char *text = export_sample("csv", NULL);
    assert_inert(text);
    assert_int_equal(strncmp(text, "student,memory-strips,edge-table-any,mesh-area,total\r\n", 54),
                     0);
    const char *at = text;
    int rows = 0;
    bool saw_ana = false;
    bool saw_formula = false;
    bool saw_unscored = false;
    while (*at) {
        char end = ',';
        char *row[5] = {0};
        for (int i = 0; i < 5; i++)
            row[i] = take_field(&at, &end);
        assert_int_equal(end, '\r');
        for (int i = 0; i < 5; i++)
            assert_true(row[i][0] == '\0' || !strchr("=+-@\t\r", row[i][0]));
        saw_formula |= strncmp(row[0], "'=HYPERLINK(", 12) == 0;
        if (strcmp(row[0], "Ana García Ñíguez") == 0) {
            saw_ana = true;
            assert_string_equal(row[2], "8");
            assert_string_equal(row[4], "28");
        }
        if (strcmp(row[0], "Zoë O'Brien-Müller") == 0) {
            saw_unscored = true;
            assert_string_equal(row[2], ""); /* a fault gives no mark and takes none */
            assert_string_equal(row[4], "");
        }
        for (int i = 0; i < 5; i++)
            free(row[i]);
        rows++;
    }
    assert_int_equal(rows, 9);
    assert_true(saw_ana && saw_formula && saw_unscored);
    free(text);
}

/* Names that a spreadsheet would compute. */
static void test_csv_neutralises_formulas(void **state)
{
    (void)state;
    static const char *const names[] = {"=1+1", "+1",   "-1",  "@SUM(A1)",           "\t=1",
                                        "\r=1", "  =1", "＝1", "\n=cmd|'/c calc'!A1"};
    char out[64];
    sample_copy(out);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        json_t *result = sample_result("ulises_ortega", "memory-strips");
        json_object_set_new(result, "student", json_string(names[i]));
        sample_store(out, result);
        json_decref(result);
        char *text = export(out, "csv", "ulises_ortega", NULL);
        assert_non_null(text);
        const char *row = strstr(text, "\r\n") + 2;
        assert_int_equal(strncmp(row, "\"'", 2), 0);
        free(text);
    }
    sample_remove(out);
}

/* ---------------------------------------------------------------- Gradescope */

static void check_gradescope(const json_t *results)
{
    size_t i;
    json_t *test;
    assert_true(json_is_number(json_object_get(results, "score")));
    assert_string_equal(json_string_value(json_object_get(results, "output_format")), "text");
    json_array_foreach(json_object_get(results, "tests"), i, test)
    {
        assert_true(json_is_string(json_object_get(test, "name")));
        assert_true(json_is_string(json_object_get(test, "output")));
        assert_inert(json_string_value(json_object_get(test, "output")));
        assert_true(json_is_number(json_object_get(test, "max_score")));
        const json_t *score = json_object_get(test, "score");
        assert_true(!score || json_number_value(score) <=
                                  json_number_value(json_object_get(test, "max_score")));
        assert_string_equal(json_string_value(json_object_get(test, "output_format")), "text");
    }
}

static void test_gradescope_reads_back(void **state)
{
    (void)state;
    char *text = export_sample("gradescope", NULL);
    json_t *all = json_loads(text, JSON_REJECT_DUPLICATES, NULL);
    assert_int_equal(json_object_size(all), 8);
    const char *student;
    json_t *results;
    json_object_foreach(all, student, results)
    {
        assert_inert(student);
        check_gradescope(results);
    }
    json_decref(all);
    free(text);

    text = export_sample("gradescope", "Ana García Ñíguez");
    json_t *ana = json_loads(text, 0, NULL);
    check_gradescope(ana);
    assert_true(json_number_value(json_object_get(ana, "score")) == 28);
    assert_string_equal(json_string_value(json_object_get(ana, "visibility")), "visible");
    assert_int_equal(json_array_size(json_object_get(ana, "tests")), 3 + 4 + 3 + 3 * 5);
    json_decref(ana);
    free(text);

    text = export_sample("gradescope", "zoe.obrien"); /* one fault: the total waits for a person */
    json_t *zoe = json_loads(text, 0, NULL);
    assert_string_equal(json_string_value(json_object_get(zoe, "visibility")), "hidden");
    json_decref(zoe);
    free(text);
}

static void test_equal_names_stay_apart(void **state)
{
    (void)state;
    char out[64];
    struct error err = {""};
    sample_copy(out);
    static const char *const exercises[] = {"memory-strips", "edge-table-any", "mesh-area"};
    for (size_t i = 0; i < 3; i++) {
        json_t *result = sample_result("bruno-conti", exercises[i]);
        json_object_set_new(result, "student", json_string("Ana García Ñíguez"));
        sample_store(out, result);
        json_decref(result);
    }
    char *text = export(out, "gradescope", NULL, &err);
    json_t *all = json_loads(text, JSON_REJECT_DUPLICATES, NULL);
    assert_int_equal(json_object_size(all), 8);
    json_decref(all);
    free(text);
    assert_null(export(out, "vpl", "Ana García Ñíguez", &err));
    assert_non_null(strstr(err.text, "several students"));
    text = export(out, "vpl", "bruno-conti", NULL);
    assert_non_null(text);
    free(text);
    sample_remove(out);
}

/* ---------------------------------------------------------------- VPL */

/* Reads as VPL might: every line that holds the tag, wherever. */
static void check_vpl(const char *text, int grades_expected)
{
    int grades = 0;
    bool in_block = false;
    char *copy = strdup(text);
    char *rest = copy;
    for (char *line; (line = strsep(&rest, "\n")) && (*line || rest);) {
        if (strcmp(line, "<|--") == 0 || strcmp(line, "--|>") == 0) {
            in_block = *line == '<';
            continue;
        }
        if (in_block) {
            assert_true(*line == '>' || *line == '-');
            assert_null(strstr(line, ":=>>"));
            assert_null(strstr(line, "--|>"));
            continue;
        }
        assert_true(strncmp(line, "Grade :=>> ", 11) == 0 ||
                    strncmp(line, "Comment :=>> ", 13) == 0);
        grades += *line == 'G';
        assert_true(*line != 'G' || !rest || !*rest); /* the last line */
    }
    assert_int_equal(grades, grades_expected);
    free(copy);
}

static void test_vpl_grades_cannot_be_forged(void **state)
{
    (void)state;
    char *text = export_sample("vpl", "s4");
    assert_inert(text);
    assert_non_null(strstr(text, ">Grade : =>> 100\n")); /* the forger's line, inert */
    assert_non_null(strstr(text, "\nGrade :=>> 24.5\n"));
    check_vpl(text, 1);
    free(text);
    text = export_sample("vpl", "s5"); /* flagged: no grade at all */
    check_vpl(text, 0);
    free(text);
    struct error err = {""};
    assert_null(export("tests/unit/data", "vpl", NULL, &err));
    assert_non_null(strstr(err.text, "--student"));
}

/* ---------------------------------------------------------------- the others */

static size_t occurrences(const char *text, const char *part)
{
    size_t count = 0;
    for (const char *at = text; (at = strstr(at, part)); at += strlen(part))
        count++;
    return count;
}

/* That it is XML is checked by python's parser in tests/cli/pages.t. */
static void test_junit_says_what_failed(void **state)
{
    (void)state;
    char *text = export_sample("junit", NULL);
    assert_inert(text);
    assert_int_equal(occurrences(text, "<testsuite "), 22);
    assert_int_equal(occurrences(text, "<error "), 1); /* one fault */
    assert_true(occurrences(text, "<failure ") >= 20);
    assert_null(strstr(text, "]]>"));
    assert_null(strstr(text, "<script"));
    assert_non_null(strstr(text, "type=\"wrong-answer\""));
    free(text);
}

static void test_json_is_what_was_read(void **state)
{
    (void)state;
    char *text = export_sample("json", "ana-garcia");
    json_t *all = json_loads(text, JSON_ALLOW_NUL, NULL);
    assert_int_equal(json_array_size(all), 3);
    json_t *result = sample_result("ana-garcia", "edge-table-any");
    assert_true(json_equal(json_array_get(all, 1), result));
    json_decref(result);
    json_decref(all);
    free(text);
}

static void test_a_megabyte_of_output_is_bounded(void **state)
{
    (void)state;
    enum { LENGTH = 1 << 20 };
    static const char *const formats[] = {"csv", "gradescope", "junit", "vpl"};
    char out[64];
    char *line = malloc(LENGTH + 1);
    assert_non_null(line);
    memset(line, 'G', LENGTH);
    line[LENGTH] = '\0';
    sample_copy(out);
    json_t *result = sample_result("ulises_ortega", "memory-strips");
    json_object_set_new(result, "output", json_string(line));
    json_object_set_new(result, "student", json_string(line));
    json_object_set_new(json_object_get(result, "build"), "diagnostics", json_string(line));
    json_object_set_new(json_object_get(result, "summary"), "en", json_string(line));
    sample_store(out, result);
    json_decref(result);
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        char *text = export(out, formats[i], "ulises_ortega", NULL);
        assert_non_null(text);
        assert_true(strlen(text) < 200000);
        free(text);
    }
    sample_remove(out);
    free(line);
}

static void test_unknown_formats_and_students(void **state)
{
    (void)state;
    struct error err = {""};
    assert_null(export("tests/unit/data", "pdf", NULL, &err));
    assert_non_null(strstr(err.text, "csv, gradescope"));
    err.text[0] = '\0';
    assert_null(export("tests/unit/data", "csv", "nobody\x1b[2J", &err));
    assert_non_null(strstr(err.text, "no student is named \"nobody\\x1b[2J\""));
}

static void test_grades_are_left_in_the_folder(void **state)
{
    (void)state;
    char out[64];
    sample_copy(out);
    assert_int_equal(report_grades(out, NULL), 0);
    char *file = sample_read(out, "grades.csv");
    char *text = export_sample("csv", NULL);
    assert_string_equal(file, text);
    free(file);
    free(text);
    sample_remove(out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_csv_reads_back),
        cmocka_unit_test(test_csv_neutralises_formulas),
        cmocka_unit_test(test_gradescope_reads_back),
        cmocka_unit_test(test_equal_names_stay_apart),
        cmocka_unit_test(test_vpl_grades_cannot_be_forged),
        cmocka_unit_test(test_junit_says_what_failed),
        cmocka_unit_test(test_json_is_what_was_read),
        cmocka_unit_test(test_a_megabyte_of_output_is_bounded),
        cmocka_unit_test(test_unknown_formats_and_students),
        cmocka_unit_test(test_grades_are_left_in_the_folder),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
