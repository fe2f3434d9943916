/* Names that students chose, as folders and as text. */
#include "graders/engine/upload/names.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void names_become_folders(void **state)
{
    (void)state;
    static const char *const rows[][2] = {{"Ana Pérez", "Ana-Perez"},
                                          {"jose\xcc\x81", "jose"},
                                          {"../../etc/passwd", "etc-passwd"},
                                          {"-rf", "rf"},
                                          {"=HYPERLINK(1)", "HYPERLINK-1"},
                                          {"<script>", "script"},
                                          {"李", "student"},
                                          {"", "student"},
                                          {".hidden.", "hidden"},
                                          {"a  b", "a-b"},
                                          {"ulises_ortega", "ulises_ortega"}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char slug[NAMES_SLUG];
        names_slug(slug, rows[i][0]);
        assert_string_equal(slug, rows[i][1]);
    }
    char longest[300], slug[NAMES_SLUG];
    memset(longest, 'a', sizeof longest - 1);
    longest[sizeof longest - 1] = '\0';
    names_slug(slug, longest);
    assert_int_equal(strlen(slug), NAMES_SLUG - 1);
}

static void any_bytes_become_utf8(void **state)
{
    (void)state;
    static const char *const rows[][2] = {{"ok", "ok"},
                                          {"é", "é"},
                                          {"\xe9", "\xef\xbf\xbd"},
                                          {"\xc0\xaf", "\xef\xbf\xbd\xef\xbf\xbd"},
                                          {"\xed\xa0\x80", "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd"},
                                          {"\xf5x", "\xef\xbf\xbdx"},
                                          {"\xe2\x82", "\xef\xbf\xbd\xef\xbf\xbd"},
                                          {"\xf0\x9f\x98\x80", "\xf0\x9f\x98\x80"}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char *text = names_utf8(rows[i][0], strlen(rows[i][0]));
        assert_non_null(text);
        assert_string_equal(text, rows[i][1]);
        free(text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_become_folders),
        cmocka_unit_test(any_bytes_become_utf8),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
