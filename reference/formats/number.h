/* Decimal numbers in text, read fast and exactly: the common forms only. What is not of a common
 * form, or cannot be rounded with certainty, is left to the slow way (strtof and its like), which
 * gives the same value wherever both give one.
 *
 * number_integer, number_float and number_double read the number that starts at `at` and return the
 * place behind it, or NULL for the slow way. Of the text after `at` some character must not belong
 * to a number (a line end, say), and seven bytes behind that one must be readable too.
 *
 * They stand here as inline functions because a mesh file is nothing but numbers.
 *
 * Source: eight digits at once after Lemire (Quickly parsing eight digits, 2018); exact small
 * powers of ten after Clinger (How to Read Floating Point Numbers Accurately, 1990). */
#ifndef REFERENCE_FORMATS_NUMBER_H
#define REFERENCE_FORMATS_NUMBER_H

#include <endian.h>
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { NUMBER_OVERREAD = 7 }; /* bytes looked at behind the character that ends a number */

/* Reads the digits at `at`, at most eight; returns how many there are. */
static inline int number_take_eight(const char *at, uint64_t *value)
{
    const uint64_t every = UINT64_C(0x0101010101010101);
    uint64_t text;
    memcpy(&text, at, sizeof text);
    text = le64toh(text);
    /* The high bit of the first byte that is no digit is set; of the digits before it, clear. */
    uint64_t others = ((text + 0x46 * every) | (text - 0x30 * every)) & 0x80 * every;
    int bits = others ? __builtin_ctzll(others) - 7 : 64;
    /* Digits to the high bytes, zeros before them (in two shifts, since none can be by 64); then
     * neighbours are joined: 8 x 1 digit to 4 x 2, to 2 x 4, to 8. */
    uint64_t digits = bits ? (text & 0x0f * every) << (64 - bits) : 0;
    digits = digits * 10 + (digits >> 8);
    *value =
        (uint32_t)(((digits & UINT64_C(0x000000ff000000ff)) * UINT64_C(0x000f424000000064) +
                    (digits >> 16 & UINT64_C(0x000000ff000000ff)) * UINT64_C(0x0000271000000001)) >>
                   32);
    return bits / 8;
}

/* Appends all digits at `at` to *value; of more than 19 digits the value is garbage. */
static inline const char *number_take_digits(const char *at, uint64_t *value)
{
    static const uint64_t power_of_ten[] = {1,      10,      100,      1000,     10000,
                                            100000, 1000000, 10000000, 100000000};
    for (;;) {
        uint64_t digits;
        int taken = number_take_eight(at, &digits);
        *value = *value * power_of_ten[taken] + digits;
        at += taken;
        if (taken < 8)
            return at;
    }
}

/* As number_integer, for what has a sign or more than seven digits. */
static inline const char *number_long_integer(const char *at, int64_t *value)
{
    bool is_negative = *at == '-';
    at += *at == '-' || *at == '+';
    uint64_t magnitude = 0;
    const char *end = number_take_digits(at, &magnitude);
    if (end == at || end - at > 15)
        return NULL;
    *value = is_negative ? -(int64_t)magnitude : (int64_t)magnitude;
    return end;
}

/* A sign or none, then at most 15 digits. */
static inline const char *number_integer(const char *at, int64_t *value)
{
    uint64_t digits;
    int taken = number_take_eight(at, &digits);
    if (taken == 0 || taken == 8)
        return number_long_integer(at, value);
    *value = (int64_t)digits;
    return at + taken;
}

/* mantissa * 10^exponent, and the sign of both zeros. */
struct number_decimal {
    int64_t mantissa; /* not negative */
    int exponent;
    bool is_negative;
};

static inline const char *number_take_exponent(const char *at, int *exponent)
{
    int64_t value;
    const char *end = number_long_integer(at, &value);
    if (!end || end - at > 4)
        return NULL;
    *exponent += (int)value;
    return end;
}

static inline const char *number_take_decimal(const char *at, struct number_decimal *d)
{
    uint64_t mantissa = 0;
    int exponent = 0;
    d->is_negative = *at == '-';
    at += *at == '-' || *at == '+';
    const char *start = at;
    /* In front of the point few digits are usual. */
    for (unsigned digit; (digit = (unsigned)(unsigned char)*at - '0') <= 9; at++)
        mantissa = 10 * mantissa + digit;
    ptrdiff_t count = at - start;
    if (*at == '.') {
        const char *point = at;
        at = number_take_digits(point + 1, &mantissa);
        ptrdiff_t decimals = at - point - 1;
        count += decimals;
        exponent = decimals <= 19 ? -(int)decimals : 0;
    }
    d->mantissa = (int64_t)mantissa;
    d->exponent = exponent;
    if (count == 0 || count > 19 || d->mantissa < 0)
        return NULL;
    return (*at | 0x20) == 'e' ? number_take_exponent(at + 1, &d->exponent) : at;
}

/* The decimal without its sign, in one rounding when the mantissa fits binary64 and in two
 * otherwise; false when the power of ten is none of the exact ones. */
static inline bool number_magnitude(const struct number_decimal *d, double *magnitude)
{
    static const double exact[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                   1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                   1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    int power = abs(d->exponent);
    if (power >= (int)(sizeof exact / sizeof *exact))
        return false;
    double mantissa = (double)d->mantissa;
    *magnitude = d->exponent < 0 ? mantissa / exact[power] : mantissa * exact[power];
    return true;
}

/* Whether a double that is at most `slack` units in the last place from a number rounds to the same
 * float as the number: it does unless the middle between two floats lies as near. */
static inline bool number_rounds_safely(double magnitude)
{
    const uint64_t middle = UINT64_C(1) << 28, slack = 4;
    uint64_t bits;
    memcpy(&bits, &magnitude, sizeof bits);
    uint64_t below_float = bits & (2 * middle - 1);
    return below_float - (middle - slack) > 2 * slack;
}

/* A sign or none, at most 19 digits with or without a point, an exponent of ten or none. The value
 * is the binary32 that is nearest to the number, ties to even; never infinite. */
static inline const char *number_float(const char *at, float *value)
{
    struct number_decimal d;
    double magnitude;
    at = number_take_decimal(at, &d);
    if (!at || !number_magnitude(&d, &magnitude))
        return NULL;
    /* Floats that are subnormal have fewer digits, so that their middles lie elsewhere. */
    bool is_normal = magnitude >= (double)FLT_MIN && magnitude <= (double)FLT_MAX;
    if (!(is_normal && number_rounds_safely(magnitude)) && d.mantissa != 0)
        return NULL;
    *value = copysignf((float)magnitude, d.is_negative ? -1.0F : 1.0F);
    return at;
}

/* As number_float, for the nearest binary64. */
static inline const char *number_double(const char *at, double *value)
{
    struct number_decimal d;
    double magnitude;
    at = number_take_decimal(at, &d);
    if (!at || d.mantissa > INT64_C(1) << 53 || !number_magnitude(&d, &magnitude))
        return NULL;
    *value = copysign(magnitude, d.is_negative ? -1.0 : 1.0);
    return at;
}

#endif
