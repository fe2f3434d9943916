/* The fast numbers of the readers are those of the C library, bit for bit, wherever they give one.
 */
#include "reference/base/random.h"
#include "reference/formats/number.h"
#include "reference/formats/scan.h"

#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { TEXT_SIZE = 200 };

static float float_of(uint32_t bits)
{
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* Compares both fast functions with the library on one text; returns whether number_float took it.
 */
static bool assert_as_library(const char *text)
{
    char padded[TEXT_SIZE + NUMBER_OVERREAD] = "", *end;
    snprintf(padded, sizeof padded, "%s\n", text);
    float f;
    const char *behind = number_float(padded, &f);
    float expected_float = strtof(padded, &end);
    if (behind && (behind != end || memcmp(&f, &expected_float, sizeof f) != 0))
        fail_msg("float %s: %.9g, expected %.9g", text, (double)f, (double)expected_float);
    bool was_taken = behind != NULL;
    double d;
    behind = number_double(padded, &d);
    double expected_double = strtod(padded, &end);
    if (behind && (behind != end || memcmp(&d, &expected_double, sizeof d) != 0))
        fail_msg("double %s: %.17g, expected %.17g", text, d, expected_double);
    return was_taken;
}

/* A text of the given kind; the kinds are those of files, then ever harder ones. */
static void write_number(struct random *rng, int kind, char *text)
{
    float any = float_of((uint32_t)random_next(rng));
    double real = random_real(rng);
    uint32_t below;
    switch (kind) {
    case 0: /* as our writers and many others do */
        snprintf(text, TEXT_SIZE, "%.9g", 4.0 * real - 2.0);
        break;
    case 1:
        snprintf(text, TEXT_SIZE, "%.*f", (int)random_below(rng, 10), 2000.0 * real - 1000.0);
        break;
    case 2:
        snprintf(text, TEXT_SIZE, "%.9g", (double)any);
        break;
    case 3: /* all digits of a double */
        snprintf(text, TEXT_SIZE, "%.17g", 100.0 * real - 50.0);
        break;
    case 4: /* any digits and exponent */
        snprintf(text, TEXT_SIZE, "%" PRIu64 ".%" PRIu64 "e%d",
                 random_next(rng) >> random_below(rng, 64),
                 random_next(rng) >> random_below(rng, 64), (int)random_below(rng, 100) - 60);
        break;
    default: /* in the middle of two floats, or next to it */
        below = (uint32_t)random_below(rng, UINT32_C(0x7f7fffff));
        snprintf(text, TEXT_SIZE, "%.*g", 15 + (int)random_below(rng, 20),
                 ((double)float_of(below) + (double)float_of(below + 1)) / 2.0);
        if (random_below(rng, 2) == 0)
            for (char *last = text; *last; last++)
                if (last[1] == 'e' || last[1] == '\0') {
                    *last = (char)('0' + random_below(rng, 10));
                    break;
                }
    }
}

static void fast_values_are_those_of_the_library(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 1);
    for (int kind = 0; kind < 6; kind++) {
        int taken = 0;
        const int count = 250000;
        for (int i = 0; i < count; i++) {
            char text[TEXT_SIZE] = "";
            write_number(&rng, kind, text);
            taken += assert_as_library(text);
        }
        if (kind < 2)
            assert_true(taken > count - count / 100); /* it is of use */
    }
}

static void hard_texts_are_read_right_or_left(void **state)
{
    (void)state;
    static const char *const texts[] = {"0",
                                        "-0",
                                        "+0.0",
                                        "0e5",
                                        ".5",
                                        "5.",
                                        ".",
                                        "-",
                                        "+",
                                        "",
                                        "e5",
                                        "1e",
                                        "1e+",
                                        "1e-",
                                        "1e5",
                                        "1E+05",
                                        "1e-05",
                                        "1e22",
                                        "1e23",
                                        "1e-22",
                                        "1e-23",
                                        "1e99999999",
                                        "1e-99999999",
                                        "--1",
                                        "+-1",
                                        "1-2",
                                        "1.2.3",

                                        "inf",
                                        "nan",
                                        "16777217",
                                        "16777216",
                                        "16777219",
                                        "33554434.5",
                                        "3.4028235e38",
                                        "3.4028236e38",
                                        "3.40282356e38",
                                        "340282356779733661637539395458142568447",
                                        "1.17549435e-38",
                                        "1.17549428e-38",
                                        "1e-45",
                                        "7e-46",
                                        "9007199254740992",
                                        "9007199254740993",
                                        "9223372036854775807",
                                        "9223372036854775808",
                                        "18446744073709551616",
                                        "99999999999999999999",
                                        "0.1",
                                        "0.00000000000000000001",
                                        "0.000000000000000000000001",
                                        "00000000000000000001.5",
                                        "12345678",
                                        "123456789",
                                        "1234567890123456789",
                                        "0.12345678",
                                        "0.123456789012345678",
                                        "1.00000005960464477539",
                                        "1.000000059604644775390625"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        assert_as_library(texts[i]);
}

static void integers_are_read_or_left(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 2);
    for (int i = 0; i < 200000; i++) {
        char text[TEXT_SIZE];
        int64_t value = -1, number = (int64_t)(random_next(&rng) >> random_below(&rng, 64));
        number = random_below(&rng, 2) == 0 && number > INT64_MIN ? -number : number;
        int length = snprintf(text, sizeof text, "%" PRId64 "/", number);
        const char *behind = number_integer(text, &value);
        if (!behind) {
            assert_true(length > 16);
            continue;
        }
        assert_int_equal(value, number);
        assert_int_equal(*behind, '/');
    }
    int64_t value;
    static const char *const wrong[] = {"\n       ",
                                        "-\n       ",
                                        "x\n       ",
                                        "+-1\n       ",
                                        "-9223372036854775808\n       ",
                                        "-92233720368547758080000000000\n       "};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_null(number_integer(wrong[i], &value));
}

/* Every byte but digits ends a run of digits, wherever it stands. */
static void digits_end_at_any_other_byte(void **state)
{
    (void)state;
    for (int place = 0; place < 8; place++)
        for (int byte = 0; byte < 256; byte++) {
            char text[8];
            memset(text, '7', sizeof text);
            text[place] = (char)byte;
            uint64_t value, expected = 0;
            bool is_digit = byte >= '0' && byte <= '9';
            int count = is_digit ? 8 : place;
            for (int i = 0; i < count; i++)
                expected = 10 * expected + (uint64_t)(text[i] - '0');
            assert_int_equal(number_take_eight(text, &value), count);
            assert_int_equal(value, expected);
        }
}

/* What the readers call: the fast way and the slow one together are the library. */
static void tokens_are_read_as_the_library_does(void **state)
{
    (void)state;
    struct scan scan;
    struct random rng;
    random_init(&rng, 3);
    assert_int_equal(scan_init(&scan, NULL, 0, "file", NULL), 0);
    for (int i = 0; i < 300000; i++) {
        char text[TEXT_SIZE] = "";
        write_number(&rng, i % 6, text);
        struct token token = {text, strlen(text)};
        float f, expected_float = strtof(text, NULL);
        double d, expected_double = strtod(text, NULL);
        if (scan_float(&scan, &token, "x", &f))
            assert_false(isfinite(expected_float) && strpbrk(text, "in") == NULL);
        else
            assert_memory_equal(&f, &expected_float, sizeof f);
        if (scan_double(&scan, &token, "x", &d) == 0)
            assert_memory_equal(&d, &expected_double, sizeof d);
    }
    scan_release(&scan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fast_values_are_those_of_the_library),
        cmocka_unit_test(hard_texts_are_read_right_or_left),
        cmocka_unit_test(integers_are_read_or_left),
        cmocka_unit_test(digits_end_at_any_other_byte),
        cmocka_unit_test(tokens_are_read_as_the_library_does),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
