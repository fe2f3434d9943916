/* Refusals; see refusal.h. */
#include "graders/engine/base/refusal.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void refusal_rename(struct refusal *refusal, const struct cause *cause)
{
    snprintf(refusal->cause, sizeof refusal->cause, "%s", cause->slug);
    refusal->cause_name = cause->name;
}

int refuse_saying(struct refusal *refusal, const struct cause *cause, const struct message *message)
{
    if (refusal->refused)
        return -1;
    refusal->refused = true;
    refusal_rename(refusal, cause);
    refusal->message = *message;
    return -1;
}

int refuse(struct refusal *refusal, const struct cause *cause, const char *en, const char *es, ...)
{
    struct message message;
    va_list arguments;
    va_start(arguments, es);
    message_say_list(&message, en, es, arguments);
    va_end(arguments);
    return refuse_saying(refusal, cause, &message);
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
