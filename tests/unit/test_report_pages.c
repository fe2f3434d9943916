/* The pages of the sample class. Called with a folder, it writes pages and exports there and leaves
 * them, for tests/cli/pages.t, which looks at them in a browser. */
#include "graders/report/report.h"

#include "graders/report/results.h"

#include "tests/unit/report_sample.h"

#include <glob.h>
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

static void make_pages(const char *out)
{
    struct error err = {""};
    if (report_pages(out, ".", &err) != 0)
        fail_msg("%s", err.text);
}

/* Calls `look` for each page below a folder with the page's path from it and its text. */
static void each_page(const char *out, void (*look)(const char *out, const char *name, char *text))
{
    char pattern[200];
    glob_t found;
    snprintf(pattern, sizeof pattern, "%s/students/*.html", out);
    assert_int_equal(glob(pattern, 0, NULL, &found), 0);
    snprintf(pattern, sizeof pattern, "%s/index.html", out);
    assert_int_equal(glob(pattern, GLOB_APPEND, NULL, &found), 0);
    assert_int_equal(found.gl_pathc, 9);
    for (size_t i = 0; i < found.gl_pathc; i++) {
        const char *name = found.gl_pathv[i] + strlen(out) + 1;
        char *text = sample_read(out, name);
        look(out, name, text);
        free(text);
    }
    globfree(&found);
}

static void look_for_markup(const char *out, const char *name, char *text)
{
    (void)out;
    static const char *const never[] = {"<script>",    "<img src=x", "onerror=alert(1)>",
                                        "javascript:", "\x1b",       "\xe2\x80\xae",
                                        "style=\"",    " onload="};
    for (size_t i = 0; i < sizeof never / sizeof *never; i++)
        if (strstr(text, never[i]))
            fail_msg("%s holds %s", name, never[i]);
    assert_non_null(strstr(text, "Content-Security-Policy"));
    assert_non_null(strstr(text, "lang=\"es\""));
}

/* What a page loads and where it leads is there, for every href and src. */
static void look_for_files(const char *out, const char *name, char *text)
{
    static const char *const attributes[] = {" href=\"", " src=\"", " data-scene=\""};
    const char *up = strchr(name, '/') ? "students/" : "";
    for (size_t i = 0; i < sizeof attributes / sizeof *attributes; i++) {
        for (const char *at = text; (at = strstr(at, attributes[i]));) {
            char path[400];
            at += strlen(attributes[i]);
            size_t length = strcspn(at, "\"#");
            snprintf(path, sizeof path, "%s/%s%.*s", out, up, (int)length, at);
            if (length > 0 && access(path, R_OK) != 0)
                fail_msg("%s names %s, which is not there", name, path);
        }
    }
}

static void test_no_text_of_others_is_markup(void **state)
{
    (void)state;
    char out[64];
    sample_copy(out);
    make_pages(out);
    each_page(out, look_for_markup);
    sample_remove(out);
}

static void test_what_pages_name_is_there(void **state)
{
    (void)state;
    char out[64];
    sample_copy(out);
    make_pages(out);
    each_page(out, look_for_files);
    sample_remove(out);
}

static void test_making_pages_again_changes_nothing(void **state)
{
    (void)state;
    static const char *const names[] = {"index.html", "students/ana-garcia.html", "assets/page.css",
                                        "pictures/ana-garcia/edge-table-any/disc.js"};
    char out[64];
    char path[300];
    struct stat before[4];
    struct stat after;
    sample_copy(out);
    make_pages(out);
    for (size_t i = 0; i < 4; i++) {
        snprintf(path, sizeof path, "%s/%s", out, names[i]);
        assert_int_equal(stat(path, &before[i]), 0);
    }
    make_pages(out);
    for (size_t i = 0; i < 4; i++) {
        snprintf(path, sizeof path, "%s/%s", out, names[i]);
        assert_int_equal(stat(path, &after), 0);
        assert_int_equal(before[i].st_ino, after.st_ino);
    }
    sample_remove(out);
}

static void test_the_class_page_says_what_matters(void **state)
{
    (void)state;
    char out[64];
    sample_copy(out);
    make_pages(out);
    char *text = sample_read(out, "index.html");
    assert_non_null(strstr(text, "duplicate edge"));
    assert_non_null(strstr(text, "Ana García Ñíguez"));
    assert_non_null(strstr(text, "Landlock (files): the kernel has no Landlock"));
    assert_non_null(strstr(text, "cache-misses: valgrind is not installed"));
    assert_non_null(strstr(text, "The judge did not answer, twice"));
    assert_non_null(strstr(text, "href=\"students/ana-garcia.html#edge-table-any\""));
    free(text);
    sample_remove(out);
}

/* The sample's final totals: of all students but the two with answers that are not scored. */
static void test_the_mean_of_totals_stands_below_them(void **state)
{
    (void)state;
    char out[64];
    char expected[80];
    struct gradebook book;
    double sum = 0;
    int count = 0;
    sample_copy(out);
    assert_int_equal(gradebook_load(out, &book, NULL), 0);
    for (size_t s = 0; s < book.student_count; s++) {
        sum += book.students[s].unscored ? 0 : book.students[s].score;
        count += !book.students[s].unscored;
    }
    char mean[32];
    words_of_points(sum / count, mean, sizeof mean);
    snprintf(expected, sizeof expected, "<td>%s <span class=\"quiet\">/ 30</span></td>", mean);
    make_pages(out);
    char *text = sample_read(out, "index.html");
    assert_non_null(strstr(text, expected));
    free(text);
    gradebook_release(&book);
    sample_remove(out);
}

/* Puts the texts of an exercise that nobody here knows into the first rejected case. */
static void make_new_cause(json_t *result)
{
    size_t i;
    json_t *one;
    json_array_foreach(json_object_get(result, "cases"), i, one)
    {
        if (strcmp(json_string_value(json_object_get(one, "name")), "disc") != 0)
            continue;
        json_object_set_new(one, "cause", json_string("lost-loop"));
        json_object_set_new(one, "cause_name",
                            json_pack("{s:s, s:s}", "en", "lost loop", "es", "falta un bucle"));
        json_object_set_new(
            one, "element",
            json_pack("{s:s, s:s}", "en", "loop 0, side (1,36)", "es", "bucle 0, lado (1,36)"));
    }
}

static void test_new_causes_and_nouns_read_in_both_languages(void **state)
{
    (void)state;
    static const char *const texts[] = {"<span lang=\"en\">lost loop</span>",
                                        "<span lang=\"es\">falta un bucle</span>",
                                        "<span lang=\"es\">bucle 0, lado (1,36)</span>"};
    char out[64];
    sample_copy(out);
    json_t *result = sample_result("ana-garcia", "edge-table-any");
    make_new_cause(result);
    sample_store(out, result);
    make_pages(out);
    char *student = sample_read(out, "students/ana-garcia.html");
    for (size_t i = 0; i < 3; i++)
        assert_non_null(strstr(student, texts[i]));
    free(student);
    json_decref(result);
    sample_remove(out);
}

/* A page shows the picture of its language; where there is only one, that. */
static void test_pictures_follow_the_language(void **state)
{
    (void)state;
    static const char spanish[] =
        "lang=\"es\" href=\"../pictures/ana-garcia/edge-table-any/disc.es.png\"";
    char out[64], path[200];
    sample_copy(out);
    for (int both = 0; both < 2; both++) {
        snprintf(path, sizeof path, "%s/pictures/ana-garcia/edge-table-any/disc%s.png", out,
                 both ? ".es" : "");
        FILE *file = fopen(path, "w");
        assert_non_null(file);
        fclose(file);
        make_pages(out);
        char *text = sample_read(out, "students/ana-garcia.html");
        assert_non_null(strstr(text, "href=\"../pictures/ana-garcia/edge-table-any/disc.png\""));
        assert_int_equal(strstr(text, spanish) != NULL, both);
        free(text);
    }
    sample_remove(out);
}

static void test_what_was_not_run_is_said_with_its_reason(void **state)
{
    (void)state;
    char out[64];
    sample_copy(out);
    json_t *result = sample_result("ana-garcia", "edge-table-any");
    sample_leave_out(result, "closed", 2);
    sample_store(out, result);
    json_decref(result);
    make_pages(out);
    char *text = sample_read(out, "students/ana-garcia.html");
    assert_non_null(strstr(text, "not run"));
    assert_non_null(strstr(text, "Two cases did not end in time."));
    assert_null(strstr(text, "0 of 2"));
    assert_non_null(strstr(text, "Not run: 2 cases of 1 answer,"));
    free(text);
    sample_remove(out);
}

/* A check that its tool could not finish is neither hidden nor called measured. */
static void test_what_was_not_measured_is_listed(void **state)
{
    (void)state;
    char out[64];
    sample_copy(out);
    json_t *result = sample_result("ana-garcia", "mesh-area");
    json_t *checks = json_object_get(result, "checks");
    json_t *check = json_array_get(checks, json_array_size(checks) - 1);
    json_object_set_new(check, "verdict", json_string("not-measured"));
    json_object_set_new(check, "cause", json_string("too-much-for-tool"));
    json_object_set_new(
        check, "message",
        json_pack("{s:s, s:s}", "en", "Not finished within 20 s.", "es", "No terminado en 20 s."));
    sample_store(out, result);
    json_decref(result);
    make_pages(out);
    static const char *const pages[] = {"index.html", "students/ana-garcia.html"};
    for (size_t i = 0; i < 2; i++) {
        char *text = sample_read(out, pages[i]);
        const char *title = strstr(text, "Not measured</span>");
        assert_non_null(title);
        assert_non_null(strstr(title, "No undefined behaviour"));
        assert_non_null(strstr(title, "Not finished within 20 s."));
        assert_null(strstr(text, "everything was measured"));
        free(text);
    }
    sample_remove(out);
}

/* A layer and its reason, a probe and its; those of earlier versions are plain strings. */
static void test_protections_are_told_in_both_languages(void **state)
{
    (void)state;
    char out[64];
    sample_copy(out);
    json_t *result = sample_result("ana-garcia", "mesh-area");
    json_object_set_new(result, "protections",
                        json_pack("{s:[s, s], s:{s:{s:s, s:s}, s:s}}", "active", "rlimits",
                                  "unheard-of", "inactive", "landlock", "en", "switched off", "es",
                                  "desactivada", "seccomp-names", "old"));
    json_object_set_new(result, "not_measured",
                        json_pack("[{s:{s:s, s:s}, s:{s:s, s:s}}]", "name", "en", "counts", "es",
                                  "cuentas", "reason", "en", "no valgrind", "es", "sin valgrind"));
    sample_store(out, result);
    json_decref(result);
    make_pages(out);
    char *text = sample_read(out, "students/ana-garcia.html");
    static const char *const told[] = {
        ">resource limits<",
        ">límites de recursos<",
        ">unheard-of<",
        ">Landlock (files): switched off<",
        ">Landlock (archivos): desactivada<",
        ">nombres de las llamadas rechazadas: old<",
        ">counts: no valgrind<",
        ">cuentas: sin valgrind<",
    };
    for (size_t i = 0; i < sizeof told / sizeof *told; i++)
        if (!strstr(text, told[i]))
            fail_msg("not on the page: %s", told[i]);
    free(text);
    sample_remove(out);
}

static void test_the_reason_for_missing_pictures_is_on_the_pages(void **state)
{
    (void)state;
    char out[64];
    sample_copy(out);
    assert_int_equal(report_pictures(out, NULL, NULL), 0);
    make_pages(out);
    char *text = sample_read(out, "index.html");
    assert_non_null(strstr(text, " pictures of this class are missing: "));
    assert_non_null(strstr(text, "meshgrade-render is not there"));
    free(text);
    sample_remove(out);
}

static void test_unsound_input_makes_no_page(void **state)
{
    (void)state;
    char out[64];
    char path[200];
    struct error err = {""};
    sample_copy(out);
    snprintf(path, sizeof path, "%s/results/s3/mesh-area.json", out);
    assert_int_equal(truncate(path, 100), 0);
    assert_int_equal(report_pages(out, ".", &err), -1);
    assert_non_null(strstr(err.text, "results/s3/mesh-area.json"));
    err.text[0] = '\0';
    assert_int_equal(report_grades(out, &err), -1);
    assert_int_equal(report_pictures(out, NULL, &err), -1);
    sample_remove(out);

    sample_copy(out);
    err.text[0] = '\0';
    assert_int_equal(report_pages(out, "/tmp/meshgrade-no-such-tree", &err), -1);
    assert_non_null(strstr(err.text, "page.css"));
    sample_remove(out);
}

static int leave_report(const char *out)
{
    static const char *const exports[] = {"junit", "gradescope"};
    struct error err = {""};
    if (report_pages(out, ".", &err) != 0 || report_grades(out, &err) != 0)
        fprintf(stderr, "%s\n", err.text);
    for (size_t i = 0; i < 2 && err.text[0] == '\0'; i++) {
        struct export_selection everyone = {0};
        char path[300];
        snprintf(path, sizeof path, "%s/%s", out, exports[i]);
        FILE *to = fopen(path, "w");
        if (!to || report_export(out, exports[i], &everyone, to, &err) != 0 || fclose(to) != 0)
            fprintf(stderr, "%s: %s\n", path, err.text);
    }
    return err.text[0] ? 1 : 0;
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_no_text_of_others_is_markup),
        cmocka_unit_test(test_what_pages_name_is_there),
        cmocka_unit_test(test_making_pages_again_changes_nothing),
        cmocka_unit_test(test_the_class_page_says_what_matters),
        cmocka_unit_test(test_the_mean_of_totals_stands_below_them),
        cmocka_unit_test(test_new_causes_and_nouns_read_in_both_languages),
        cmocka_unit_test(test_pictures_follow_the_language),
        cmocka_unit_test(test_what_was_not_run_is_said_with_its_reason),
        cmocka_unit_test(test_what_was_not_measured_is_listed),
        cmocka_unit_test(test_protections_are_told_in_both_languages),
        cmocka_unit_test(test_the_reason_for_missing_pictures_is_on_the_pages),
        cmocka_unit_test(test_unsound_input_makes_no_page),
    };
    return argc > 1 ? leave_report(argv[1]) : cmocka_run_group_tests(tests, NULL, NULL);
}
