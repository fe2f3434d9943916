/* A judge in a process of its own: what it says arrives, and its end is our fault, not the
 * submission's. */
#include "graders/engine/run/examine.h"

#include <dirent.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

static int accept_all(const struct task *task, struct judgement *judgement, struct error *err)
{
    (void)task, (void)err;
    judgement->accepted = true;
    return 0;
}

static int die(const struct task *task, struct judgement *judgement, struct error *err)
{
    (void)task, (void)judgement, (void)err;
    raise(SIGKILL);
    return 0;
}

/* The file in memory that the engine reads the judgement from. */
static int find_message(void)
{
    char path[64], target[64];
    for (int fd = 3; fd < 256; fd++) {
        snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
        ssize_t length = readlink(path, target, sizeof target - 1);
        target[length > 0 ? length : 0] = '\0';
        if (strncmp(target, "/memfd:judgement", 16) == 0)
            return fd;
    }
    return -1;
}

/* Says everything, a scene too, and then ends as one does that failed. */
static int say_and_fail(const struct task *task, struct judgement *judgement, struct error *err)
{
    static const char nothing[sizeof *judgement + sizeof *err], scene[] = "{\"kind\": \"mesh\"}";
    int file = find_message();
    (void)task;
    bool said = write(file, nothing, sizeof nothing) == (ssize_t)sizeof nothing &&
                write(file, scene, sizeof scene - 1) == (ssize_t)sizeof scene - 1;
    _exit(said ? 1 : 0);
}

static int ask(int (*judge)(const struct task *, struct judgement *, struct error *),
               struct examination *examination, struct error *err)
{
    const struct judge asked = {.exercise = "test", .judge = judge};
    const struct usage usage = {0};
    return examine(&asked, NULL, (struct span){0}, (struct span){0}, &usage, examination, err);
}

static void test_a_judgement_arrives(void **state)
{
    struct examination examination;
    struct error err = {""};
    (void)state;
    assert_int_equal(ask(accept_all, &examination, &err), 0);
    assert_true(examination.judgement.accepted);
    assert_null(examination.scene);
    examination_release(&examination);
}

static void test_a_crash_is_a_fault(void **state)
{
    struct examination examination;
    struct error err = {""};
    (void)state;
    assert_int_equal(ask(die, &examination, &err), -1);
    assert_non_null(strstr(err.text, "died of signal 9"));
}

/* A fault owns nothing: nobody releases it. */
static void test_a_fault_keeps_no_scene(void **state)
{
    struct examination examination;
    struct error err = {""};
    (void)state;
    assert_int_equal(ask(say_and_fail, &examination, &err), -1);
    assert_null(examination.scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_judgement_arrives),
        cmocka_unit_test(test_a_crash_is_a_fault),
        cmocka_unit_test(test_a_fault_keeps_no_scene),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
