/* Tokens, lines and numbers of text in memory; see scan.h. */
#include "reference/formats/scan.h"

#include "reference/formats/number.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Whether the bytes are text in units of two or four bytes: by their mark, or by the zero bytes
 * beside their first character. */
static bool is_wide_text(const unsigned char *bytes, size_t count)
{
    if (count < 2)
        return false;
    bool is_marked =
        (bytes[0] == 0xff && bytes[1] == 0xfe) || (bytes[0] == 0xfe && bytes[1] == 0xff);
    bool has_zero = (bytes[0] == 0) != (bytes[1] == 0);
    unsigned char other = bytes[0] ? bytes[0] : bytes[1];
    return is_marked || (has_zero && other < 0x7f && other >= '\t' && count % 2 == 0);
}

/* How the first line ends. */
static enum line_end first_line_end(const char *bytes, size_t count)
{
    static const struct {
        const char *bytes;
        enum line_end line_end;
    } ends[] = {{"\r\r\n", LINE_END_CR_CR_LF},
                {"\r\n", LINE_END_CR_LF},
                {"\r", LINE_END_CR},
                {"\n\r\n", LINE_END_LF}, /* the second line is empty and ends with CR LF */
                {"\n\r", LINE_END_LF_CR}};
    size_t at = 0;
    while (at < count && bytes[at] != '\n' && bytes[at] != '\r')
        at++;
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        size_t length = strlen(ends[i].bytes);
        if (count - at >= length && memcmp(bytes + at, ends[i].bytes, length) == 0)
            return ends[i].line_end;
    }
    return LINE_END_LF;
}

int scan_init(struct scan *scan, const void *bytes, size_t byte_count, const char *name,
              struct error *err)
{
    *scan = (struct scan){
        .bytes = bytes, .byte_count = byte_count, .line = 1, .name = name, .err = err};
    if (is_wide_text(bytes, byte_count))
        return scan_error(scan, "the file is text in UTF-16 or UTF-32: save it as UTF-8 or ASCII");
    scan->c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (!scan->c_locale)
        return error_set(err, "%s: out of memory", name);
    if (byte_count >= 3 && memcmp(bytes, "\xef\xbb\xbf", 3) == 0)
        scan->at = 3;
    /* The last line end with enough bytes behind it: number.h needs both. */
    const char *last = NULL;
    scan->line_end = first_line_end(bytes, byte_count);
    bool is_usual = scan->line_end != LINE_END_LF_CR && scan->line_end != LINE_END_CR_CR_LF;
    if (byte_count > NUMBER_OVERREAD && is_usual)
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

/* Length of the line end at `at`: 0 (there is none), or 1 to 3. */
static size_t line_end_length(const struct scan *scan, size_t at)
{
    const char *bytes = scan->bytes + at;
    size_t count = scan->byte_count - at;
    if (at >= scan->byte_count || (bytes[0] != '\n' && bytes[0] != '\r'))
        return 0;
    char second = count > 1 ? bytes[1] : '\0', third = count > 2 ? bytes[2] : '\0';
    if (bytes[0] == '\n')
        return scan->line_end == LINE_END_LF_CR && second == '\r' ? 2 : 1;
    if (scan->line_end == LINE_END_CR_CR_LF && second == '\r' && third == '\n')
        return 3;
    return scan->line_end != LINE_END_CR && second == '\n' ? 2 : 1;
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/* Length of a backslash and the line end after it, 0 when there is none. */
static size_t continuation_length(const struct scan *scan)
{
    if (!scan->is_continued || scan->bytes[scan->at] != '\\')
        return 0;
    if (scan->holds_a_name && scan->at > 0 && !is_blank(scan->bytes[scan->at - 1]))
        return 0;
    size_t end = line_end_length(scan, scan->at + 1);
    return end > 0 ? 1 + end : 0;
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

/* -- what is left out ------------------------------------------------------------------------- */

int64_t scan_place(const struct scan *scan)
{
    return scan->is_binary ? (int64_t)scan->item : scan->line;
}

void scan_note_at(const struct scan *scan, enum reading_kind kind, int64_t count, int64_t place)
{
    struct reading_note *note = &scan->reading->notes[kind];
    if (note->count == 0)
        *note = (struct reading_note){.place = place, .is_byte = scan->is_binary};
    note->count += count;
}

void scan_note(const struct scan *scan, enum reading_kind kind, int64_t count)
{
    scan_note_at(scan, kind, count, scan_place(scan));
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
    record(scan, scan->is_binary ? " byte " : "", (long long)scan_place(scan), format, arguments);
    va_end(arguments);
    return -1;
}

int scan_error_at(const struct scan *scan, int64_t place, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    record(scan, scan->is_binary ? " byte " : "", (long long)place, format, arguments);
    va_end(arguments);
    return -1;
}

bool scan_token_is(const struct token *token, const char *text)
{
    return token->length == strlen(text) && memcmp(token->text, text, token->length) == 0;
}

bool scan_token_is_marked(const struct token *token)
{
    return token->length >= 3 && memcmp(token->text, "\xef\xbb\xbf", 3) == 0;
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

static int mark_error(const struct scan *scan, const char *what)
{
    return scan_error(
        scan, "a byte order mark (BOM) stands before %s: take it out (bytes EF BB BF)", what);
}

/* Whether the token is one of the words that programs write for a number that is not finite. */
static bool is_not_finite(const struct token *token)
{
    static const char *const words[] = {"nan",     "inf",    "infinity", "1.#qnan",
                                        "1.#snan", "1.#ind", "1.#inf"};
    size_t sign = token->length > 0 && (token->text[0] == '-' || token->text[0] == '+') ? 1 : 0;
    const char *text = token->text + sign;
    size_t length = token->length - sign;
    if (length > 3 && text[length - 1] == ')' && strncasecmp(text, "nan(", 4) == 0)
        return true;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (length == strlen(words[i]) && strncasecmp(text, words[i], length) == 0)
            return true;
    return false;
}

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
    if (!ok && scan_token_is_marked(token))
        return mark_error(scan, what);
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
    if (!ok && scan_token_is_marked(token))
        return mark_error(scan, what);
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
    if (scan->reading && is_not_finite(token)) {
        *value = NAN;
        return 0;
    }
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
    if (scan->reading && is_not_finite(token)) {
        *value = (double)NAN;
        return 0;
    }
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

/* -- rows ------------------------------------------------------------------------------------- */

void scan_begin_row(struct scan *scan)
{
    scan->is_broken = false;
}

int scan_row_goes_on(struct scan *scan, struct token *token, const char *format, ...)
{
    if (!scan->is_broken) {
        va_list arguments;
        va_start(arguments, format);
        vsnprintf(scan->broken, sizeof scan->broken, format, arguments);
        va_end(arguments);
        scan->is_broken = true;
        scan->broken_line = scan->line;
    }
    if (scan_find_token(scan) && scan_token(scan, token))
        return 0;
    return scan_error_at(scan, scan->broken_line, "%s", scan->broken);
}

int scan_row_error(struct scan *scan, const char *format, ...)
{
    if (scan->is_broken)
        return scan_error_at(scan, scan->broken_line, "%s", scan->broken);
    va_list arguments;
    va_start(arguments, format);
    record(scan, "", (long long)scan->line, format, arguments);
    va_end(arguments);
    return -1;
}

static int row_token(struct scan *scan, const char *what, struct token *token)
{
    if (scan_token(scan, token))
        return 0;
    return scan_row_goes_on(scan, token, "%s is missing: the line ends before it", what);
}

int scan_row_integer(struct scan *scan, const char *what, int64_t *value)
{
    struct token token;
    return row_token(scan, what, &token) ? -1 : scan_integer(scan, &token, what, value);
}

int scan_row_float(struct scan *scan, const char *what, float *value)
{
    struct token token;
    return row_token(scan, what, &token) ? -1 : scan_float(scan, &token, what, value);
}
