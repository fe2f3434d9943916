/* Names of students; see names.h. */
#include "graders/engine/upload/names.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Length of the valid UTF-8 sequence at the front, and its code point; 0 when it is none. */
static size_t decode_utf8(const unsigned char *at, size_t count, uint32_t *code)
{
    static const uint32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
    size_t length = *at < 0x80       ? 1
                    : *at >> 5 == 6  ? 2
                    : *at >> 4 == 14 ? 3
                    : *at >> 3 == 30 ? 4
                                     : 0;
    if (length == 0 || length > count)
        return 0;
    *code = length == 1 ? *at : *at & (0x7fU >> length);
    for (size_t i = 1; i < length; i++) {
        if (at[i] >> 6 != 2)
            return 0;
        *code = *code << 6 | (at[i] & 0x3f);
    }
    bool is_surrogate = *code >= 0xd800 && *code <= 0xdfff;
    return *code < smallest[length] || *code > 0x10ffff || is_surrogate ? 0 : length;
}

char *names_utf8(const char *bytes, size_t count)
{
    static const char replacement[] = "\xef\xbf\xbd";
    char *out = malloc(3 * count + 1);
    size_t used = 0;
    if (!out)
        return NULL;
    for (size_t i = 0; i < count;) {
        uint32_t code;
        size_t length = decode_utf8((const unsigned char *)bytes + i, count - i, &code);
        memcpy(out + used, length ? bytes + i : replacement, length ? length : 3);
        used += length ? length : 3;
        i += length ? length : 1;
    }
    out[used] = '\0';
    return out;
}

/* The plain letter for a code point, or '-'; 0 for a combining accent. */
static char plain_letter(uint32_t code)
{
    static const char latin[] = "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYTsaaaaaaaceeeeiiiidnooooo-ouuuuyty";
    if ((code >= 'a' && code <= 'z') || (code >= 'A' && code <= 'Z') ||
        (code >= '0' && code <= '9') || code == '.' || code == '_')
        return (char)code;
    if (code >= 0xc0 && code <= 0xff)
        return latin[code - 0xc0];
    return code >= 0x300 && code <= 0x36f ? '\0' : '-';
}

void names_slug(char out[NAMES_SLUG], const char *name)
{
    size_t used = 0, count = strlen(name);
    for (size_t i = 0; i < count && used < NAMES_SLUG - 1;) {
        uint32_t code = 0;
        size_t length = decode_utf8((const unsigned char *)name + i, count - i, &code);
        char letter = length ? plain_letter(code) : '-';
        i += length ? length : 1;
        bool is_unwanted = letter == '\0' || (used == 0 && (letter == '-' || letter == '.')) ||
                           (letter == '-' && out[used - 1] == '-');
        if (!is_unwanted)
            out[used++] = letter;
    }
    while (used && (out[used - 1] == '-' || out[used - 1] == '.'))
        used--;
    out[used] = '\0';
    if (!used)
        memcpy(out, "student", sizeof "student");
}

size_t names_moodle(const char *folder, size_t count)
{
    static const char mark[] = "_assignsubmission_";
    const char *at = memmem(folder, count, mark, sizeof mark - 1);
    size_t length = at ? (size_t)(at - folder) : 0, digits = 0;
    while (digits < length && folder[length - 1 - digits] >= '0' &&
           folder[length - 1 - digits] <= '9')
        digits++;
    if (!digits || digits + 1 >= length || folder[length - 1 - digits] != '_')
        return 0;
    return length - digits - 1;
}

/* The next line of a text, without its newline. */
static bool next_line(const char **at, const char *end, const char **line, size_t *length)
{
    if (*at >= end)
        return false;
    const char *newline = memchr(*at, '\n', (size_t)(end - *at));
    *line = *at;
    *length = (size_t)((newline ? newline : end) - *at);
    *at = newline ? newline + 1 : end;
    if (*length && (*line)[*length - 1] == '\r')
        --*length;
    return true;
}

/* `  - :name: Ana Pérez` or `    :name: "..."`: the value. */
static bool take_name(const char **line, size_t *length)
{
    static const char key[] = ":name:";
    const char *at = *line, *end = *line + *length;
    while (at < end && (*at == ' ' || *at == '-'))
        at++;
    if ((size_t)(end - at) < sizeof key - 1 || memcmp(at, key, sizeof key - 1) != 0)
        return false;
    at += sizeof key - 1;
    while (at < end && (*at == ' ' || *at == '"' || *at == '\''))
        at++;
    while (end > at && (end[-1] == ' ' || end[-1] == '"' || end[-1] == '\''))
        end--;
    *line = at;
    *length = (size_t)(end - at);
    return end > at;
}

char *names_gradescope(const char *metadata, size_t bytes, const char *folder, size_t count)
{
    enum { NAMES_BYTES = 1024 };
    char joined[NAMES_BYTES];
    size_t used = 0, length;
    const char *at = bytes ? metadata : "", *end = at + bytes, *line;
    bool inside = false;
    while (bytes && next_line(&at, end, &line, &length)) {
        if (length && line[0] != ' ' && line[0] != '-' && line[0] != '#')
            inside = length == count + 1 && memcmp(line, folder, count) == 0 && line[count] == ':';
        if (!inside || !take_name(&line, &length) || used + length + 2 > NAMES_BYTES)
            continue;
        if (used) {
            joined[used++] = ',';
            joined[used++] = ' ';
        }
        memcpy(joined + used, line, length);
        used += length;
    }
    return used ? names_utf8(joined, used) : names_utf8(folder, count);
}

bool names_match(const char *exercise, const char *stem, size_t count)
{
    if (strlen(exercise) != count)
        return false;
    for (size_t i = 0; i < count; i++) {
        char c = stem[i] == '_' ? '-' : stem[i];
        if (c >= 'A' && c <= 'Z')
            c = (char)(c - 'A' + 'a');
        if (c != exercise[i])
            return false;
    }
    return true;
}
