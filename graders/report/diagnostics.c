/* The telling line of diagnostics; see diagnostics.h. */
#include "graders/report/diagnostics.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static bool begins(const char *text, const char *start)
{
    return strncmp(text, start, strlen(start)) == 0;
}

/* What stands behind ":LINE:COLUMN: " or ":LINE: ", the first such place of the line; NULL when
 * there is none. */
static const char *after_place(const char *line, size_t length)
{
    static const char digits[] = "0123456789";
    for (size_t i = 0; i < length; i++) {
        size_t number = line[i] == ':' ? strspn(line + i + 1, digits) : 0;
        if (number == 0)
            continue;
        const char *behind = line + i + 1 + number;
        size_t column = *behind == ':' ? strspn(behind + 1, digits) : 0;
        if (column > 0)
            behind += 1 + column;
        if (begins(behind, ": "))
            return behind + 2;
    }
    return NULL;
}

/* gcc's, and the assembler's, which begins with a capital. */
static bool is_error(const char *line, size_t length)
{
    static const char *const kinds[] = {"error: ", "fatal error: ", "Error: ", "Fatal error: "};
    const char *text = begins(line, "cc1: ")   ? line + strlen("cc1: ")
                       : begins(line, "gcc: ") ? line + strlen("gcc: ")
                                               : after_place(line, length);
    for (size_t i = 0; text && i < sizeof kinds / sizeof *kinds; i++)
        if (begins(text, kinds[i]))
            return true;
    return false;
}

static bool holds(const char *line, size_t length, const char *part)
{
    return memmem(line, length, part, strlen(part)) != NULL;
}

static bool is_of_linker(const char *line, size_t length)
{
    return holds(line, length, ": undefined reference to ") ||
           holds(line, length, ": multiple definition of ");
}

/* Not "collect2: error: ld returned 1 exit status", which says only that another line tells. */
static bool is_any(const char *line, size_t length)
{
    return length > 0 && !begins(line, "collect2: ");
}

static bool find(const char *diagnostics, bool (*tells)(const char *, size_t), char *line,
                 size_t capacity)
{
    for (const char *at = diagnostics; *at;) {
        size_t length = strcspn(at, "\n");
        if (tells(at, length)) {
            snprintf(line, capacity, "%.*s", (int)length, at);
            return true;
        }
        at += length + (at[length] == '\n');
    }
    return false;
}

void diagnostics_telling_line(const char *diagnostics, char *line, size_t capacity)
{
    if (!find(diagnostics, is_error, line, capacity) &&
        !find(diagnostics, is_of_linker, line, capacity) &&
        !find(diagnostics, is_any, line, capacity))
        snprintf(line, capacity, "%.*s", (int)strcspn(diagnostics, "\n"), diagnostics);
}
