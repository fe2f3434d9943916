/* Saying what a judge found; see judgement.h. */
#include "graders/library/judgement.h"

#include <stdarg.h>
#include <stdio.h>

void judge_accept(struct judgement *out)
{
    out->accepted = true;
}

void judge_quality(struct judgement *out, double quality)
{
    out->quality = quality;
    out->has_quality = true;
}

bool judge_reject_for(struct judgement *out, const struct cause *cause)
{
    if (out->cause[0])
        return false;
    out->accepted = false;
    snprintf(out->cause, sizeof out->cause, "%s", cause->slug);
    message_clear(&out->cause_name);
    message_add_phrase(&out->cause_name, cause->name);
    return true;
}

void judge_reject(struct judgement *out, const struct cause *cause, const char *en, const char *es,
                  ...)
{
    if (!judge_reject_for(out, cause))
        return;
    va_list arguments, again;
    va_start(arguments, es);
    va_copy(again, arguments);
    message_clear(&out->message);
    message_append(&out->message, LANGUAGE_EN, en, arguments);
    message_append(&out->message, LANGUAGE_ES, es, again);
    va_end(again);
    va_end(arguments);
}

void judge_en(struct judgement *out, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    message_append(&out->message, LANGUAGE_EN, format, arguments);
    va_end(arguments);
}

void judge_es(struct judgement *out, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    message_append(&out->message, LANGUAGE_ES, format, arguments);
    va_end(arguments);
}

void judge_hint(struct judgement *out, struct phrase hint)
{
    if (!hint.en || !hint.en[0])
        return;
    message_en(&out->message, " %s", hint.en);
    message_es(&out->message, " %s", hint.es);
}

void judge_name(struct judgement *out, const char *en, const char *es, ...)
{
    va_list arguments, again;
    va_start(arguments, es);
    va_copy(again, arguments);
    message_clear(&out->element);
    message_append(&out->element, LANGUAGE_EN, en, arguments);
    message_append(&out->element, LANGUAGE_ES, es, again);
    va_end(again);
    va_end(arguments);
}

void judge_name_one(struct judgement *out, struct phrase noun, const char *format, ...)
{
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    message_clear(&out->element);
    message_add_phrase(&out->element, noun);
    message_add(&out->element, " ", " ");
    message_append(&out->element, LANGUAGE_EN, format, arguments);
    message_append(&out->element, LANGUAGE_ES, format, again);
    va_end(again);
    va_end(arguments);
}
