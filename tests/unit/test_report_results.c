/* Reading a class's results: sound ones become a table, others are refused with name and remedy. */
#include "graders/report/results.h"

#include "graders/report/causes.h"
#include "graders/report/documents.h"
#include "tests/unit/report_sample.h"

#include <sys/stat.h>
#include <unistd.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void test_the_table(void **state)
{
    (void)state;
    struct gradebook book;
    assert_int_equal(gradebook_load("tests/unit/data", &book, NULL), 0);
    assert_int_equal(book.student_count, 8);
    assert_int_equal(book.exercise_count, 3);
    assert_string_equal(book.exercises[0].name, "memory-strips"); /* 4.3, 4.5 (a), 4.6 */
    assert_string_equal(book.exercises[1].name, "edge-table-any");
    assert_string_equal(book.exercises[2].name, "mesh-area");
    assert_true(book.max_score > 29.9 && book.max_score < 30.1);
    int unscored = 0;
    size_t absent = 0;
    for (size_t s = 0; s < book.student_count; s++) {
        unscored += book.students[s].unscored;
        for (size_t e = 0; e < book.exercise_count; e++)
            absent += book.students[s].results[e] == NULL;
        if (strcmp(book.students[s].folder, "ana-garcia") == 0)
            assert_true(book.students[s].score > 27.99 && book.students[s].score < 28.01);
    }
    assert_int_equal(unscored, 2);
    assert_int_equal(absent, 2);
    gradebook_release(&book);
}

static void refuse(const char *out, const char *says)
{
    struct error err = {""};
    struct gradebook book;
    assert_int_equal(gradebook_load(out, &book, &err), -1);
    if (!strstr(err.text, says))
        fail_msg("expected \"%s\" in: %s", says, err.text);
}

static void write_bytes(const char *path, const char *bytes, size_t length)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, length, file), length);
    fclose(file);
}

static void test_corrupt_files_are_refused_by_name(void **state)
{
    (void)state;
    char out[64];
    char path[200];
    sample_copy(out);
    snprintf(path, sizeof path, "%s/results/ana-garcia/mesh-area.json", out);
    write_bytes(path, "{\"schema\": \"meshgr", 18);
    refuse(out, "results/ana-garcia/mesh-area.json");
    refuse(out, "run `meshgrade grade` again");
    write_bytes(path, "{\"a\": 1, \"a\": 2}", 16);
    refuse(out, "duplicate");
    write_bytes(path, "{\"a\": \"\xff\"}", 10);
    refuse(out, "unable to decode byte 0xff");
    write_bytes(path, "[]", 2);
    refuse(out, "expected an object");

    unlink(path);
    assert_int_equal(symlink("/etc/passwd", path), 0);
    refuse(out, "symbolic link");
    unlink(path);
    assert_int_equal(mkfifo(path, 0600), 0);
    refuse(out, "not a regular file");
    unlink(path);
    write_bytes(path, "", 0);
    assert_int_equal(truncate(path, (off_t)DOCUMENT_JSON_LIMIT_BYTES + 1), 0);
    refuse(out, "more than the");
    sample_remove(out);
}

static void test_a_result_must_stand_where_it_says(void **state)
{
    (void)state;
    char out[64];
    char from[200];
    char to[200];
    sample_copy(out);
    snprintf(from, sizeof from, "%s/results/ana-garcia/mesh-area.json", out);
    snprintf(to, sizeof to, "%s/results/ulises_ortega/mesh-area.json", out);
    assert_int_equal(rename(from, to), 0);
    refuse(out, "is the result of ana-garcia/mesh-area.json");
    sample_remove(out);
}

static void test_a_class_without_results_is_an_error(void **state)
{
    (void)state;
    refuse("/tmp/meshgrade-no-such-folder", "holds no results");
}

static void test_different_maximum_scores_are_refused(void **state)
{
    (void)state;
    char out[64];
    sample_copy(out);
    json_t *result = sample_result("ana-garcia", "mesh-area");
    json_object_set_new(result, "max_score", json_integer(12));
    sample_store(out, result);
    json_decref(result);
    refuse(out, "not the same as in other results");
    sample_remove(out);
}

static void test_writing_is_atomic_and_only_when_needed(void **state)
{
    (void)state;
    char out[64];
    char path[200];
    struct stat before;
    struct stat after;
    sample_copy(out);
    snprintf(path, sizeof path, "%s/new.txt", out);
    assert_int_equal(document_write(path, "abc", 3, NULL), 0);
    assert_int_equal(stat(path, &before), 0);
    assert_int_equal(document_write(path, "abc", 3, NULL), 0);
    assert_int_equal(stat(path, &after), 0);
    assert_int_equal(before.st_ino, after.st_ino); /* left alone */
    assert_int_equal(document_write(path, "abd", 3, NULL), 0);
    assert_int_equal(stat(path, &after), 0);
    assert_int_not_equal(before.st_ino, after.st_ino); /* a new file in its place */
    assert_int_equal(after.st_mode & 0777, 0644);
    char *text = sample_read(out, "new.txt");
    assert_string_equal(text, "abd");
    free(text);
    struct error err = {""};
    assert_int_equal(document_write("/tmp/meshgrade-no-such-folder/x", "", 0, &err), -1);
    assert_non_null(strstr(err.text, "/tmp/meshgrade-no-such-folder/x"));
    sample_remove(out);
}

static void test_safe_names(void **state)
{
    (void)state;
    static const char *const safe[] = {"a", "edge-table-any", "A.b_c-9", "zoe.obrien"};
    static const char *const unsafe[] = {"",    ".",   "..", ".x",  "-x",
                                         "a/b", "a b", "é",  "a\n", "a:b"};
    char long_name[200];
    memset(long_name, 'a', sizeof long_name);
    long_name[129] = '\0';
    for (size_t i = 0; i < sizeof safe / sizeof *safe; i++)
        assert_true(document_is_safe_name(safe[i]));
    for (size_t i = 0; i < sizeof unsafe / sizeof *unsafe; i++)
        assert_false(document_is_safe_name(unsafe[i]));
    assert_false(document_is_safe_name(long_name));
}

static void test_cases_that_were_not_run_are_no_failures(void **state)
{
    (void)state;
    struct message tally;
    json_t *result = sample_result("ana-garcia", "edge-table-any");
    const json_t *classes = json_object_get(result, "classes");
    const json_t *closed = json_array_get(classes, 0), *open = json_array_get(classes, 1);
    result_class_tally(result, closed, &tally);
    assert_string_equal(tally.en, "2 of 2");
    assert_int_equal(result_class_standing(result, closed), STANDING_PASSED);
    assert_int_equal(result_class_standing(result, open), STANDING_FAILED);

    sample_leave_out(result, "closed", 2);
    sample_leave_out(result, "open", 1);
    result_class_tally(result, closed, &tally);
    assert_string_equal(tally.en, "not run");
    assert_string_equal(tally.es, "sin ejecutar");
    assert_int_equal(result_class_standing(result, closed), STANDING_ABSENT);
    result_class_tally(result, open, &tally);
    assert_string_equal(tally.en, "0 of 2, 1 not run");
    assert_int_equal(result_class_standing(result, open), STANDING_FAILED);
    assert_int_equal(result_not_run(result, NULL).count, 3);
    assert_string_equal(result_not_run(result, "open").reason.en, "Two cases did not end in time.");
    json_decref(result);
}

/* A result whose first rejected case says `message`. */
static json_t *with_message(const char *folder, const char *message)
{
    json_t *result = sample_result("ana-garcia", "edge-table-any");
    json_object_set_new(result, "student_folder", json_string(folder));
    size_t i;
    json_t *one;
    json_array_foreach(json_object_get(result, "cases"), i, one)
    {
        if (strcmp(result_text(one, "verdict"), "wrong-answer") != 0)
            continue;
        json_object_set_new(one, "cause", json_string("duplicate-edge"));
        json_object_set_new(one, "message", json_pack("{s:s, s:s}", "en", message, "es", message));
        message = "Edge (1,2) is listed twice."; /* the others of the student tell less */
    }
    return result;
}

static void test_a_hint_is_told_only_of_those_who_got_it(void **state)
{
    (void)state;
    json_t *all = json_array();
    struct gradebook book;
    struct causes causes;
    json_array_append_new(all, with_message("a", "Edge (0,1) twice. As (i,j) and (j,i): 6 times."));
    json_array_append_new(all,
                          with_message("b", "Edge (7,3) twice. As (i,j) and (j,i): 17 times."));
    json_array_append_new(all, with_message("c", "Edge (0,1) twice. A neighbour added it."));
    assert_int_equal(gradebook_from(all, &book, NULL), 0);
    assert_int_equal(causes_of(&book, 0, &causes, NULL), 0);
    assert_int_equal(causes.count, 2);
    assert_int_equal(causes.list[0].student_count, 2);
    assert_non_null(strstr(causes.list[0].example.en, "(j,i)"));
    assert_false(causes_touch(&causes, &causes.list[0], 2));
    assert_int_equal(causes.list[1].student_count, 1);
    assert_true(causes_touch(&causes, &causes.list[1], 2));
    causes_release(&causes);
    gradebook_release(&book);
    json_decref(all);
}

static void test_texts_of_a_result_are_read_in_both_languages(void **state)
{
    (void)state;
    char room[80];
    json_t *now = json_pack("{s:s, s:{s:s, s:s}, s:{s:s, s:s}}", "cause", "lost-loop", "cause_name",
                            "en", "lost loop", "es", "falta un bucle", "element", "en",
                            "loop 0, side (1,36)", "es", "bucle 0, lado (1,36)");
    json_t *earlier = json_pack("{s:s, s:s}", "cause", "missing-edge", "element", "edge {0,2}");
    assert_string_equal(words_cause(now, room, sizeof room).en, "lost loop");
    assert_string_equal(words_cause(now, room, sizeof room).es, "falta un bucle");
    assert_string_equal(words_in(now, "element").es, "bucle 0, lado (1,36)");
    assert_string_equal(words_cause(earlier, room, sizeof room).en, "missing edge");
    assert_string_equal(words_cause(earlier, room, sizeof room).es, "missing edge");
    assert_string_equal(words_cause(earlier, room, 8).es, "missing");
    assert_string_equal(words_in(earlier, "element").es, "edge {0,2}");
    assert_string_equal(words_cause(NULL, room, sizeof room).en, "");
    json_decref(now);
    json_decref(earlier);
}

static void assert_bytes(double bytes, const char *expected)
{
    char text[40];
    words_of_bytes(bytes, text, sizeof text);
    assert_string_equal(text, expected);
}

static void test_bytes_have_the_units_of_the_course(void **state)
{
    (void)state;
    assert_bytes(0, "0 bytes");
    assert_bytes(1, "1 byte");
    assert_bytes(3375, "3375 bytes");
    assert_bytes(65536, "64.0 KB");
    assert_bytes(993344, "970 KB");
    assert_bytes(104857600, "100 MB");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_table),
        cmocka_unit_test(test_corrupt_files_are_refused_by_name),
        cmocka_unit_test(test_a_result_must_stand_where_it_says),
        cmocka_unit_test(test_a_class_without_results_is_an_error),
        cmocka_unit_test(test_different_maximum_scores_are_refused),
        cmocka_unit_test(test_cases_that_were_not_run_are_no_failures),
        cmocka_unit_test(test_a_hint_is_told_only_of_those_who_got_it),
        cmocka_unit_test(test_texts_of_a_result_are_read_in_both_languages),
        cmocka_unit_test(test_bytes_have_the_units_of_the_course),
        cmocka_unit_test(test_writing_is_atomic_and_only_when_needed),
        cmocka_unit_test(test_safe_names),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
