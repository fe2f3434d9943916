/* Reading a class's results: sound ones become a table, others are refused with name and remedy. */
#include "graders/report/results.h"

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_table),
        cmocka_unit_test(test_corrupt_files_are_refused_by_name),
        cmocka_unit_test(test_a_result_must_stand_where_it_says),
        cmocka_unit_test(test_a_class_without_results_is_an_error),
        cmocka_unit_test(test_different_maximum_scores_are_refused),
        cmocka_unit_test(test_writing_is_atomic_and_only_when_needed),
        cmocka_unit_test(test_safe_names),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
