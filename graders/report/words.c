/* The words of reports; see words.h. */
#include "graders/report/words.h"

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

const char *words_choose(struct phrase phrase, bool spanish)
{
    return phrase_text(phrase, spanish ? LANGUAGE_ES : LANGUAGE_EN);
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

void words_of_points(double points, char *text, size_t capacity)
{
    snprintf(text, capacity, "%.2f", points);
    size_t length = strlen(text);
    while (length > 0 && text[length - 1] == '0')
        text[--length] = '\0';
    if (length > 0 && text[length - 1] == '.')
        text[length - 1] = '\0';
}
