/* What all judges share; see judge.h. */
#include "graders/judges/judge.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void judge_accept(struct judgement *out)
{
    out->accepted = true;
}

void judge_reject(struct judgement *out, const char *cause, const char *english,
                  const char *spanish, ...)
{
    if (out->cause[0])
        return;
    out->accepted = false;
    snprintf(out->cause, sizeof out->cause, "%s", cause);
    va_list arguments, again;
    va_start(arguments, spanish);
    va_copy(again, arguments);
    vsnprintf(out->message, sizeof out->message, english, arguments);
    vsnprintf(out->message_es, sizeof out->message_es, spanish, again);
    va_end(again);
    va_end(arguments);
}

void judge_name_element(struct judgement *out, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(out->element, sizeof out->element, format, arguments);
    va_end(arguments);
}
