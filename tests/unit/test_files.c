/* Opening what hostile code may have made. */
#include "graders/engine/base/files.h"

#include <fcntl.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

static char top[] = "/tmp/test_files.XXXXXX";

static const char *in_top(const char *name)
{
    static char path[128];
    snprintf(path, sizeof path, "%s/%s", top, name);
    return path;
}

static void only_regular_files_below_are_opened(void **state)
{
    (void)state;
    static const char *const odd[] = {"link", "pipe", "folder", "..", "way/file", "absent", ""};
    struct error err;
    char *bytes;
    size_t count;
    assert_int_equal(file_write(in_top("file"), "text", 4, NULL), 0);
    assert_int_equal(mkdir(in_top("folder"), 0700), 0);
    assert_int_equal(symlink("file", in_top("link")), 0);
    assert_int_equal(symlink(".", in_top("way")), 0);
    assert_int_equal(mkfifo(in_top("pipe"), 0600), 0);
    int file = file_open_below(top, "file", NULL);
    assert_true(file >= 0);
    close(file);
    assert_int_equal(file_read_below(top, "file", 10, &bytes, &count, NULL), 0);
    assert_string_equal(bytes, "text");
    free(bytes);
    for (size_t i = 0; i < sizeof odd / sizeof odd[0]; i++) {
        err.text[0] = '\0';
        assert_int_equal(file_open_below(top, odd[i], &err), -1);
        assert_true(err.text[0] != '\0');
        assert_int_equal(file_read_below(top, odd[i], 10, &bytes, &count, NULL), -1);
    }
    assert_int_equal(file_open_below(in_top("link"), "x", NULL), -1);
}

/* Deeper than any path can be, with files that must go first, folders that forbid it, links that
 * lead elsewhere, and names like those that the removal itself gives. */
static void any_folder_is_removed(void **state)
{
    enum { DEPTH = 5000, WIDTH = 20 };
    char name[300];
    (void)state;
    int home = open(".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    assert_true(home >= 0);
    assert_int_equal(file_write(in_top("kept"), "text", 4, NULL), 0);
    assert_int_equal(mkdir(in_top("hostile"), 0700), 0);
    assert_int_equal(chdir(in_top("hostile")), 0);
    assert_int_equal(symlink("../kept", "link"), 0);
    assert_int_equal(symlink("..", "way"), 0);
    assert_int_equal(mkdir(".removed-0", 0700), 0);
    assert_int_equal(mkdir(".removed-0/full", 0700), 0);
    assert_int_equal(mkdir("closed", 0700), 0);
    assert_int_equal(mkdir("closed/folder", 0700), 0);
    assert_int_equal(mkdir("closed/folder/folder", 0), 0);
    assert_int_equal(chmod("closed/folder", 0100), 0);
    assert_int_equal(chmod("closed", 0), 0);
    memset(name, 'n', 200);
    for (int depth = 0; depth < DEPTH; depth++) {
        for (int i = 0; i < WIDTH && depth % 500 == 0; i++) {
            snprintf(name + 200, sizeof name - 200, "%d", i);
            assert_int_equal(mkdir(name, 0700), 0);
            strcat(name, "/x");
            assert_int_equal(symlink("..", name), 0);
        }
        assert_int_equal(mkdir("deep", 0700), 0);
        assert_int_equal(chdir("deep"), 0);
    }
    assert_int_equal(fchdir(home), 0);
    close(home);
    folder_remove(in_top("hostile"));
    assert_int_equal(access(in_top("hostile"), F_OK), -1);
    assert_int_equal(access(in_top("kept"), F_OK), 0);
    folder_remove(in_top("absent"));
    folder_remove(in_top("kept")); /* a file is removed, too */
    assert_int_equal(access(in_top("kept"), F_OK), -1);
}

static void a_link_is_not_followed(void **state)
{
    (void)state;
    assert_int_equal(mkdir(in_top("other"), 0700), 0);
    assert_int_equal(file_write(in_top("other/file"), "text", 4, NULL), 0);
    assert_int_equal(symlink("other", in_top("to-other")), 0);
    folder_remove(in_top("to-other"));
    assert_int_equal(access(in_top("other/file"), F_OK), 0);
    assert_int_equal(access(in_top("to-other"), F_OK), -1);
}

static int set_up(void **state)
{
    (void)state;
    return mkdtemp(top) ? 0 : -1;
}

static int tear_down(void **state)
{
    (void)state;
    folder_remove(top);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(only_regular_files_below_are_opened),
                                       cmocka_unit_test(any_folder_is_removed),
                                       cmocka_unit_test(a_link_is_not_followed)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
