/* Untrusted text comes out visible and inert (graders/report/clean.h). */
#include "graders/report/clean.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

struct example {
    const char *text;
    size_t length;
    enum clean_form form;
    const char *expected;
};
#define BYTES(literal) literal, sizeof(literal) - 1

static const struct example examples[] = {
    {BYTES("plain"), CLEAN_LINE, "plain"},
    {BYTES("Ñandú 日本 e\xcc\x81"), CLEAN_LINE, "Ñandú 日本 e\xcc\x81"},
    {BYTES("a\nb\tc"), CLEAN_LINE, "a\\x0ab\\x09c"},
    {BYTES("a\nb\tc"), CLEAN_BLOCK, "a\nb\tc"},
    {BYTES("a\r\nb\rc"), CLEAN_BLOCK, "a\nb\\x0dc"},
    {BYTES("\x1b[2J\x1b]8;;http://x\x07"), CLEAN_BLOCK, "\\x1b[2J\\x1b]8;;http://x\\x07"},
    {BYTES("nul\0here"), CLEAN_LINE, "nul\\x00here"},
    {BYTES("\x7f"), CLEAN_LINE, "\\x7f"},
    {BYTES("\xc2\x9b"
           "31m"),
     CLEAN_LINE, "<U+009B>31m"},
    {BYTES("user\xe2\x80\xae"
           "cod.c"),
     CLEAN_LINE, "user<U+202E>cod.c"},
    {BYTES("\xe2\x80\xa8\xe2\x81\xa6\xef\xbb\xbf"), CLEAN_BLOCK, "<U+2028><U+2066><U+FEFF>"},
    {BYTES("\xf3\xa0\x80\x81"), CLEAN_LINE, "<U+E0001>"},
    {BYTES("\xef\xbf\xbf\xef\xb7\x90"), CLEAN_LINE, "<U+FFFF><U+FDD0>"},
    {BYTES("\xed\xa0\x80"), CLEAN_LINE, "\\xed\\xa0\\x80"}, /* a lone surrogate */
    {BYTES("\xc0\xaf\xff\xfe"), CLEAN_LINE, "\\xc0\\xaf\\xff\\xfe"},
    {BYTES("\xf4\x90\x80\x80"), CLEAN_LINE, "\\xf4\\x90\\x80\\x80"},
    {BYTES("cut \xe2\x82"), CLEAN_LINE, "cut \\xe2\\x82"},
    {BYTES(""), CLEAN_LINE, ""},
};

static void test_examples(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof examples / sizeof *examples; i++) {
        const struct example *e = &examples[i];
        char *clean = clean_text(e->text, e->length, e->form, 1000);
        assert_string_equal(clean, e->expected);
        free(clean);
    }
}

static void test_long_text_is_cut_at_a_character(void **state)
{
    (void)state;
    char *clean = clean_text("ab\xc3\xb1z", 5, CLEAN_LINE, 3);
    assert_string_equal(clean, "ab [... 3 bytes more]");
    free(clean);

    size_t length = 1000000;
    char *line = malloc(length);
    assert_non_null(line);
    memset(line, 0x1b, length);
    clean = clean_text(line, length, CLEAN_LINE, 500);
    assert_true(strlen(clean) <= 4 * 500 + 40);
    assert_non_null(strstr(clean, " [... 999500 bytes more]"));
    free(clean);
    free(line);
}

/* Any bytes at all: the answer holds no control character and is stable under cleaning anew. */
static void test_any_bytes(void **state)
{
    (void)state;
    uint64_t seed = 20240917;
    for (int round = 0; round < 2000; round++) {
        char bytes[64];
        for (size_t i = 0; i < sizeof bytes; i++) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            bytes[i] = (char)(seed >> (round % 2 ? 56 : 57));
        }
        char *once = clean_text(bytes, sizeof bytes, CLEAN_LINE, sizeof bytes);
        for (const char *c = once; *c; c++)
            assert_true((unsigned char)*c >= 0x20 && *c != 0x7f);
        char *twice = clean_text(once, strlen(once), CLEAN_LINE, 1000);
        assert_string_equal(once, twice);
        free(once);
        free(twice);
    }
}

static void test_columns(void **state)
{
    (void)state;
    assert_int_equal(clean_columns("abc"), 3);
    assert_int_equal(clean_columns("ñandú"), 5);
    assert_int_equal(clean_columns("日本"), 4);
    assert_int_equal(clean_columns("e\xcc\x81"), 1);
    assert_int_equal(clean_prefix("日本", 3), 3);
    assert_int_equal(clean_prefix("ñandú", 2), 3);
    assert_int_equal(clean_prefix("abc", 80), 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_examples),
        cmocka_unit_test(test_long_text_is_cut_at_a_character),
        cmocka_unit_test(test_any_bytes),
        cmocka_unit_test(test_columns),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
