/* A fingerprint changes with every program that a plan starts, in whichever job. */
#include "bench/compare/fingerprint.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

static char paths[3][64]; /* ours and two peers */
static const struct machine machine = {.cpu = "A CPU", .core_count = 2};

static void fill(int which, const char *contents)
{
    FILE *file = fopen(paths[which], "we");
    assert_non_null(file);
    fputs(contents, file);
    assert_int_equal(fclose(file), 0);
}

static int make(void **state)
{
    (void)state;
    for (int i = 0; i < 3; i++) {
        strcpy(paths[i], "/tmp/meshgrade-fingerprint-XXXXXX");
        int file = mkstemp(paths[i]);
        if (file < 0 || close(file) != 0)
            return -1;
    }
    return 0;
}

static int release(void **state)
{
    (void)state;
    for (int i = 0; i < 3; i++)
        unlink(paths[i]);
    return 0;
}

static void add(struct job *job, enum contender_kind kind, const char *program)
{
    struct contender *contender = &job->contenders[job->contender_count++];
    contender->kind = kind;
    strcpy(contender->program, program);
}

static void every_program_counts(void **state)
{
    char before[FINGERPRINT_BYTES], after[FINGERPRINT_BYTES];
    (void)state;
    /* as in a full run: the first job has no peers, the others share one */
    struct job *jobs = calloc(3, sizeof *jobs);
    const struct plan plan = {.jobs = jobs, .job_count = 3};
    assert_non_null(jobs);
    for (int i = 0; i < 3; i++)
        add(&jobs[i], CONTENDER_KERNEL, paths[0]);
    add(&jobs[1], CONTENDER_PEER, paths[1]);
    add(&jobs[2], CONTENDER_PEER, paths[1]);
    add(&jobs[2], CONTENDER_PEER, paths[2]);
    for (int i = 0; i < 3; i++)
        fill(i, "as built");
    for (int i = 0; i < 3; i++) {
        fingerprint_write(&plan, paths[0], &machine, before);
        fingerprint_write(&plan, paths[0], &machine, after);
        assert_string_equal(before, after);
        fill(i, "built anew");
        fingerprint_write(&plan, paths[0], &machine, after);
        assert_string_not_equal(before, after);
    }
    free(jobs);
}

static void what_is_not_started_does_not_count(void **state)
{
    char before[FINGERPRINT_BYTES], after[FINGERPRINT_BYTES];
    (void)state;
    const struct plan plan = {.jobs = NULL, .job_count = 0};
    fingerprint_write(&plan, paths[0], &machine, before);
    fill(1, "another peer");
    fingerprint_write(&plan, paths[0], &machine, after);
    assert_string_equal(before, after);
    struct machine other = machine;
    other.core_count++;
    fingerprint_write(&plan, paths[0], &other, after);
    assert_string_not_equal(before, after);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_program_counts),
        cmocka_unit_test(what_is_not_started_does_not_count),
    };
    return cmocka_run_group_tests(tests, make, release);
}
