/* Numbers of the tables on the terminal; see table_parts.h. */
#include "bench/compare/table_parts.h"

double table_number(const json_t *object, const char *key)
{
    return json_number_value(json_object_get(object, key));
}

const char *table_text(const json_t *object, const char *key)
{
    const char *found = json_string_value(json_object_get(object, key));
    return found ? found : "";
}

void table_digits(char *out, double value)
{
    snprintf(out, TABLE_NUMBER, "%.*f", value < 10 ? 2 : value < 100 ? 1 : 0, value);
}

void table_time(char *out, double ns)
{
    char digits[TABLE_NUMBER];
    double scale = ns < 1e4 ? 1 : ns < 1e7 ? 1e3 : 1e6;
    table_digits(digits, ns / scale);
    snprintf(out, TABLE_NUMBER, "%.12s%s", digits, ns < 1e4 ? "" : ns < 1e7 ? " us" : " ms");
}

void table_grouped(char *out, long long value)
{
    char digits[TABLE_NUMBER];
    int length = snprintf(digits, sizeof digits, "%lld", value), at = 0;
    for (int i = 0; i < length && at < TABLE_NUMBER - 2; i++) {
        if (i > 0 && (length - i) % 3 == 0)
            out[at++] = ',';
        out[at++] = digits[i];
    }
    out[at] = '\0';
}

void table_interval(char *out, const json_t *interval, bool too_noisy)
{
    char median[TABLE_NUMBER], low[TABLE_NUMBER], high[TABLE_NUMBER];
    if (!json_is_number(json_object_get(interval, "median"))) {
        snprintf(out, TABLE_INTERVAL, "-");
        return;
    }
    table_digits(median, table_number(interval, "median"));
    table_digits(low, table_number(interval, "low"));
    table_digits(high, table_number(interval, "high"));
    snprintf(out, TABLE_INTERVAL, "%s [%s, %s]", too_noisy ? "~" : median, low, high);
}
