/* Numbers as people write them. */
#include "reference/base/decimal.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static void test_numbers_read_well(void **state)
{
    static const struct {
        double value, beside;
        const char *text;
    } rows[] = {{1.31, 1.25, "1.31"},
                {1.3098765, 1.25, "1.31"},
                {1.6, 1.6, "1.6"},
                {0, 0, "0"},
                {-23.125, 4, "-23.12"},
                {0.000123456, 1, "0.0001235"},
                {12345.678, 1, "12346"},
                {-987654321.5, 1, "-987654322"},
                {1e15, 1, "1000000000000000"},
                {1e300, 1, "1e+300"},
                /* what differs looks different */
                {1.2500001, 1.25, "1.2500001"},
                {1.25, 1.2500001, "1.25"},
                {12345.678, 12346, "12345.7"},
                {0.1 + 0.2, 0.3, "0.30000000000000004"}};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[DECIMAL_BYTES];
        decimal_write(rows[i].value, rows[i].beside, text);
        assert_string_equal(text, rows[i].text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_numbers_read_well)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
