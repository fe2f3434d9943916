/* The writer of HTML escapes whatever it is given (graders/report/html.h). */
#include "graders/report/html.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void test_text_and_attributes_are_escaped(void **state)
{
    (void)state;
    struct html page;
    assert_int_equal(html_start(&page, NULL), 0);
    html_open(&page, "p");
    html_attribute(&page, "title", "\"><script>alert('1')</script>&\n");
    html_text(&page, "</p><script>alert(1)</script> & \x1b[2J \xe2\x80\xae");
    html_close(&page, "p");
    assert_int_equal(html_finish(&page, NULL), 0);
    assert_string_equal(page.text,
                        "<!DOCTYPE html>\n\n<p title=\"&quot;&gt;&lt;script&gt;alert(&#39;1&#39;)"
                        "&lt;/script&gt;&amp;\n\">&lt;/p&gt;&lt;script&gt;alert(1)&lt;/script&gt; "
                        "&amp; \\x1b[2J &lt;U+202E&gt;</p>");
    html_release(&page);
}

static void test_paths_cannot_hold_a_scheme(void **state)
{
    (void)state;
    struct html page;
    assert_int_equal(html_start(&page, NULL), 0);
    html_open(&page, "a");
    html_path(&page, "href", "javascript:alert(1)?a=\"b\" c/d.html#e");
    html_close(&page, "a");
    assert_int_equal(html_finish(&page, NULL), 0);
    assert_non_null(strstr(page.text, "<a href=\"javascript%3Aalert%281%29%3Fa%3D%22b%22%20c/d.html"
                                      "#e\"></a>"));
    html_release(&page);
}

static void test_json_strings_with_nul_are_shown_whole(void **state)
{
    (void)state;
    struct html page;
    json_t *text = json_stringn("a\0b", 3);
    assert_int_equal(html_start(&page, NULL), 0);
    html_open(&page, "p");
    html_json(&page, text);
    html_close(&page, "p");
    assert_int_equal(html_finish(&page, NULL), 0);
    assert_non_null(strstr(page.text, "<p>a\\x00b</p>"));
    html_release(&page);
    json_decref(text);
}

static void test_very_long_text_is_cut(void **state)
{
    (void)state;
    enum { LENGTH = 1 << 20 };
    struct html page;
    char *line = malloc(LENGTH + 1);
    assert_non_null(line);
    memset(line, '<', LENGTH);
    line[LENGTH] = '\0';
    assert_int_equal(html_start(&page, NULL), 0);
    html_open(&page, "p");
    html_text(&page, line);
    html_close(&page, "p");
    assert_int_equal(html_finish(&page, NULL), 0);
    assert_true(page.length < 5 * HTML_TEXT_LIMIT_BYTES);
    assert_non_null(strstr(page.text, "bytes more]"));
    html_release(&page);
    free(line);
}

static void test_wrong_nesting_is_told(void **state)
{
    (void)state;
    struct error err = {""};
    struct html page;
    assert_int_equal(html_start(&page, &err), 0);
    html_open(&page, "p");
    html_open(&page, "b");
    html_close(&page, "p");
    assert_int_equal(html_finish(&page, &err), -1);
    assert_non_null(strstr(err.text, "innermost"));
    html_release(&page);

    err.text[0] = '\0';
    assert_int_equal(html_start(&page, &err), 0);
    html_open(&page, "p");
    html_text(&page, "");
    html_attribute(&page, "class", "late");
    html_close(&page, "p");
    assert_int_equal(html_finish(&page, &err), -1);
    assert_non_null(strstr(err.text, "attribute"));
    html_release(&page);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_text_and_attributes_are_escaped),
        cmocka_unit_test(test_paths_cannot_hold_a_scheme),
        cmocka_unit_test(test_json_strings_with_nul_are_shown_whole),
        cmocka_unit_test(test_very_long_text_is_cut),
        cmocka_unit_test(test_wrong_nesting_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
