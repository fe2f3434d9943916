/* Refusals; see refusal.h. */
#include "graders/engine/base/refusal.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

int refuse(struct refusal *refusal, const char *cause, const char *english, const char *spanish,
           ...)
{
    if (refusal->refused)
        return -1;
    refusal->refused = true;
    snprintf(refusal->cause, sizeof refusal->cause, "%s", cause);
    va_list arguments;
    va_start(arguments, spanish);
    vsnprintf(refusal->message, sizeof refusal->message, english, arguments);
    va_end(arguments);
    va_start(arguments, spanish);
    vsnprintf(refusal->message_es, sizeof refusal->message_es, spanish, arguments);
    va_end(arguments);
    return -1;
}

const char *refusal_name(char out[REFUSAL_NAME], const char *bytes, size_t count)
{
    static const char more[] = "...";
    size_t room = REFUSAL_NAME - 1, kept = count <= room ? count : room - (sizeof more - 1);
    for (size_t i = 0; i < kept; i++)
        out[i] = bytes[i] >= ' ' && bytes[i] <= '~' ? bytes[i] : '?';
    out[kept] = '\0';
    if (kept < count)
        memcpy(out + kept, more, sizeof more);
    return out;
}
