/* A stamp holds as long as nothing changes that a verdict depends on, and not a byte longer. */
#include "graders/engine/base/files.h"
#include "graders/known/stamps.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static char root[PATH_MAX];
static struct exercise exercise = {.name = "made", .group = "edges"};

static void put(const char *name, const char *text)
{
    char path[2 * PATH_MAX];
    struct error err = {""};
    snprintf(path, sizeof path, "%s/%s", root, name);
    *strrchr(path, '/') = '\0';
    assert_int_equal(folder_make(path, &err), 0);
    snprintf(path, sizeof path, "%s/%s", root, name);
    assert_int_equal(file_write(path, text, strlen(text), &err), 0);
}

static int make_root(void **state)
{
    struct error err = {""};
    (void)state;
    if (folder_make_work(root, &err) != 0)
        return -1;
    put("reference/answers/edges/made.c", "the answer");
    put("exercises/models/ball.ply", "a ball");
    put("exercises/edges/made/made.h", "the header");
    put("exercises/edges/made/README.md", "the statement");
    put("build/runner/edges/made.plain.o", "a runner");
    put("build/runner/edges/made.sanitized.o", "a runner");
    put("build/runner/edges/made.checked.o", "a runner");
    int length = snprintf(exercise.folder, sizeof exercise.folder, "%s/exercises/edges/made", root);
    return length < (int)sizeof exercise.folder ? 0 : -1;
}

static int remove_root(void **state)
{
    (void)state;
    folder_remove_work(root);
    return 0;
}

static char file[] = "wrong/a.c", stored[] = "wrong/a.change", text[] = "int a;";
static const struct known_submission submission = {
    .file = file, .stored = stored, .text = text, .count = sizeof text - 1};

static struct stamps open_stamps(uint32_t seed, const char *machine)
{
    struct stamps stamps;
    struct error err = {""};
    char key[STAMP_KEY];
    snprintf(key, sizeof key, "%s", machine);
    if (stamps_open(root, &exercise, seed, key, &stamps, &err) != 0)
        fail_msg("%s", err.text);
    return stamps;
}

static bool holds(const struct stamps *stamps, const struct known_submission *asked)
{
    char found[STAMP_TEXT];
    return stamps_hold(stamps, asked, found);
}

static void a_stamp_holds(void **state)
{
    struct error err = {""};
    char found[STAMP_TEXT] = "";
    (void)state;
    struct stamps stamps = open_stamps(1, "m");
    assert_false(holds(&stamps, &submission));
    assert_int_equal(stamps_put(&stamps, &submission, "open,closed", &err), 0);
    struct stamps again = open_stamps(1, "m");
    assert_true(stamps_hold(&again, &submission, found));
    assert_string_equal(found, "open,closed");
    assert_int_equal(stamps_put(&stamps, &submission, "", &err), 0);
    assert_true(stamps_hold(&again, &submission, found));
    assert_string_equal(found, "");
}

static void each_change_breaks_it(void **state)
{
    static const char *const files[] = {"reference/answers/edges/made.c",
                                        "exercises/models/ball.ply",
                                        "exercises/models/new.ply",
                                        "exercises/edges/made/made.h",
                                        "exercises/edges/made/new.c",
                                        "build/runner/edges/made.plain.o",
                                        "build/runner/edges/made.sanitized.o",
                                        "build/runner/edges/made.checked.o"};
    struct error err = {""};
    (void)state;
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct stamps before = open_stamps(1, "m");
        assert_int_equal(stamps_put(&before, &submission, "", &err), 0);
        put(files[i], "changed");
        struct stamps after = open_stamps(1, "m");
        if (holds(&after, &submission))
            fail_msg("a stamp outlives a change of %s", files[i]);
    }
}

static void a_statement_may_change(void **state)
{
    struct error err = {""};
    (void)state;
    struct stamps before = open_stamps(1, "m");
    assert_int_equal(stamps_put(&before, &submission, "", &err), 0);
    put("exercises/edges/made/README.md", "a better statement");
    struct stamps after = open_stamps(1, "m");
    assert_true(holds(&after, &submission));
}

static void seed_machine_and_submission_belong_to_it(void **state)
{
    struct error err = {""};
    char other_file[] = "right/a.c", other_text[] = "int b;";
    (void)state;
    struct stamps stamps = open_stamps(1, "m"), seed = open_stamps(2, "m"),
                  machine = open_stamps(1, "n");
    assert_int_equal(stamps_put(&stamps, &submission, "", &err), 0);
    assert_true(holds(&stamps, &submission));
    assert_false(holds(&seed, &submission));
    assert_false(holds(&machine, &submission));
    struct known_submission other = submission;
    other.text = other_text;
    assert_false(holds(&stamps, &other));
    other = submission;
    other.file = other_file;
    assert_false(holds(&stamps, &other));
    stamps_remove(&stamps, &submission);
    assert_false(holds(&stamps, &submission));
}

static void a_damaged_stamp_does_not_hold(void **state)
{
    static const char *const texts[] = {"", "\n", "0123456789\n", "as before\n"};
    struct error err = {""};
    char path[2 * PATH_MAX], *bytes;
    size_t count;
    (void)state;
    struct stamps stamps = open_stamps(1, "m");
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        put("build/validated/made/wrong/a.c", texts[i]);
        assert_false(holds(&stamps, &submission));
    }
    assert_int_equal(stamps_put(&stamps, &submission, "open", &err), 0);
    snprintf(path, sizeof path, "%s/build/validated/made/wrong/a.c", root);
    assert_int_equal(file_read(path, 1000, &bytes, &count, &err), 0);
    bytes[count - 1] = '\0'; /* cut short */
    put("build/validated/made/wrong/a.c", bytes);
    free(bytes);
    assert_false(holds(&stamps, &submission));
}

static void what_cannot_be_read_is_an_error(void **state)
{
    struct stamps stamps;
    struct error err = {""};
    char path[2 * PATH_MAX];
    static const char key[STAMP_KEY] = "m";
    (void)state;
    snprintf(path, sizeof path, "%s/build/runner", root);
    folder_remove(path);
    assert_int_equal(stamps_open(root, &exercise, 1, key, &stamps, &err), -1);
    assert_true(strstr(err.text, "made.plain.o") != NULL);
}

static void this_program_and_machine_have_a_key(void **state)
{
    struct error err = {""};
    char first[STAMP_KEY], second[STAMP_KEY];
    (void)state;
    if (stamps_machine(first, &err) != 0)
        skip(); /* not Debian */
    assert_int_equal(stamps_machine(second, &err), 0);
    assert_string_equal(first, second);
    assert_int_equal(strlen(first), STAMP_KEY - 1);
    setenv("PATH", "/nonexistent", 1);
    assert_int_equal(stamps_machine(second, &err), 0);
    assert_string_not_equal(first, second);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_stamp_holds, make_root, remove_root),
        cmocka_unit_test_setup_teardown(each_change_breaks_it, make_root, remove_root),
        cmocka_unit_test_setup_teardown(a_statement_may_change, make_root, remove_root),
        cmocka_unit_test_setup_teardown(seed_machine_and_submission_belong_to_it, make_root,
                                        remove_root),
        cmocka_unit_test_setup_teardown(a_damaged_stamp_does_not_hold, make_root, remove_root),
        cmocka_unit_test_setup_teardown(what_cannot_be_read_is_an_error, make_root, remove_root),
        cmocka_unit_test(this_program_and_machine_have_a_key)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
