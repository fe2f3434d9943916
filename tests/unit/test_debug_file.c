/* The dynamic linker's debug file: where it is, it is found; a name that does not fit is none. */
#include "graders/engine/run/debug_file.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

/* What binutils says of the same file. Empty: there is no such debug file here. */
static void ask_readelf(char *path, size_t capacity)
{
    char id[128] = "";
    FILE *pipe = popen("readelf -n /lib64/ld-linux-x86-64.so.2 | sed -n 's/.*Build ID: //p'", "r");
    assert_non_null(pipe);
    if (fscanf(pipe, "%127s", id) != 1)
        id[0] = '\0';
    pclose(pipe);
    snprintf(path, capacity, "/usr/lib/debug/.build-id/%.2s/%s.debug", id, id[0] ? id + 2 : "");
    if (access(path, R_OK) != 0)
        path[0] = '\0';
}

static void the_file_is_the_one_of_the_build_id(void **state)
{
    char expected[256], path[256];
    (void)state;
    ask_readelf(expected, sizeof expected);
    if (!debug_file_of_linker(path, sizeof path))
        path[0] = '\0';
    assert_string_equal(path, expected);
}

static void a_name_that_does_not_fit_is_none(void **state)
{
    char path[256];
    (void)state;
    for (size_t capacity = 1; capacity < 60; capacity++)
        assert_false(debug_file_of_linker(path, capacity));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_file_is_the_one_of_the_build_id),
        cmocka_unit_test(a_name_that_does_not_fit_is_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
