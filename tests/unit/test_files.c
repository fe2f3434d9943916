/* Opening what hostile code may have made. */
#include "graders/engine/base/files.h"

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
    const struct CMUnitTest tests[] = {cmocka_unit_test(only_regular_files_below_are_opened)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
