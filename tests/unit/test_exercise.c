/* What is no sound exercise is refused when it is loaded, in a line that names file and remedy. */
#include "graders/engine/base/exercise.h"
#include "graders/engine/base/files.h"
#include "graders/engine/run/soundness.h"
#include "graders/judges/table.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define FOLDER "exercises/edges/edge-table-any"
#define MANIFEST FOLDER "/exercise.json"
#define JUDGE "graders/judges/edges/edge-table-any.c"

static char *manifest; /* the text of one that is sound */
static struct exercise sound;

static int read_manifest(void **state)
{
    struct error err = {""};
    size_t count;
    (void)state;
    if (file_read(MANIFEST, 1 << 20, &manifest, &count, &err) != 0)
        return -1;
    return exercise_parse(manifest, count, MANIFEST, &sound, &err);
}

static int free_manifest(void **state)
{
    (void)state;
    free(manifest);
    return 0;
}

/* The manifest with the first `from` replaced. The caller frees it. */
static char *replace(const char *from, const char *to)
{
    char *text, *at = strstr(manifest, from);
    if (!at)
        fail_msg("%s: no %s", MANIFEST, from);
    if (asprintf(&text, "%.*s%s%s", (int)(at - manifest), manifest, to, at + strlen(from)) < 0)
        fail_msg("out of memory");
    return text;
}

static void assert_refused(const char *from, const char *to, const char *expected)
{
    struct exercise exercise;
    struct error err = {""};
    char *text = replace(from, to);
    assert_int_equal(exercise_parse(text, strlen(text), MANIFEST, &exercise, &err), -1);
    assert_string_equal(err.text, expected);
    free(text);
}

static void points_sum_to_ten(void **state)
{
    (void)state;
    assert_refused("\"name\": \"closed\", \"points\": 1", "\"name\": \"closed\", \"points\": 1.5",
                   MANIFEST ": points: expected 10 in all classes and checks together, not 10.5");
}

static void texts_stand_in_both_languages(void **state)
{
    (void)state;
    assert_refused("\"es\": \"Mallas cerradas\"", "\"es\": \"\"",
                   MANIFEST ": title: expected texts in both languages that are not empty");
    assert_refused(", \"es\": \"Mallas cerradas\"", "", MANIFEST ": es: expected a short text");
}

static void given_functions_are_not_the_students(void **state)
{
    (void)state;
    assert_refused("\"classes\": [", "\"given\": [\"edge_table_any\"], \"classes\": [",
                   MANIFEST ": given: expected functions that are not the student's to write");
    assert_refused("\"classes\": [", "\"given\": [], \"classes\": [",
                   MANIFEST ": given: expected a list of 1 to 8 function names");
    assert_refused("\"leak\": {", "\"accesses\": {\"points\": 0, \"band\": 2}, \"leak\": {",
                   MANIFEST ": accesses: expected \"given\" too: what is counted is calls of given "
                            "functions");
}

static void titles_fit_a_terminal(void **state)
{
    (void)state;
    assert_refused("\"Mallas cerradas\"", "\"ééééééééééééééééééééééééééééééééééééé.\"",
                   MANIFEST ": title: expected at most 37 columns, which is what a terminal shows");
    struct exercise exercise;
    struct error err = {""};
    char *text = replace("\"Mallas cerradas\"", "\"ééééééééééééééééééééééééééééééééééééé\"");
    assert_int_equal(exercise_parse(text, strlen(text), MANIFEST, &exercise, &err), 0);
    free(text);
    assert_refused("\"Edge table of any mesh\"",
                   "\"Edge table of any mesh, and of meshes with holes or handles\"",
                   MANIFEST ": title: expected at most 56 columns, which is what a terminal shows");
}

static void class_names_are_unique_and_plain(void **state)
{
    (void)state;
    assert_refused("\"name\": \"open\"", "\"name\": \"closed\"",
                   MANIFEST ": classes: expected each name once");
    assert_refused("\"name\": \"open\"", "\"name\": \"open, or not\"",
                   MANIFEST ": classes: expected names of small letters, digits and dashes");
}

static void name_and_group_are_the_folders(void **state)
{
    (void)state;
    assert_refused("\"name\": \"edge-table-any\"", "\"name\": \"edge-table-all\"",
                   MANIFEST ": name: expected the name of the folder");
    assert_refused("\"group\": \"edges\"", "\"group\": \"edge\"",
                   MANIFEST ": group: expected the name of the folder above");
}

/* -------------------------------------------------------------- the whole tree */

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

static void put_exercise(const char *group, const char *name, int order)
{
    char path[2 * PATH_MAX], *text;
    struct error err = {""};
    int count = asprintf(
        &text,
        "{\"name\": \"%s\", \"group\": \"%s\", \"order\": %d, \"problem\": \"\","
        "\"title\": {\"en\": \"a\", \"es\": \"a\"}, \"functions\": [\"f\"], \"classes\":"
        "[{\"name\": \"all\", \"points\": 10, \"title\": {\"en\": \"a\", \"es\": \"a\"}}]}",
        name, group, order);
    assert_true(count > 0);
    snprintf(path, sizeof path, "%s/exercises/%s/%s", root, group, name);
    assert_int_equal(folder_make(path, &err), 0);
    snprintf(path, sizeof path, "%s/exercises/%s/%s/exercise.json", root, group, name);
    assert_int_equal(file_write(path, text, (size_t)count, &err), 0);
    free(text);
}

static void assert_tree_refused(const char *expected_end)
{
    struct exercise *exercises = NULL;
    struct error err = {""};
    int count;
    assert_int_equal(exercises_read(root, &exercises, &count, &err), -1);
    assert_null(exercises);
    assert_true(strncmp(err.text, root, strlen(root)) == 0);
    assert_string_equal(err.text + strlen(root), expected_end);
}

static void orders_are_unique(void **state)
{
    (void)state;
    put_exercise("edges", "one", 10);
    put_exercise("edges", "two", 10);
    assert_tree_refused(
        "/exercises/edges/two/exercise.json: order: 10 is that of one; choose another");
}

static void names_are_unique_in_all_groups(void **state)
{
    (void)state;
    put_exercise("edges", "one", 10);
    put_exercise("repair", "one", 20);
    assert_tree_refused("/exercises/repair/one/exercise.json: name: group edges has an exercise of "
                        "that name; rename one");
}

/* ------------------------------------------------------------------ and judges */

enum { CASES = 12 };

/* A judge that is sound with the manifest: a case for each class. */
struct made {
    struct judge judge;
    struct judge_case cases[CASES];
    struct size_family families[FAMILIES_MAX + 2];
};

static void make_judge(struct made *made)
{
    static const char *const names[CASES] = {"a", "b", "c", "d", "e", "f",
                                             "g", "h", "i", "j", "k", "l"};
    *made = (struct made){.families = {{.name = "strip"}, {.name = "fan"}}};
    made->judge.exercise = "edge-table-any";
    made->judge.cases = made->cases;
    made->judge.case_count = (size_t)sound.class_count;
    made->judge.families = made->families;
    assert_true(sound.class_count < CASES);
    for (int i = 0; i < CASES; i++) {
        made->cases[i].name = names[i];
        made->cases[i].class_name = sound.classes[i % sound.class_count].name;
        made->cases[i].seed = (uint64_t)i + 1;
        made->cases[i].runs = i == 0 ? PUBLIC | QUICK : HIDDEN;
    }
}

static void assert_unsound(const struct exercise *exercise, const struct made *made,
                           const char *expected)
{
    struct error err = {""};
    assert_int_equal(soundness_check(exercise, &made->judge, &err), -1);
    assert_string_equal(err.text, expected);
}

static void a_sound_judge_is_taken(void **state)
{
    struct made made;
    struct error err = {""};
    (void)state;
    make_judge(&made);
    assert_int_equal(soundness_check(&sound, &made.judge, &err), 0);
    assert_int_equal(soundness_check(&sound, NULL, &err), -1);
    assert_string_equal(err.text, FOLDER "/exercise.json: this program has no judge " JUDGE
                                         "; write it, and build anew");
}

static void classes_are_those_of_the_manifest(void **state)
{
    struct made made;
    (void)state;
    make_judge(&made);
    made.cases[1].class_name = "opens";
    assert_unsound(&sound, &made,
                   JUDGE ": case b is of class opens, which exercise.json does not name; correct "
                         "one of them");
    made.cases[1].class_name = "closed";
    assert_unsound(&sound, &made,
                   FOLDER "/exercise.json: class open has no case; add one to " JUDGE
                          " or take the class out");
    made.judge.case_count = 0;
    assert_unsound(&sound, &made, JUDGE ": has no cases; add some");
}

static void cases_have_names_and_seeds_of_their_own(void **state)
{
    struct made made;
    (void)state;
    make_judge(&made);
    made.cases[3].name = "b";
    assert_unsound(&sound, &made, JUDGE ": two cases are called b; rename one");
    made.cases[3].name = "d";
    made.cases[3].seed = 2;
    assert_unsound(&sound, &made, JUDGE ": cases b and d have the same seed; change one");
}

static void some_cases_are_public_and_quick(void **state)
{
    struct made made;
    (void)state;
    make_judge(&made);
    made.cases[0].runs = PUBLIC;
    assert_unsound(&sound, &made, JUDGE ": no case is quick; make one so");
    made.cases[0].runs = QUICK;
    assert_unsound(&sound, &made, JUDGE ": no case is public; make one so");
}

static void families_fit(void **state)
{
    struct made made;
    struct exercise exercise = sound;
    (void)state;
    make_judge(&made);
    made.families[2].name = "strip";
    assert_unsound(&sound, &made, JUDGE ": two families are called strip; rename one");
    for (int i = 0; i <= FAMILIES_MAX; i++)
        made.families[i].name = made.cases[i].name;
    assert_unsound(&sound, &made, JUDGE ": has more than 4 families; take some out");
    made.judge.families = NULL;
    assert_unsound(&sound, &made,
                   JUDGE ": has no families, and exercise.json judges growth; correct one of them");
    make_judge(&made);
    exercise.checked[CHECK_GROWTH] = false;
    assert_unsound(&exercise, &made,
                   JUDGE ": has families, and exercise.json does not judge growth; correct one of "
                         "them");
}

static void bands_of_quality_fit(void **state)
{
    struct made made;
    struct error err = {""};
    (void)state;
    make_judge(&made);
    made.judge.quality = (struct quality_rule){.bands = {{"open", 1.5}}};
    assert_unsound(&sound, &made,
                   JUDGE ": has bands of quality without its name; write "
                         ".quality.name");
    made.judge.quality.name = (struct phrase){"indices", NULL};
    assert_unsound(&sound, &made,
                   JUDGE ": name and unit of quality are in one language; write both");
    made.judge.quality.name.es = "índices";
    assert_int_equal(soundness_check(&sound, &made.judge, &err), 0);
    made.judge.quality.bands[1] = (struct quality_band){.class_name = "open", .limit = 2};
    assert_unsound(&sound, &made, JUDGE ": two bands of quality are of class open; take one out");
    made.judge.quality.bands[1] = (struct quality_band){.class_name = "opens", .limit = 2};
    assert_unsound(&sound, &made,
                   JUDGE ": a band of quality is of class opens, which exercise.json does not "
                         "name; correct one of them");
    made.judge.quality.bands[1] = (struct quality_band){.class_name = "closed", .limit = 2};
    assert_unsound(&sound, &made,
                   JUDGE ": a band of quality is of class closed, the first, which right answers "
                         "pass; set it for another class");
    made.judge.quality.bands[1] = (struct quality_band){.class_name = NULL};
    made.judge.quality.bands[0].limit = (double)INFINITY;
    assert_unsound(&sound, &made,
                   JUDGE ": the band of quality of class open is inf; use a finite number");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_sum_to_ten),
        cmocka_unit_test(texts_stand_in_both_languages),
        cmocka_unit_test(given_functions_are_not_the_students),
        cmocka_unit_test(titles_fit_a_terminal),
        cmocka_unit_test(class_names_are_unique_and_plain),
        cmocka_unit_test(name_and_group_are_the_folders),
        cmocka_unit_test_setup_teardown(orders_are_unique, make_root, remove_root),
        cmocka_unit_test_setup_teardown(names_are_unique_in_all_groups, make_root, remove_root),
        cmocka_unit_test(a_sound_judge_is_taken),
        cmocka_unit_test(classes_are_those_of_the_manifest),
        cmocka_unit_test(cases_have_names_and_seeds_of_their_own),
        cmocka_unit_test(some_cases_are_public_and_quick),
        cmocka_unit_test(families_fit),
        cmocka_unit_test(bands_of_quality_fit)};
    return cmocka_run_group_tests(tests, read_manifest, free_manifest);
}
