/* Known-verdict submissions: changes are applied exactly or refused in a line that says what to do,
 * and a folder of them is read whole. */
#include "graders/engine/base/files.h"
#include "graders/engine/run/trial.h"
#include "graders/known/change.h"
#include "graders/known/submissions.h"

#include <limits.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* ------------------------------------------------------------------ changes */

static const char base[] = "/* A base\n * of two lines. */\n"
                           "#include <a.h>\n"
                           "\n"
                           "int first(void)\n"
                           "{\n"
                           "    return 1;\n"
                           "}\n"
                           "\n"
                           "int second(void)\n"
                           "{\n"
                           "    return 2;\n"
                           "}\n";

static int apply(const char *change, char **text, struct error *err)
{
    size_t count;
    struct change_text changed = {"x.change", change, strlen(change)};
    struct change_text whole = {"right/base.c", base, strlen(base)};
    int result = change_apply(&changed, &whole, text, &count, err);
    if (result == 0)
        assert_int_equal(count, strlen(*text));
    return result;
}

static void assert_makes(const char *change, const char *expected)
{
    struct error err = {""};
    char *text = NULL;
    if (apply(change, &text, &err) != 0)
        fail_msg("%s", err.text);
    assert_string_equal(text, expected);
    free(text);
}

static void assert_refused(const char *change, const char *expected)
{
    struct error err = {""};
    char *text = NULL;
    assert_int_equal(apply(change, &text, &err), -1);
    assert_null(text);
    assert_string_equal(err.text, expected);
}

static void a_line_is_replaced(void **state)
{
    (void)state;
    assert_makes("/* New. */\n-    return 2;\n+    return 3;\n",
                 "/* New. */\n#include <a.h>\n\nint first(void)\n{\n    return 1;\n}\n\n"
                 "int second(void)\n{\n    return 3;\n}\n");
}

static void places_are_changed_in_order(void **state)
{
    (void)state;
    assert_makes("/* New,\n * of: right/base.c */\n #include <a.h>\n+#include <b.h>\n\n"
                 "@@\n-    return 1;\n@@\n int second(void)\n {\n+    first();\n     return 2;",
                 "/* New,\n * of: right/base.c */\n#include <a.h>\n#include <b.h>\n\n"
                 "int first(void)\n{\n}\n\n"
                 "int second(void)\n{\n    first();\n    return 2;\n}\n");
}

static void lines_that_stand_twice_are_refused(void **state)
{
    (void)state;
    assert_refused("/* New. */\n {\n+    ;\n",
                   "x.change:2: these lines stand more than once in right/base.c; add lines before "
                   "or after them");
}

static void lines_that_are_not_there_are_refused(void **state)
{
    (void)state;
    assert_refused("/* New. */\n int second(void)\n {\n-    return 1;\n+    return 3;\n",
                   "x.change:4: \"    return 1;\" does not stand there in right/base.c; copy the "
                   "lines as they are");
    assert_refused("/* New. */\n-int third(void)\n",
                   "x.change:2: \"int third(void)\" does not stand there in right/base.c; copy the "
                   "lines as they are");
    assert_refused("/* New. */\n-    return 2; \n",
                   "x.change:2: \"    return 2; \" does not stand there in right/base.c; copy the "
                   "lines as they are");
}

static void the_order_of_the_base_is_kept(void **state)
{
    (void)state;
    assert_refused("/* New. */\n-    return 2;\n@@\n-    return 1;\n",
                   "x.change:4: stands in right/base.c before the place above; keep the base's "
                   "order, and make one of two places that touch");
    assert_refused("/* New. */\n int first(void)\n {\n-    return 1;\n@@\n     return 1;\n+    ;\n",
                   "x.change:6: stands in right/base.c before the place above; keep the base's "
                   "order, and make one of two places that touch");
}

static void a_place_changes_something_at_a_known_place(void **state)
{
    (void)state;
    assert_refused("/* New. */\n     return 1;\n",
                   "x.change:2: nothing is changed here; mark lines by - and +, or take the place "
                   "out");
    assert_refused("/* New. */\n-    return 1;\n@@\n",
                   "x.change:4: nothing is changed here; mark lines by - and +, or take the place "
                   "out");
    assert_refused("/* New. */\n+int third(void);\n",
                   "x.change:2: only adds lines; put a line of the base beside them, so that their "
                   "place is known");
    assert_refused("/* New. */\n", "x.change:1: no change follows the comment; add the lines that "
                                   "differ");
    assert_refused(
        "/* New. */\n-    return 1;\nreturn 3;\n",
        "x.change:3: begins with neither a space nor - nor +; a line that both have gets "
        "a space in front");
}

static void a_comment_comes_first(void **state)
{
    (void)state;
    assert_refused("-    return 1;\n", "x.change:1: does not begin with a comment; put one there "
                                       "that says what the submission does");
    assert_refused("/* New. */ int a;\n-    return 1;\n",
                   "x.change:1: text behind the first comment; begin a new line there");
}

static void assert_base(const char *change, const char *expected, const char *refusal)
{
    char found[CHANGE_BASE_BYTES] = "";
    struct error err = {""};
    struct change_text text = {"x.change", change, strlen(change)};
    assert_int_equal(change_find_base(&text, found, &err), refusal ? -1 : 0);
    assert_string_equal(refusal ? err.text : found, refusal ? refusal : expected);
}

static void the_base_is_a_file_of_the_exercise(void **state)
{
    (void)state;
    assert_base("/* New.\n * of: right/sort.c\n * fails: open */\n", "right/sort.c", NULL);
    assert_base("/* New.\n * of: reference */\n", "reference", NULL);
    assert_base("/* of: greedy/wide-rows.c*/", "greedy/wide-rows.c", NULL);
    static const char no_line[] = "x.change:1: its first comment needs a line `of: right/FILE.c` "
                                  "or `of: reference`";
    assert_base("/* One of: two. */\n * of: right/sort.c\n", "", no_line);
    assert_base("", "", no_line);
    static const char *const bad[] = {"../secret.c", "right/../../x.c", "/etc/passwd.c",
                                      "right/.c",    "right/a.change",  "sort.c"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        char change[128], refusal[256];
        snprintf(change, sizeof change, "/* New.\n * of: %s */\n", bad[i]);
        snprintf(refusal, sizeof refusal,
                 "x.change:2: of: \"%s\"; name a whole file as right/sort.c, or reference", bad[i]);
        assert_base(change, "", refusal);
    }
}

/* ------------------------------------------------------------------ folders */

static char root[PATH_MAX];

static int make_root(void **state)
{
    struct error err = {""};
    (void)state;
    return folder_make_work(root, &err);
}

static int remove_root(void **state)
{
    (void)state;
    folder_remove_work(root);
    return 0;
}

static void put(const char *name, const char *text)
{
    char path[2 * PATH_MAX];
    struct error err = {""};
    snprintf(path, sizeof path, "%s/tests/submissions/edges/made/%s", root, name);
    *strrchr(path, '/') = '\0';
    assert_int_equal(folder_make(path, &err), 0);
    snprintf(path, sizeof path, "%s/tests/submissions/edges/made/%s", root, name);
    assert_int_equal(file_write(path, text, strlen(text), &err), 0);
}

static void assert_unread(const char *end_of_error)
{
    struct known_list list;
    struct error err = {""};
    assert_int_equal(known_read(root, "edges", "made", &list, &err), -1);
    known_release(&list);
    size_t length = strlen(err.text), tail = strlen(end_of_error);
    if (length < tail || strcmp(err.text + length - tail, end_of_error) != 0)
        fail_msg("\"%s\" does not end in \"%s\"", err.text, end_of_error);
    assert_true(strncmp(err.text, root, strlen(root)) == 0);
}

static void a_folder_is_read_and_written_whole(void **state)
{
    struct known_list list;
    struct error err = {""};
    char path[2 * PATH_MAX], *text;
    size_t count;
    (void)state;
    put("right/base.c", base);
    put("survivors.txt", "not a submission");
    put("wrong/two.change", "/* Two.\n * of: right/base.c\n * fails: open, work */\n"
                            "-    return 2;\n+    return 1;\n");
    put("hostile/out.c", "/* Out.\n * expect: forbidden-operation */\n");
    assert_int_equal(known_read(root, "edges", "made", &list, &err), 0);
    assert_int_equal(list.count, 3);
    assert_string_equal(list.submissions[0].file, "hostile/out.c");
    assert_string_equal(list.submissions[0].expected.verdict, "forbidden-operation");
    const struct known_submission *two = known_find(&list, "wrong/two.c");
    assert_non_null(two);
    assert_null(known_find(&list, "wrong/three.c"));
    assert_true(known_is(two, "wrong") && !known_is(two, "right") && !known_is(two, "wron"));
    assert_string_equal(two->expected.verdict, "wrong-answer");
    assert_int_equal(two->expected.failure_count, 2);
    assert_string_equal(two->expected.failures[1], "work");
    assert_non_null(strstr(two->text, "int second(void)\n{\n    return 1;\n}\n"));
    snprintf(path, sizeof path, "%s/whole", root);
    assert_int_equal(known_write(&list, path, &err), 0);
    snprintf(path, sizeof path, "%s/whole/wrong/two.c", root);
    assert_int_equal(file_read(path, 1000, &text, &count, &err), 0);
    assert_string_equal(text, two->text);
    free(text);
    known_release(&list);
}

static void what_is_out_of_place_is_refused(void **state)
{
    (void)state;
    static const char change[] = "/* Two.\n * of: right/base.c */\n-    return 2;\n";
    put("right/base.c", base);
    put("right/two.change", change);
    assert_unread("right/two.change: right answers are whole files, for others to be changes of");
}

static void a_name_stands_once(void **state)
{
    (void)state;
    put("right/base.c", base);
    put("wrong/two.c", base);
    put("wrong/two.change", "/* Two.\n * of: right/base.c */\n-    return 2;\n");
    assert_unread(": stands there whole and as a change; remove one of them");
}

static void a_base_is_there(void **state)
{
    (void)state;
    put("wrong/two.change", "/* Two.\n * of: right/sort.c */\n-    return 2;\n");
    assert_unread("wrong/two.change: of: right/sort.c: there is no such whole file of made");
}

static void a_slip_in_a_folder_or_ending_is_seen(void **state)
{
    (void)state;
    put("worng/two.c", base);
    assert_unread("worng: no kind of submission; use right, wrong, poor, slow, greedy, crash, leak "
                  "or hostile");
}

static void other_files_are_no_submissions(void **state)
{
    (void)state;
    put("wrong/two.cc", base);
    assert_unread("wrong/two.cc: neither a .c nor a .change file; take it out");
}

static void a_hostile_one_says_its_verdict(void **state)
{
    (void)state;
    put("hostile/two.c", base);
    assert_unread("hostile/two.c: \"\" is no verdict; its first comment needs a line expect:");
}

/* ---------------------------------------------------------- what failed alone */

static void stricter_bands_fail_along(void **state)
{
    static const struct quality_rule rule = {
        .name = {"a", "a"},
        .less_is_better = true,
        .bands = {{"quality-fair", 1.6}, {"quality-good", 1.25}}};
    (void)state;
    assert_true(expectation_fails_just("open", "open", &rule));
    assert_false(expectation_fails_just("open,closed", "open", &rule));
    assert_false(expectation_fails_just("", "open", &rule));
    assert_true(expectation_fails_just("quality-fair,quality-good", "quality-fair", &rule));
    assert_false(expectation_fails_just("quality-fair,quality-good", "quality-good", &rule));
    assert_true(expectation_fails_just("quality-good", "quality-good", &rule));
    assert_true(expectation_fails_just("open,quality-good", "open", &rule)); /* wrong is not good */
    assert_false(expectation_fails_just("open,quality-good", "quality-good", &rule));
    assert_false(expectation_fails_just("quality-good", "quality-fair", &rule));
}

static void poor_answers_have_a_folder(void **state)
{
    struct expectation expected;
    struct error err = {""};
    (void)state;
    assert_int_equal(expectation_read("poor", "poor/a.c", base, &expected, &err), 0);
    assert_string_equal(expected.verdict, "poor-quality");
}

static unsigned left_out(const char *kind, const char *comment)
{
    struct expectation expected;
    struct error err = {""};
    assert_int_equal(expectation_read(kind, "a.c", comment, &expected, &err), 0);
    return expectation_left_out(&expected);
}

static void in_brief_what_decides_is_run(void **state)
{
    const unsigned undefined = 1u << STAGE_UNDEFINED_BEHAVIOUR, memory = 1u << STAGE_MEMORY;
    const unsigned refusals = 1u << STAGE_ALLOCATION_FAILURE, growth = 1u << STAGE_GROWTH;
    (void)state;
    assert_int_equal(TRIAL_CHECKS, undefined | refusals | memory | growth);
    assert_int_equal(left_out("right", "/* fast */"), 0);
    assert_int_equal(left_out("hostile", "/* expect: flagged */"), 0);
    assert_int_equal(left_out("wrong", "/* slips */"), TRIAL_CHECKS);
    assert_int_equal(left_out("wrong", "/* fails: open, leak */"), TRIAL_CHECKS);
    assert_int_equal(left_out("wrong", "/* fails: open, growth */"), TRIAL_CHECKS & ~growth);
    assert_int_equal(left_out("slow", "/* scans */"), TRIAL_CHECKS & ~growth);
    assert_int_equal(left_out("greedy", "/* copies */"), TRIAL_CHECKS & ~memory);
    assert_int_equal(left_out("crash", "/* fails: allocation-failure */"),
                     TRIAL_CHECKS & ~refusals);
    assert_int_equal(left_out("hostile", "/* expect: undefined-behaviour */"),
                     TRIAL_CHECKS & ~undefined);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(in_brief_what_decides_is_run),
        cmocka_unit_test(a_line_is_replaced),
        cmocka_unit_test(places_are_changed_in_order),
        cmocka_unit_test(lines_that_stand_twice_are_refused),
        cmocka_unit_test(lines_that_are_not_there_are_refused),
        cmocka_unit_test(the_order_of_the_base_is_kept),
        cmocka_unit_test(a_place_changes_something_at_a_known_place),
        cmocka_unit_test(a_comment_comes_first),
        cmocka_unit_test(the_base_is_a_file_of_the_exercise),
        cmocka_unit_test(stricter_bands_fail_along),
        cmocka_unit_test(poor_answers_have_a_folder),
        cmocka_unit_test_setup_teardown(a_folder_is_read_and_written_whole, make_root, remove_root),
        cmocka_unit_test_setup_teardown(what_is_out_of_place_is_refused, make_root, remove_root),
        cmocka_unit_test_setup_teardown(a_name_stands_once, make_root, remove_root),
        cmocka_unit_test_setup_teardown(a_base_is_there, make_root, remove_root),
        cmocka_unit_test_setup_teardown(a_slip_in_a_folder_or_ending_is_seen, make_root,
                                        remove_root),
        cmocka_unit_test_setup_teardown(other_files_are_no_submissions, make_root, remove_root),
        cmocka_unit_test_setup_teardown(a_hostile_one_says_its_verdict, make_root, remove_root)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
