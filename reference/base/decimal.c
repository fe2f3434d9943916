/* Numbers as people write them; see decimal.h. */
#include "reference/base/decimal.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

enum { FEWEST_DIGITS = 4, MOST_DIGITS = 17 /* tell any two doubles apart */ };

/* As many as the whole part has; huge numbers have an exponent anyway. */
static int whole_digits(double value)
{
    int digits = FEWEST_DIGITS;
    if (fabs(value) >= 1e16)
        return digits;
    double bound = 1e4;
    while (fabs(value) >= bound) {
        digits++;
        bound *= 10;
    }
    return digits;
}

void decimal_write(double value, double beside, char text[DECIMAL_BYTES])
{
    char other[DECIMAL_BYTES];
    bool differ = value < beside || value > beside;
    for (int digits = whole_digits(value); digits <= MOST_DIGITS; digits++) {
        snprintf(text, DECIMAL_BYTES, "%.*g", digits, value);
        snprintf(other, sizeof other, "%.*g", digits, beside);
        if (!differ || strcmp(text, other) != 0)
            return;
    }
}
