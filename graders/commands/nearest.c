/* Mistyped names; see nearest.h. */
#include "graders/commands/nearest.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

enum { LENGTH_MAX = 255, TOLD = 3, A_PART = 1 };

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* Letters to insert, remove or replace to make one word the other (Levenshtein), row by row. */
static size_t distance_of(const char *a, const char *b)
{
    size_t row[LENGTH_MAX + 1], length = strnlen(b, LENGTH_MAX);
    for (size_t j = 0; j <= length; j++)
        row[j] = j;
    for (size_t i = 0; a[i]; i++) {
        size_t diagonal = row[0];
        row[0] = i + 1;
        for (size_t j = 0; j < length; j++) {
            bool differs = tolower((unsigned char)a[i]) != tolower((unsigned char)b[j]);
            size_t replaced = diagonal + differs;
            diagonal = row[j + 1];
            row[j + 1] = least(replaced, least(diagonal, row[j]) + 1);
        }
    }
    return row[length];
}

static bool is_told(const char *const *told, size_t count, const char *name)
{
    for (size_t i = 0; i < count; i++)
        if (strcmp(told[i], name) == 0)
            return true;
    return false;
}

void nearest_names(const char *wanted, const char *const *names, size_t count, char *text,
                   size_t capacity)
{
    const char *told[TOLD];
    size_t told_count = 0, used = 0, limit = strlen(wanted) / 3 + 1;
    if (capacity > 0)
        text[0] = '\0';
    for (size_t distance = 0; distance <= limit; distance++)
        for (size_t i = 0; i < count && told_count < TOLD && used < capacity; i++) {
            size_t own = distance_of(wanted, names[i]);
            if (wanted[0] && own > A_PART && strcasestr(names[i], wanted))
                own = A_PART;
            if (own != distance || is_told(told, told_count, names[i]))
                continue;
            used += (size_t)snprintf(text + used, capacity - used, "%s%s", told_count ? ", " : "",
                                     names[i]);
            told[told_count++] = names[i];
        }
}
