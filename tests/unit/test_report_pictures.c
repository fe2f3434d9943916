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
    "grep -o '\"[a-z]*\":\"[^\"]*png\"' \"$job\" | cut -d'\"' -f4 | while read -r out; do\n"
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
    assert_true(exists(out, "pictures/class.es.png"));
    assert_true(exists(out, "pictures/ana-garcia/sheet.es.png"));
    assert_true(exists(out, "pictures/ana-garcia/edge-table-any/disc.es.png"));
    assert_int_equal(count_jobs(out), 0);
    assert_reason(out, "left some out"); /* the voxels */

    char *jobs = sample_read(out, "jobs");
    assert_non_null(strstr(jobs, "\"scene\":\"ana-garcia/edge-table-any/disc.json\""));
    assert_non_null(strstr(jobs, "\"en\":\"edge-table-any: duplicate edge (2 of 7)\""));
    assert_non_null(strstr(jobs, "\"es\":\"edge-table-any: arista duplicada (2 de 7)\""));
    assert_non_null(strstr(jobs, "\"es\":\"edge-table-any: crecimiento\""));
    assert_non_null(strstr(jobs, "\"es\":\"edge-table-any: disc\""));
    assert_non_null(strstr(jobs, "\"title\":{\"en\":\"Ana Garc"));
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

/* Runs `script` as the renderer; it must be stopped for that reason. */
static void stop_it(const char *script, struct renderer_limits limits, const char *why)
{
    char out[64];
    char renderer[100];
    struct phrase reason = {NULL, NULL};
    sample_copy(out);
    write_script(out, script, renderer);
    assert_int_equal(renderer_run(renderer, "job.json", limits, &reason), RENDERER_FAILED);
    assert_non_null(strstr(reason.en, why));
    sample_remove(out);
}

static void test_a_renderer_is_stopped_by_its_cpu_time(void **state)
{
    (void)state;
    stop_it("#!/bin/sh\nwhile :; do :; done\n", (struct renderer_limits){1, 1000000}, "CPU time");
    assert_int_equal(renderer_limits(0).cpu_seconds, 30);
    assert_int_equal(renderer_limits(3).cpu_seconds, 60);
    assert_true(renderer_limits(SIZE_MAX).cpu_seconds > 0);
}

static void test_a_renderer_that_stands_still_is_stopped(void **state)
{
    (void)state;
    stop_it("#!/bin/sh\nexec sleep 1000\n", (struct renderer_limits){1000, 300}, "stood still");
}

/* It breaks off after the first scene of each student. */
static const char breaking_script[] =
    "#!/bin/sh\n"
    "cd \"$(dirname \"$1\")\" || exit 2\n"
    "grep -o '\"[a-z]*\":\"[^\"]*png\"' \"$(basename \"$1\")\" | head -n 2 | cut -d'\"' -f4 |\n"
    "while read -r out; do echo picture >\"$out\"; done\n"
    "kill -KILL $$\n";

static long long undrawn_of(const char *out)
{
    char *text = sample_read(out, "pictures/status.json");
    const char *at = strstr(text, "\"undrawn\":");
    long long undrawn = at ? atoll(at + strlen("\"undrawn\":")) : -1;
    free(text);
    return undrawn;
}

static void test_the_next_report_draws_the_rest(void **state)
{
    (void)state;
    char out[64];
    char renderer[100];
    sample_copy(out);
    write_script(out, breaking_script, renderer);
    int first = draw(out, renderer);
    long long missing = undrawn_of(out);
    assert_true(first > 0);
    assert_true(missing > 0);
    assert_reason(out, "crashed");
    write_script(out, drawing_script, renderer);
    int rest = draw(out, renderer);
    assert_true(undrawn_of(out) < missing); /* that script leaves out the voxels */
    assert_true(rest >= missing - undrawn_of(out));
    assert_reason(out, "left some out");
    sample_remove(out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_scenes_are_drawn_once),
        cmocka_unit_test(test_a_newer_scene_is_drawn_again),
        cmocka_unit_test(test_no_renderer_is_no_fault),
        cmocka_unit_test(test_failures_of_the_renderer_are_told),
        cmocka_unit_test(test_a_renderer_is_stopped_by_its_cpu_time),
        cmocka_unit_test(test_a_renderer_that_stands_still_is_stopped),
        cmocka_unit_test(test_the_next_report_draws_the_rest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
