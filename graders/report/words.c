/* The words of reports; see words.h. */
#include "graders/report/words.h"

#include "reference/base/plural.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

struct verdict_words {
    const char *verdict;
    struct words words;
    enum outcome outcome;
};

static const struct verdict_words verdicts[] = {
    {"passed", {"passed", "superado"}, OUTCOME_PASSED},
    {"forbidden-operation", {"forbidden operation", "operación prohibida"}, OUTCOME_FAILED},
    {"out-of-memory", {"out of memory", "memoria agotada"}, OUTCOME_FAILED},
    {"too-many-processes", {"too many processes", "demasiados procesos"}, OUTCOME_FAILED},
    {"too-much-output", {"too much output", "demasiada salida"}, OUTCOME_FAILED},
    {"too-much-disk", {"too much disk", "demasiado disco"}, OUTCOME_FAILED},
    {"cpu-time", {"CPU time limit", "límite de tiempo de CPU"}, OUTCOME_FAILED},
    {"idle-time", {"idle time limit", "límite de tiempo de espera"}, OUTCOME_FAILED},
    {"crash", {"crash", "el programa se rompió"}, OUTCOME_FAILED},
    {"undefined-behaviour", {"undefined behaviour", "comportamiento indefinido"}, OUTCOME_FAILED},
    {"wrong-answer", {"wrong answer", "respuesta incorrecta"}, OUTCOME_FAILED},
    {"leak", {"memory leak", "fuga de memoria"}, OUTCOME_FAILED},
    {"grows-too-fast", {"grows too fast", "crece demasiado"}, OUTCOME_FAILED},
    {"too-much-work", {"too much work", "demasiado trabajo"}, OUTCOME_FAILED},
    {"too-much-memory", {"too much memory", "demasiada memoria"}, OUTCOME_FAILED},
    {"compile-error", {"does not compile", "no compila"}, OUTCOME_FAILED},
    {"fault", {"fault of the grader", "fallo del corrector"}, OUTCOME_UNSCORED},
    {"flagged", {"held for a person", "pendiente de revisión"}, OUTCOME_UNSCORED},
    {"not-measured", {"not measured", "no medido"}, OUTCOME_ABSENT},
    {"not-reached", {"not reached", "no se llegó"}, OUTCOME_ABSENT},
};

static const struct verdict_words *find(const char *verdict)
{
    for (size_t i = 0; i < sizeof verdicts / sizeof *verdicts; i++)
        if (strcmp(verdicts[i].verdict, verdict) == 0)
            return &verdicts[i];
    return NULL;
}

struct words words_verdict(const char *verdict)
{
    const struct verdict_words *found = find(verdict);
    return found ? found->words : (struct words){"unknown verdict", "veredicto desconocido"};
}

bool words_know_verdict(const char *verdict)
{
    return find(verdict) != NULL;
}

enum outcome words_outcome(const char *verdict)
{
    const struct verdict_words *found = find(verdict);
    return found ? found->outcome : OUTCOME_ABSENT;
}

struct words words_of_outcome(enum outcome outcome)
{
    static const struct words words[OUTCOME_COUNT] = {
        [OUTCOME_PASSED] = {"passed", "superado"},    [OUTCOME_PARTIAL] = {"partial", "parcial"},
        [OUTCOME_FAILED] = {"failed", "no superado"}, [OUTCOME_UNSCORED] = {"unscored", "sin nota"},
        [OUTCOME_ABSENT] = {"absent", "sin dato"},
    };
    return words[outcome];
}

const char *words_symbol(enum outcome outcome)
{
    static const char *const symbols[OUTCOME_COUNT] = {
        [OUTCOME_PASSED] = "✓",   [OUTCOME_PARTIAL] = "◐", [OUTCOME_FAILED] = "✗",
        [OUTCOME_UNSCORED] = "!", [OUTCOME_ABSENT] = "–",
    };
    return symbols[outcome];
}

struct words words_in(const json_t *object, const char *key)
{
    const json_t *both = json_object_get(object, key);
    const char *en = json_string_value(json_object_get(both, "en"));
    const char *es = json_string_value(json_object_get(both, "es"));
    return (struct words){en ? en : "", es ? es : ""};
}

const char *words_choose(struct words words, bool spanish)
{
    return spanish ? words.es : words.en;
}

void words_of_slug(const char *slug, char *text, size_t capacity)
{
    snprintf(text, capacity, "%s", strcmp(slug, "self-edge") == 0 ? "degenerate-edge" : slug);
    for (char *c = text; *c; c++)
        if (*c == '-')
            *c = ' ';
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
