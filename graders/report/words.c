/* The words of reports; see words.h. */
#include "graders/report/words.h"

#include "reference/base/decimal.h"
#include "reference/base/plural.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

struct phrase words_verdict(const char *verdict)
{
    enum verdict found = verdict_of_name(verdict);
    return found < VERDICT_COUNT ? verdict_words(found)
                                 : (struct phrase){"unknown verdict", "veredicto desconocido"};
}

bool words_know_verdict(const char *verdict)
{
    return verdict_of_name(verdict) < VERDICT_COUNT;
}

enum standing words_standing(const char *verdict)
{
    enum verdict found = verdict_of_name(verdict);
    return found < VERDICT_COUNT ? verdict_standing(found) : STANDING_ABSENT;
}

struct phrase words_of_standing(enum standing standing)
{
    static const struct phrase words[STANDING_COUNT] = {
        [STANDING_PASSED] = {"passed", "superado"},
        [STANDING_PARTIAL] = {"partial", "parcial"},
        [STANDING_FAILED] = {"failed", "no superado"},
        [STANDING_UNSCORED] = {"unscored", "sin nota"},
        [STANDING_ABSENT] = {"absent", "sin dato"},
    };
    return words[standing];
}

const char *words_symbol(enum standing standing)
{
    static const char *const symbols[STANDING_COUNT] = {
        [STANDING_PASSED] = "✓",   [STANDING_PARTIAL] = "◐", [STANDING_FAILED] = "✗",
        [STANDING_UNSCORED] = "!", [STANDING_ABSENT] = "–",
    };
    return symbols[standing];
}

struct phrase words_in(const json_t *object, const char *key)
{
    const json_t *both = json_object_get(object, key);
    const char *alone = json_string_value(both);
    const char *en = alone ? alone : json_string_value(json_object_get(both, "en"));
    const char *es = alone ? alone : json_string_value(json_object_get(both, "es"));
    return (struct phrase){en ? en : "", es ? es : ""};
}

struct phrase words_cause(const json_t *part, char *room, size_t capacity)
{
    const char *slug = json_string_value(json_object_get(part, "cause"));
    struct phrase name = words_in(part, "cause_name");
    if (*name.en)
        return name;
    snprintf(room, capacity, "%s", slug ? slug : "");
    for (char *c = room; *c; c++)
        if (*c == '-')
            *c = ' ';
    return (struct phrase){room, room};
}

void words_of_bytes(double bytes, char *text, size_t capacity)
{
    static const char *const units[] = {"KB", "MB", "GB", "TB"};
    enum { LEAST_BYTES = 10000 };
    size_t unit = 0;
    if (bytes < LEAST_BYTES) {
        snprintf(text, capacity, "%.0f byte%s", bytes, plural_ending(llround(bytes)));
        return;
    }
    for (bytes /= 1024; bytes >= LEAST_BYTES && unit + 1 < sizeof units / sizeof *units; unit++)
        bytes /= 1024;
    snprintf(text, capacity, "%.*f %s", bytes < 100 ? 1 : 0, bytes, units[unit]);
}

static double limit_of(const json_t *bands, size_t i)
{
    return json_number_value(json_object_get(json_array_get(bands, i), "limit"));
}

/* The limit that a number comes nearest to; itself where there are no bands. */
static double nearest_limit(const json_t *bands, double value)
{
    double nearest = json_array_size(bands) > 0 ? limit_of(bands, 0) : value;
    for (size_t i = 1; i < json_array_size(bands); i++)
        if (fabs(limit_of(bands, i) - value) < fabs(nearest - value))
            nearest = limit_of(bands, i);
    return nearest;
}

void words_of_quality(const json_t *quality, struct message *text)
{
    const json_t *bands = json_object_get(quality, "bands");
    struct phrase name = words_in(quality, "name"), unit = words_in(quality, "unit");
    double worst = json_number_value(json_object_get(quality, "worst"));
    char number[DECIMAL_BYTES];
    decimal_write(worst, nearest_limit(bands, worst), number);
    message_clear(text);
    if (*unit.en) {
        message_en(text, "%.80s %s %.80s", name.en, number, unit.en);
        message_es(text, "%.80s %s %.80s", name.es, number, unit.es);
    } else {
        message_en(text, "%s %.80s", number, name.en);
        message_es(text, "%s %.80s", number, name.es);
    }
    for (size_t i = 0; i < json_array_size(bands); i++) {
        const char *begin = i == 0 ? " (" : ", ";
        const char *end = i + 1 == json_array_size(bands) ? ")" : "";
        struct phrase band = words_in(json_array_get(bands, i), "name");
        decimal_write(limit_of(bands, i), worst, number);
        message_en(text, "%s%.40s %s%s", begin, band.en, number, end);
        message_es(text, "%s%.40s %s%s", begin, band.es, number, end);
    }
}

void words_of_points(double points, char *text, size_t capacity)
{
    snprintf(text, capacity, "%.2f", points);
    size_t length = strlen(text);
    while (length > 0 && text[length - 1] == '0')
        text[--length] = '\0';
    if (length > 0 && text[length - 1] == '.')
        text[length - 1] = '\0';
}
