/* Cleaning of untrusted text; see clean.h. */
#include "graders/report/clean.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct range {
    uint32_t first, last;
};

/* Characters that change how their neighbours are shown, or show nothing at all, or that XML 1.0
 * does not allow. The joiners U+200C and U+200D are not among them: honest names need them. */
static const struct range inert[] = {
    {0x7f, 0x9f},       /* DEL and the C1 controls, among them one-byte CSI */
    {0xad, 0xad},       /* soft hyphen */
    {0x61c, 0x61c},     /* Arabic letter mark */
    {0x115f, 0x1160},   /* Hangul fillers */
    {0x180e, 0x180e},   /* Mongolian vowel separator */
    {0x200b, 0x200b},   /* zero width space */
    {0x200e, 0x200f},   /* left-to-right and right-to-left mark */
    {0x2028, 0x202e},   /* line and paragraph separator, bidi embeddings and overrides */
    {0x2060, 0x206f},   /* word joiner, invisible operators, bidi isolates */
    {0x3164, 0x3164},   /* Hangul filler */
    {0xe000, 0xf8ff},   /* private use: a terminal's font may show anything */
    {0xfdd0, 0xfdef},   /* noncharacters */
    {0xfeff, 0xfeff},   /* byte order mark */
    {0xffa0, 0xffa0},   /* half-width Hangul filler */
    {0xfff0, 0xfffb},   /* interlinear annotation */
    {0xe0000, 0xe0fff}, /* tags and variation selectors supplement */
    {0xf0000, 0x10ffff} /* private use */
};

static const struct range combining[] = {
    {0x300, 0x36f},   {0x483, 0x489},   {0x591, 0x5bd},   {0x610, 0x61a},   {0x64b, 0x65f},
    {0x93c, 0x93c},   {0x941, 0x948},   {0x94d, 0x94d},   {0xe31, 0xe31},   {0xe34, 0xe3a},
    {0xe47, 0xe4e},   {0x1ab0, 0x1aff}, {0x1dc0, 0x1dff}, {0x200c, 0x200d}, {0x20d0, 0x20ff},
    {0xfe00, 0xfe0f}, {0xfe20, 0xfe2f}};

static const struct range wide[] = {{0x1100, 0x115f},   {0x2e80, 0x303e},   {0x3041, 0xa4cf},
                                    {0xac00, 0xd7a3},   {0xf900, 0xfaff},   {0xfe30, 0xfe6f},
                                    {0xff01, 0xff60},   {0xffe0, 0xffe6},   {0x1f300, 0x1f64f},
                                    {0x1f680, 0x1f6ff}, {0x1f900, 0x1f9ff}, {0x20000, 0x3fffd}};

static bool is_among(uint32_t point, const struct range *ranges, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (point >= ranges[i].first && point <= ranges[i].last)
            return true;
    return false;
}

static bool is_inert(uint32_t point)
{
    return point < 0x20 || (point & 0xfffe) == 0xfffe ||
           is_among(point, inert, sizeof inert / sizeof *inert);
}

/* Decodes one character. Returns its length in bytes, 0 when the bytes are not UTF-8 (overlong
 * forms, surrogates and numbers above U+10FFFF are not). */
static size_t decode(const unsigned char *text, size_t length, uint32_t *point)
{
    static const uint32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
    unsigned char lead = text[0];
    if (lead < 0x80) {
        *point = lead;
        return 1;
    }
    size_t size = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || size > length)
        return 0;
    uint32_t value = lead & (0x7fU >> size);
    for (size_t i = 1; i < size; i++) {
        if ((text[i] & 0xc0) != 0x80)
            return 0;
        value = value << 6 | (text[i] & 0x3f);
    }
    if (value < smallest[size] || value > 0x10ffff || (value >= 0xd800 && value <= 0xdfff))
        return 0;
    *point = value;
    return size;
}

/* Writes one character (or one byte that is none) at `to`; returns the bytes of input used. */
static size_t clean_one(const unsigned char *text, size_t length, enum clean_form form, char **to)
{
    uint32_t point = 0;
    size_t size = decode(text, length, &point);
    if (form == CLEAN_BLOCK && point == '\r' && length > 1 && text[1] == '\n')
        return 1;
    bool is_layout = form == CLEAN_BLOCK && (point == '\n' || point == '\t');
    if (size == 0 || (point < 0x20 && !is_layout) || point == 0x7f)
        *to += sprintf(*to, "\\x%02x", text[0]);
    else if (is_inert(point) && !is_layout)
        *to += sprintf(*to, "<U+%04X>", point);
    else {
        memcpy(*to, text, size);
        *to += size;
    }
    return size ? size : 1;
}

char *clean_text(const char *text, size_t length, enum clean_form form, size_t limit_bytes)
{
    enum { WIDEST = 4, NOTE_BYTES = 40 };
    size_t limit = length < limit_bytes ? length : limit_bytes;
    if (limit > (SIZE_MAX - NOTE_BYTES) / WIDEST)
        return NULL;
    char *clean = malloc(WIDEST * limit + NOTE_BYTES);
    if (!clean)
        return NULL;

    const unsigned char *bytes = (const unsigned char *)text;
    char *to = clean;
    size_t used = 0;
    while (used < limit) {
        uint32_t point = 0;
        if (decode(bytes + used, length - used, &point) > limit - used)
            break;
        used += clean_one(bytes + used, length - used, form, &to);
    }
    *to = '\0';
    if (used < length)
        snprintf(to, NOTE_BYTES, " [... %zu bytes more]", length - used);
    return clean;
}

static size_t columns_of(uint32_t point)
{
    if (is_among(point, combining, sizeof combining / sizeof *combining))
        return 0;
    return is_among(point, wide, sizeof wide / sizeof *wide) ? 2 : 1;
}

size_t clean_prefix(const char *text, size_t columns)
{
    size_t length = strlen(text);
    size_t used = 0;
    size_t taken = 0;
    while (used < length) {
        uint32_t point = 0;
        size_t size = decode((const unsigned char *)text + used, length - used, &point);
        taken += size ? columns_of(point) : 1;
        if (taken > columns)
            break;
        used += size ? size : 1;
    }
    return used;
}

size_t clean_columns(const char *text)
{
    size_t length = strlen(text);
    size_t taken = 0;
    for (size_t used = 0; used < length;) {
        uint32_t point = 0;
        size_t size = decode((const unsigned char *)text + used, length - used, &point);
        taken += size ? columns_of(point) : 1;
        used += size ? size : 1;
    }
    return taken;
}
