/* Control groups of engines that were killed: those go, everybody else's stay. In a folder that
 * plays the file system of groups, and, for root, in the real one. */
#include "graders/box/inside.h"

#include <errno.h>
#include <fcntl.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

enum { PATH_BYTES = 512 };

static char top[64];

/* Makes a folder below the top one, and says where. */
static const char *make(const char *name)
{
    static char path[PATH_BYTES];
    snprintf(path, sizeof path, "%s/%s", top, name);
    assert_int_equal(mkdir(path, 0700), 0);
    return path;
}

static bool is_there(const char *name)
{
    char path[PATH_BYTES];
    snprintf(path, sizeof path, "%s/%s", top, name);
    return access(path, F_OK) == 0;
}

/* The name of a group of a process that has ended. */
static void name_of_the_dead(char out[LEFTOVERS_NAME])
{
    int ends[2];
    assert_int_equal(pipe(ends), 0);
    pid_t child = fork();
    if (child == 0) {
        leftovers_name(out, 3);
        _exit(write(ends[1], out, LEFTOVERS_NAME) != LEFTOVERS_NAME);
    }
    assert_true(child > 0);
    assert_int_equal(read(ends[0], out, LEFTOVERS_NAME), LEFTOVERS_NAME);
    assert_int_equal(waitpid(child, NULL, 0), child);
    close(ends[0]);
    close(ends[1]);
}

/* `name` with another number in one of its parts, counted from 1. */
static void changed(char out[LEFTOVERS_NAME + 8], const char *name, int part)
{
    const char *at = name;
    for (int i = 0; i < part; i++)
        at = strchr(at, '.') + 1;
    snprintf(out, LEFTOVERS_NAME + 8, "%.*s7%s", (int)(at - name), name, at);
}

static void groups_of_the_dead_go(void **state)
{
    (void)state;
    char dead[LEFTOVERS_NAME], reused[LEFTOVERS_NAME + 8], mine[LEFTOVERS_NAME], deeper[256];
    name_of_the_dead(dead);
    leftovers_name(mine, 1);
    changed(reused, mine, 2);
    make("session");
    make("session/inner");
    snprintf(deeper, sizeof deeper, "session/inner/%s", dead);
    make(deeper);
    make(dead);
    make(reused);
    leftovers_sweep(top);
    assert_false(is_there(dead));
    assert_false(is_there(deeper));
    assert_false(is_there(reused)); /* the process of that id started at another time */
    assert_true(is_there("session/inner"));
}

static void all_others_stay(void **state)
{
    (void)state;
    char dead[LEFTOVERS_NAME], mine[LEFTOVERS_NAME], elsewhere[LEFTOVERS_NAME + 8], path[256];
    name_of_the_dead(dead);
    leftovers_name(mine, 1);
    changed(elsewhere, dead, 3);
    make(mine);
    make(elsewhere); /* of another namespace of process ids */
    make(dead);
    snprintf(path, sizeof path, "%s/cgroup.procs", dead);
    make(path); /* in use: not empty */
    make("meshgrade.");
    make("meshgrade.1x.2.3.4");
    make("meshgrade.999999999");
    leftovers_sweep(top);
    assert_true(is_there(mine));
    assert_true(is_there(elsewhere));
    assert_true(is_there(dead));
    assert_true(is_there("meshgrade."));
    assert_true(is_there("meshgrade.1x.2.3.4"));
    assert_true(is_there("meshgrade.999999999"));
}

/* The real file system of groups: another part of it than the engine's own. */
static void real_groups_go(void **state)
{
    (void)state;
    static const char *const roots[] = {"/sys/fs/cgroup/pids", "/sys/fs/cgroup"};
    char dead[LEFTOVERS_NAME], outer[128], left[256], kept[256];
    const char *root = access(roots[0], F_OK) == 0 ? roots[0] : roots[1];
    snprintf(outer, sizeof outer, "%s/meshgrade-test-%d", root, (int)getpid());
    if (mkdir(outer, 0755) != 0) {
        print_message("no control groups to make here: %s\n", strerror(errno));
        skip();
    }
    char mine[LEFTOVERS_NAME];
    name_of_the_dead(dead);
    leftovers_name(mine, 1);
    snprintf(left, sizeof left, "%s/%s", outer, dead);
    snprintf(kept, sizeof kept, "%s/%s", outer, mine);
    assert_int_equal(mkdir(left, 0755), 0);
    assert_int_equal(mkdir(kept, 0755), 0);
    leftovers_sweep(root);
    bool is_gone = access(left, F_OK) != 0, is_kept = access(kept, F_OK) == 0;
    rmdir(left);
    rmdir(kept);
    rmdir(outer);
    assert_true(is_gone);
    assert_true(is_kept);
}

static int set_up(void **state)
{
    (void)state;
    strcpy(top, "/tmp/test_leftovers.XXXXXX");
    return mkdtemp(top) ? 0 : -1;
}

static int tear_down(void **state)
{
    char command[128];
    (void)state;
    snprintf(command, sizeof command, "rm -r %s", top);
    return system(command);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(groups_of_the_dead_go, set_up, tear_down),
        cmocka_unit_test_setup_teardown(all_others_stay, set_up, tear_down),
        cmocka_unit_test_setup_teardown(real_groups_go, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
