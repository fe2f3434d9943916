/* Looks at the seams of composed messages; see wording.h. */
#include "graders/known/wording.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

/* What is wrong at `at`, NULL when nothing is. */
static const char *seam_at(const char *text, const char *at)
{
    char before = at > text ? at[-1] : '\0', after = at[0] ? at[1] : '\0';
    if (*at == ' ' && (at == text || !after))
        return "a blank at an end";
    if (*at == ' ' && after == ' ')
        return "two blanks";
    if (*at == ' ' && strchr(".,;", after) && strncmp(at, " ...", 4) != 0)
        return "a blank before a stop";
    if (*at == '.' && islower((unsigned char)before) && isupper((unsigned char)after))
        return "no blank between sentences";
    if (!after && !strchr(".:?!)", *at))
        return "no stop at the end";
    return NULL;
}

static bool is_sound(const char *text, char *why, size_t capacity)
{
    for (const char *at = text; *at; at++) {
        const char *seam = seam_at(text, at);
        if (!seam)
            continue;
        snprintf(why, capacity, "%s in \"%.300s\"", seam, text);
        return false;
    }
    return true;
}

bool wording_is_sound(json_t *result, char *why, size_t capacity)
{
    static const char *const keys[] = {"message", "summary"}, *const languages[] = {"en", "es"};
    const char *key;
    json_t *value, *element;
    size_t index;
    for (int k = 0; k < 2; k++)
        for (int l = 0; l < 2; l++) {
            const char *text =
                json_string_value(json_object_get(json_object_get(result, keys[k]), languages[l]));
            if (text && !is_sound(text, why, capacity))
                return false;
        }
    json_object_foreach(result, key, value)
    {
        if (json_is_object(value) && !wording_is_sound(value, why, capacity))
            return false;
        json_array_foreach(value, index, element)
        {
            if (!wording_is_sound(element, why, capacity))
                return false;
        }
    }
    return true;
}
