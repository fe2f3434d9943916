/* The stream of callgrind's dumps: what is exactly as it must be is taken, anything else is not. */
#include "graders/engine/base/files.h"
#include "graders/engine/run/dumps.h"

#include <fcntl.h>
#include <limits.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

static const char *const callees[] = {"f", NULL};

struct scene {
    char folder[PATH_MAX];
    struct dumps dumps;
};

static int set_up(void **state)
{
    struct scene *scene = calloc(1, sizeof *scene);
    assert_non_null(scene);
    assert_int_equal(folder_make_work(scene->folder, NULL), 0);
    assert_int_equal(dumps_make(&scene->dumps, scene->folder, 3, NULL), 0);
    *state = scene;
    return 0;
}

static int tear_down(void **state)
{
    struct scene *scene = *state;
    dumps_release(&scene->dumps);
    folder_remove_work(scene->folder);
    free(scene);
    return 0;
}

/* Writes as a program in the box would: by the name. */
static void put(const struct scene *scene, const char *name, const char *text)
{
    char path[PATH_MAX + 16];
    snprintf(path, sizeof path, "%s/%s", scene->folder, name);
    int file = open(path, O_WRONLY | O_TRUNC | O_NONBLOCK);
    assert_true(file >= 0);
    assert_int_equal(write(file, text, strlen(text)), strlen(text));
    close(file);
}

static void put_dump(const struct scene *scene, const char *name, int part, const char *trigger)
{
    char text[256];
    snprintf(text, sizeof text,
             "part: %d\ndesc: Trigger: %s\nevents: Ir\nfn=(1) g\n0 7\ncfn=(2) f\ncalls=1 0\n0 40\n"
             "summary: 47\n",
             part, trigger);
    put(scene, name, text);
}

static int take(struct scene *scene, const char *trigger, struct callgrind_dump *dump)
{
    static const struct callgrind_calls calls = {"g", callees, NULL, callees};
    return dumps_take(&scene->dumps, trigger, &calls, dump, NULL);
}

static void dumps_in_order_are_taken(void **state)
{
    struct scene *scene = *state;
    struct callgrind_dump dump;
    put_dump(scene, "counts.1", 1, "call");
    assert_int_equal(take(scene, "call", &dump), 0);
    assert_int_equal(dump.counts.instructions, 47);
    assert_int_equal(dump.called.instructions, 40);
    assert_int_equal(dump.access_count, 1);
    put_dump(scene, "counts.2", 2, "call");
    assert_int_equal(take(scene, "call", &dump), 0);
    put_dump(scene, "counts", 3, "end");
    assert_int_equal(take(scene, "end", &dump), 0);
}

static void one_too_many_is_seen(void **state)
{
    struct scene *scene = *state;
    struct callgrind_dump dump;
    put_dump(scene, "counts.1", 1, "call");
    put_dump(scene, "counts.1", 1, "call");
    assert_int_equal(take(scene, "call", &dump), -1);
}

static void one_in_place_of_callgrinds_is_seen_by_the_next(void **state)
{
    struct scene *scene = *state;
    struct callgrind_dump dump;
    put_dump(scene, "counts.1", 1, "call");
    assert_int_equal(take(scene, "call", &dump), 0);
    put_dump(scene, "counts", 1, "end");
    assert_int_equal(take(scene, "end", &dump), -1);
}

static void none_and_others_are_refused(void **state)
{
    struct scene *scene = *state;
    struct callgrind_dump dump;
    assert_int_equal(take(scene, "call", &dump), -1);
    put_dump(scene, "counts.2", 2, "Client Request");
    assert_int_equal(take(scene, "call", &dump), -1);
    put(scene, "counts.3", "rubbish");
    assert_int_equal(take(scene, "call", &dump), -1);
}

/* More than a pipe holds, in parts; then more than is read at all. */
static void long_ones_are_drained_up_to_a_limit(void **state)
{
    struct scene *scene = *state;
    struct callgrind_dump dump;
    char line[4096];
    memset(line, '#', sizeof line - 1);
    line[sizeof line - 2] = '\n';
    line[sizeof line - 1] = '\0';
    for (int i = 0; i < 50; i++) {
        put(scene, "counts.1", line);
        dumps_drain(&scene->dumps);
    }
    put_dump(scene, "counts.1", 1, "call");
    assert_int_equal(take(scene, "call", &dump), 0);
    for (int i = 0; i < 1100; i++) {
        dumps_drain(&scene->dumps);
        if (!scene->dumps.too_long)
            put(scene, "counts.2", line);
    }
    assert_true(scene->dumps.too_long);
    assert_int_equal(take(scene, "call", &dump), -1);
}

static void nobody_can_read_them_by_name(void **state)
{
    struct scene *scene = *state;
    char path[PATH_MAX + 16];
    struct stat about;
    snprintf(path, sizeof path, "%s/counts.3", scene->folder);
    assert_int_equal(stat(path, &about), 0);
    assert_true(S_ISFIFO(about.st_mode));
    assert_int_equal(about.st_mode & 0777, 0222);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(dumps_in_order_are_taken, set_up, tear_down),
        cmocka_unit_test_setup_teardown(one_too_many_is_seen, set_up, tear_down),
        cmocka_unit_test_setup_teardown(one_in_place_of_callgrinds_is_seen_by_the_next, set_up,
                                        tear_down),
        cmocka_unit_test_setup_teardown(none_and_others_are_refused, set_up, tear_down),
        cmocka_unit_test_setup_teardown(long_ones_are_drained_up_to_a_limit, set_up, tear_down),
        cmocka_unit_test_setup_teardown(nobody_can_read_them_by_name, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
