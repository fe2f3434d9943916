/* Tokens, lines and numbers of text in memory; see scan.h. */
#include "reference/formats/scan.h"

#include "reference/formats/number.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int scan_init(struct scan *scan, const void *bytes, size_t byte_count, const char *name,
              struct error *err)
{
    *scan = (struct scan){
        .bytes = bytes, .byte_count = byte_count, .line = 1, .name = name, .err = err};
    scan->c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (!scan->c_locale)
        return error_set(err, "%s: out of memory", name);
    if (byte_count >= 3 && memcmp(bytes, "\xef\xbb\xbf", 3) == 0)
        scan->at = 3;
    /* The last line end with enough bytes behind it: number.h needs both. */
    const char *last = NULL;
    if (byte_count > NUMBER_OVERREAD)
        last = memrchr(bytes, '\n', byte_count - NUMBER_OVERREAD);
    scan->plain_end = last ? (size_t)(last - scan->bytes) : 0;
    return 0;
}

void scan_release(struct scan *scan)
{
    if (scan->c_locale)
        freelocale(scan->c_locale);
    *scan = (struct scan){0};
}

size_t scan_left(const struct scan *scan)
{
    return scan->byte_count - scan->at;
}

/* -- lines and tokens ------------------------------------------------------------------------- */

/* Length of the line end at `at`: 0 (there is none), 1 or 2. */
static size_t line_end_length(const struct scan *scan, size_t at)
{
    if (at >= scan->byte_count)
        return 0;
    if (scan->bytes[at] == '\n')
        return 1;
    if (scan->bytes[at] != '\r')
        return 0;
    bool pair = !scan->line_ends_by_cr && at + 1 < scan->byte_count && scan->bytes[at + 1] == '\n';
    return pair ? 2 : 1;
}

/* Length of a backslash and the line end after it, 0 when there is none. */
static size_t continuation_length(const struct scan *scan)
{
    if (!scan->is_continued || scan->bytes[scan->at] != '\\')
        return 0;
    size_t end = line_end_length(scan, scan->at + 1);
    return end > 0 ? 1 + end : 0;
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/* Whether c neither ends a token or line nor starts a comment or continuation, in any format. */
static inline bool is_ordinary(char c)
{
    return (unsigned char)c > ' ' && c != '#' && c != '\\';
}

/* Goes over blanks, continued line ends and, up to the line's end, a comment. */
static void skip_blanks(struct scan *scan)
{
    while (scan->at < scan->byte_count) {
        size_t continuation = continuation_length(scan);
        if (continuation > 0) {
            scan->at += continuation;
            scan->line++;
        } else if (is_blank(scan->bytes[scan->at])) {
            scan->at++;
        } else {
            break;
        }
    }
    if (scan->comment && scan->at < scan->byte_count && scan->bytes[scan->at] == scan->comment)
        while (scan->at < scan->byte_count && line_end_length(scan, scan->at) == 0)
            scan->at++;
}

bool scan_token(struct scan *scan, struct token *token)
{
    skip_blanks(scan);
    size_t start = scan->at;
    while (scan->at < scan->byte_count &&
           (is_ordinary(scan->bytes[scan->at]) ||
            (line_end_length(scan, scan->at) == 0 && !is_blank(scan->bytes[scan->at]) &&
             continuation_length(scan) == 0 &&
             !(scan->comment && scan->bytes[scan->at] == scan->comment))))
        scan->at++;
    *token = (struct token){scan->bytes + start, scan->at - start};
    return token->length > 0;
}

void scan_end_line(struct scan *scan)
{
    struct token ignored;
    bool goes_on = true;
    while (goes_on) {
        while (scan->at < scan->byte_count && is_ordinary(scan->bytes[scan->at]))
            scan->at++;
        goes_on = scan_token(scan, &ignored);
    }
    size_t end = line_end_length(scan, scan->at);
    if (end > 0) {
        if (scan->line == 1 && end == 1 && scan->bytes[scan->at] == '\r')
            scan->line_ends_by_cr = true;
        scan->at += end;
        scan->line++;
    }
}

bool scan_find_token(struct scan *scan)
{
    for (;;) {
        skip_blanks(scan);
        if (scan->at >= scan->byte_count)
            return false;
        if (line_end_length(scan, scan->at) == 0)
            return true;
        scan_end_line(scan);
    }
}

/* -- errors ----------------------------------------------------------------------------------- */

/* The end of the file's name matters most: of a long path only that is shown. */
static const char *short_name(const char *name)
{
    const size_t most = 200;
    size_t length = strlen(name);
    return length > most ? name + length - most : name;
}

static void record(const struct scan *scan, const char *place, long long number, const char *format,
                   va_list arguments)
{
    char text[300];
    vsnprintf(text, sizeof text, format, arguments);
    error_set(scan->err, "%s:%s%lld: %s", short_name(scan->name), place, number, text);
}

int scan_error(const struct scan *scan, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    if (scan->is_binary)
        record(scan, " byte ", (long long)scan->item, format, arguments);
    else
        record(scan, "", (long long)scan->line, format, arguments);
    va_end(arguments);
    return -1;
}

int scan_error_at(const struct scan *scan, int64_t line, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    record(scan, "", (long long)line, format, arguments);
    va_end(arguments);
    return -1;
}

bool scan_token_is(const struct token *token, const char *text)
{
    return token->length == strlen(text) && memcmp(token->text, text, token->length) == 0;
}

struct quoted scan_quote(const struct token *token)
{
    struct quoted quoted = {""};
    const size_t most = 40;
    for (size_t i = 0; i < token->length && i < most; i++) {
        quoted.text[i] = token->text[i];
        if (token->text[i] < ' ' || token->text[i] > '~')
            quoted.text[i] = '?';
    }
    if (token->length > most)
        memcpy(quoted.text + most, "...", 4);
    return quoted;
}

/* -- numbers ---------------------------------------------------------------------------------- */

int scan_integer(const struct scan *scan, const struct token *token, const char *what,
                 int64_t *value)
{
    size_t i = token->length > 0 && (token->text[0] == '-' || token->text[0] == '+') ? 1 : 0;
    bool is_negative = i == 1 && token->text[0] == '-';
    bool ok = i < token->length;
    int64_t magnitude = 0;
    for (; ok && i < token->length; i++) {
        int digit = token->text[i] - '0';
        ok = digit >= 0 && digit <= 9 && magnitude <= (INT64_MAX - digit) / 10;
        if (ok)
            magnitude = 10 * magnitude + digit;
    }
    if (!ok)
        return scan_error(scan, "%s must be a whole number, \"%s\" is none", what,
                          scan_quote(token).text);
    *value = is_negative ? -magnitude : magnitude;
    return 0;
}

/* Copies a token that may be a decimal number into `text`, terminated. strtod takes more:
 * hexadecimal, "nan" and "inf". */
static int decimal_text(const struct scan *scan, const struct token *token, const char *what,
                        char *text, size_t size)
{
    bool ok = token->length > 0 && token->length < size;
    for (size_t i = 0; ok && i < token->length; i++)
        ok = token->text[i] != '\0' && strchr("0123456789+-.eE", token->text[i]);
    if (!ok)
        return scan_error(scan, "%s must be a finite decimal number, \"%s\" is none", what,
                          scan_quote(token).text);
    memcpy(text, token->text, token->length);
    text[token->length] = '\0';
    return 0;
}

enum { NUMBER_SIZE = 400 }; /* more digits than the longest exact double in fixed notation */

/* A short token in the surroundings that number.h asks for. */
struct short_number {
    char text[32 + NUMBER_OVERREAD + 1];
};

static bool copy_short(const struct token *token, struct short_number *copy)
{
    if (token->length > 32)
        return false;
    memset(copy, 0, sizeof *copy);
    memcpy(copy->text, token->text, token->length);
    return true;
}

static bool fast_float(const struct token *token, float *value)
{
    struct short_number copy;
    return copy_short(token, &copy) && number_float(copy.text, value) == copy.text + token->length;
}

static bool fast_double(const struct token *token, double *value)
{
    struct short_number copy;
    return copy_short(token, &copy) && number_double(copy.text, value) == copy.text + token->length;
}

int scan_float(const struct scan *scan, const struct token *token, const char *what, float *value)
{
    if (fast_float(token, value))
        return 0;
    char text[NUMBER_SIZE], *end;
    if (decimal_text(scan, token, what, text, sizeof text))
        return -1;
    *value = strtof_l(text, &end, scan->c_locale);
    if (*end != '\0' || end == text)
        return scan_error(scan, "%s must be a finite decimal number, \"%s\" is none", what,
                          scan_quote(token).text);
    if (!isfinite(*value))
        return scan_error(scan, "%s is %s, which is too large for a float (3.4e38)", what,
                          scan_quote(token).text);
    return 0;
}

int scan_double(const struct scan *scan, const struct token *token, const char *what, double *value)
{
    if (fast_double(token, value))
        return 0;
    char text[NUMBER_SIZE], *end;
    if (decimal_text(scan, token, what, text, sizeof text))
        return -1;
    *value = strtod_l(text, &end, scan->c_locale);
    if (*end != '\0' || end == text)
        return scan_error(scan, "%s must be a finite decimal number, \"%s\" is none", what,
                          scan_quote(token).text);
    if (!isfinite(*value))
        return scan_error(scan, "%s is %s, which is too large for a double (1.8e308)", what,
                          scan_quote(token).text);
    return 0;
}

static int next_token(struct scan *scan, const char *what, struct token *token)
{
    if (scan_token(scan, token))
        return 0;
    return scan_error(scan, "%s is missing: the line ends before it", what);
}

int scan_next_integer(struct scan *scan, const char *what, int64_t *value)
{
    struct token token;
    return next_token(scan, what, &token) ? -1 : scan_integer(scan, &token, what, value);
}

int scan_next_float(struct scan *scan, const char *what, float *value)
{
    struct token token;
    return next_token(scan, what, &token) ? -1 : scan_float(scan, &token, what, value);
}
