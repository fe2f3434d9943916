/* Functions of libc that make blocks which the student must give back: what libc asks for while
 * they run is the student's. The others keep what they ask for, or give it back themselves; of a few
 * (regcomp, newlocale, hcreate, sscanf with %ms) it is not seen when the student does not.
 *
 * The student's object calls these by other names (graders/engine/build/wrapped.h). */
#include "graders/runner/shim.h"

#ifndef RUNNER_WITHOUT_SHIM

#include <search.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wchar.h>

/* The student's requests, as the shim defines them. */
void *student_malloc(size_t size);

char *student_strdup(const char *text);
char *student_strndup(const char *text, size_t most);
wchar_t *student_wcsdup(const wchar_t *text);
ssize_t student_getdelim(char **line, size_t *room, int delimiter, FILE *stream);
ssize_t student_getline(char **line, size_t *room, FILE *stream);
int student_vasprintf(char **text, const char *format, va_list arguments);
int student___vasprintf_chk(char **text, int flag, const char *format, va_list arguments);
int student_asprintf(char **text, const char *format, ...);
int student___asprintf_chk(char **text, int flag, const char *format, ...);
FILE *student_open_memstream(char **text, size_t *bytes);
FILE *student_open_wmemstream(wchar_t **text, size_t *count);
FILE *student_fmemopen(void *block, size_t bytes, const char *mode);
int student_fclose(FILE *stream);
void *student_tsearch(const void *key, void **root, int (*compare)(const void *, const void *));

/* Their other names, which headers use. */
char *student___strdup(const char *text) __attribute__((alias("student_strdup")));
char *student___strndup(const char *text, size_t most) __attribute__((alias("student_strndup")));
ssize_t student___getdelim(char **line, size_t *room, int delimiter, FILE *stream)
    __attribute__((alias("student_getdelim")));
int student___asprintf(char **text, const char *format, ...)
    __attribute__((alias("student_asprintf")));

/* What `call` gives, with all that libc asks for in it being the student's. */
#define ON_BEHALF(type, how, call)                                                                 \
    enum shim_behalf before = shim_on_behalf(how);                                                 \
    type given = call;                                                                             \
    shim_on_behalf(before);                                                                        \
    return given

char *student_strdup(const char *text)
{
    ON_BEHALF(char *, BEHALF_ASKS, strdup(text));
}

char *student_strndup(const char *text, size_t most)
{
    ON_BEHALF(char *, BEHALF_ASKS, strndup(text, most));
}

wchar_t *student_wcsdup(const wchar_t *text)
{
    ON_BEHALF(wchar_t *, BEHALF_ASKS, wcsdup(text));
}

/* The line is the student's, a buffer of the stream libc's. The first block is therefore made here:
 * where libc makes it larger it stays the student's. */
ssize_t student_getdelim(char **line, size_t *room, int delimiter, FILE *stream)
{
    enum { FIRST_BYTES = 120 };
    if (line && room && !*line) {
        *line = student_malloc(FIRST_BYTES);
        if (!*line)
            return -1;
        *room = FIRST_BYTES;
    }
    return getdelim(line, room, delimiter, stream);
}

ssize_t student_getline(char **line, size_t *room, FILE *stream)
{
    return student_getdelim(line, room, '\n', stream);
}

int student_vasprintf(char **text, const char *format, va_list arguments)
{
    ON_BEHALF(int, BEHALF_ASKS, vasprintf(text, format, arguments));
}

int student___vasprintf_chk(char **text, int flag, const char *format, va_list arguments)
{
    (void)flag;
    return student_vasprintf(text, format, arguments);
}

int student_asprintf(char **text, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    int count = student_vasprintf(text, format, arguments);
    va_end(arguments);
    return count;
}

int student___asprintf_chk(char **text, int flag, const char *format, ...)
{
    va_list arguments;
    (void)flag;
    va_start(arguments, format);
    int count = student_vasprintf(text, format, arguments);
    va_end(arguments);
    return count;
}

FILE *student_open_memstream(char **text, size_t *bytes)
{
    ON_BEHALF(FILE *, BEHALF_ASKS, open_memstream(text, bytes));
}

FILE *student_open_wmemstream(wchar_t **text, size_t *count)
{
    ON_BEHALF(FILE *, BEHALF_ASKS, open_wmemstream(text, count));
}

FILE *student_fmemopen(void *block, size_t bytes, const char *mode)
{
    ON_BEHALF(FILE *, BEHALF_ASKS, fmemopen(block, bytes, mode));
}

/* A stream of memory gives its block, which has grown by libc's hand, to the student as it closes. */
int student_fclose(FILE *stream)
{
    ON_BEHALF(int, BEHALF_TAKES, fclose(stream));
}

void *student_tsearch(const void *key, void **root, int (*compare)(const void *, const void *))
{
    ON_BEHALF(void *, BEHALF_ASKS, tsearch(key, root, compare));
}

#endif
