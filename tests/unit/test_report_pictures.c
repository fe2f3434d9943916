/* Pictures: what is given to the renderer, what is made of its failures. The renderers here are
 * small scripts; the real one is tested with the pictures themselves. */
#include "graders/report/report.h"

#include "graders/report/renderer.h"
#include "tests/unit/report_sample.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

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

/* Draws each "out" of a job as an empty-looking file, and keeps a copy of every job. */
static const char drawing_script[] =
    "#!/bin/sh\n"
    "cd \"$(dirname \"$1\")\" || exit 2\n"
    "job=$(basename \"$1\")\n"
    "cat \"$job\" >>../jobs; echo >>../jobs\n"
    "grep -o '\"out\":\"[^\"]*\"' \"$job\" | cut -d'\"' -f4 | while read -r out; do\n"
    "  case $out in *voxels*) ;; *) echo picture >\"$out\";; esac\n"
    "done\n"
    "exit 1\n";

static void write_script(const char *out, const char *text, char *path)
{
    sprintf(path, "%s/renderer", out);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
    assert_int_equal(chmod(path, 0755), 0);
}

static int draw(const char *out, const char *renderer)
{
    struct error err = {""};
    int drawn = report_pictures(out, renderer, &err);
    if (drawn < 0)
        fail_msg("%s", err.text);
    return drawn;
}

static bool exists(const char *out, const char *name)
{
    char path[300];
    snprintf(path, sizeof path, "%s/%s", out, name);
    return access(path, F_OK) == 0;
}

/* Job files that were left behind. */
static size_t count_jobs(const char *out)
{
    char pattern[300];
    glob_t found;
    snprintf(pattern, sizeof pattern, "%s/pictures/job*.json", out);
    size_t count = glob(pattern, 0, NULL, &found) == 0 ? found.gl_pathc : 0;
    globfree(&found);
    return count;
}

static void assert_reason(const char *out, const char *says)
{
    char reason[512];
    report_pictures_reason(out, reason, sizeof reason);
    if (*says == '\0')
        assert_string_equal(reason, "");
    else if (!strstr(reason, says))
        fail_msg("expected \"%s\" in the reason: %s", says, reason);
}

static void test_scenes_are_drawn_once(void **state)
{
    (void)state;
    char out[64];
    char renderer[100];
    sample_copy(out);
    write_script(out, drawing_script, renderer);
    int drawn = draw(out, renderer);
    assert_true(drawn > 20);
    assert_true(exists(out, "pictures/ana-garcia/edge-table-any/disc.png"));
    assert_true(exists(out, "pictures/ana-garcia/edge-table-any/growth.png"));
    assert_true(exists(out, "pictures/ana-garcia/edge-table-any/memory.json"));
    assert_true(exists(out, "pictures/ana-garcia/sheet.png"));
    assert_true(exists(out, "pictures/class.png"));
    assert_int_equal(count_jobs(out), 0);
    assert_reason(out, "left some out"); /* the voxels */

    char *jobs = sample_read(out, "jobs");
    assert_non_null(strstr(jobs, "\"scene\":\"ana-garcia/edge-table-any/disc.json\""));
    assert_non_null(strstr(jobs, "\"caption\":\"edge-table-any: duplicate edge (2 of 7)\""));
    assert_non_null(strstr(jobs, "\"title\":\"Ana Garc"));
    free(jobs);

    assert_int_equal(draw(out, "/bin/false"), 0); /* what is drawn stays */
    sample_remove(out);
}

static void test_a_newer_scene_is_drawn_again(void **state)
{
    (void)state;
    char out[64];
    char renderer[100];
    char path[300];
    sample_copy(out);
    write_script(out, drawing_script, renderer);
    draw(out, renderer);
    snprintf(path, sizeof path, "%s/pictures/ana-garcia/edge-table-any/disc.png", out);
    struct timespec old[2] = {{.tv_sec = 1}, {.tv_sec = 1}};
    assert_int_equal(utimensat(AT_FDCWD, path, old, 0), 0);
    int drawn = draw(out, renderer);
    assert_true(drawn >= 1 && drawn <= 3); /* it and the sheets that hold it */
    sample_remove(out);
}

static void test_no_renderer_is_no_fault(void **state)
{
    (void)state;
    static const char *const programs[] = {NULL, "/tmp/meshgrade-no-such-program"};
    for (size_t i = 0; i < 2; i++) {
        char out[64];
        sample_copy(out);
        assert_int_equal(draw(out, programs[i]), 0);
        assert_reason(out, "meshgrade-render is not there");
        assert_true(exists(out, "pictures/ana-garcia/edge-table-any/growth.json"));
        sample_remove(out);
    }
}

/* Writes `script`, draws with it, and expects nothing drawn for that reason. */
static void fail_with(const char *script, const char *reason)
{
    char out[64];
    char renderer[100];
    sample_copy(out);
    write_script(out, script, renderer);
    assert_int_equal(draw(out, renderer), 0);
    assert_reason(out, reason);
    sample_remove(out);
}

static void test_failures_of_the_renderer_are_told(void **state)
{
    (void)state;
    fail_with("#!/bin/sh\nexit 2\n", "found no OpenGL");
    fail_with("#!/bin/sh\nkill -SEGV $$\n", "crashed");
    fail_with("not a program", "could not be started");
    fail_with("#!/bin/sh\nexit 0\n", "left some out");
}

static void test_a_hanging_renderer_is_stopped(void **state)
{
    (void)state;
    char out[64];
    char renderer[100];
    struct phrase reason = {NULL, NULL};
    sample_copy(out);
    write_script(out, "#!/bin/sh\nexec sleep 1000\n", renderer);
    assert_int_equal(renderer_run(renderer, "job.json", 100, &reason), RENDERER_FAILED);
    assert_non_null(strstr(reason.en, "did not end in time"));
    assert_int_equal(renderer_limit_ms(0), 30000);
    assert_int_equal(renderer_limit_ms(3), 60000);
    assert_true(renderer_limit_ms(SIZE_MAX) > 0);
    sample_remove(out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_scenes_are_drawn_once),
        cmocka_unit_test(test_a_newer_scene_is_drawn_again),
        cmocka_unit_test(test_no_renderer_is_no_fault),
        cmocka_unit_test(test_failures_of_the_renderer_are_told),
        cmocka_unit_test(test_a_hanging_renderer_is_stopped),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
