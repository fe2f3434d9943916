/* Texts in both languages; see phrase.h. */
#include "reference/base/phrase.h"

#include <stdio.h>
#include <string.h>

const char *phrase_text(struct phrase phrase, enum language language)
{
    const char *text = language == LANGUAGE_ES ? phrase.es : phrase.en;
    return text ? text : "";
}

const char *message_text(const struct message *message, enum language language)
{
    return language == LANGUAGE_ES ? message->es : message->en;
}

/* A text that was cut may end in the middle of a character: that part is dropped, too. */
static void drop_half_character(char *text)
{
    size_t end = strlen(text), start = end;
    while (start > 0 && ((unsigned char)text[start - 1] & 0xC0) == 0x80)
        start--;
    if (start == 0)
        return;
    unsigned char lead = (unsigned char)text[start - 1];
    size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC0 ? 2 : 1;
    if (end - (start - 1) < bytes)
        text[start - 1] = '\0';
}

static void append(char text[MESSAGE_BYTES], const char *format, va_list arguments)
{
    size_t used = strlen(text);
    int length = vsnprintf(text + used, MESSAGE_BYTES - used, format, arguments);
    if (length >= (int)(MESSAGE_BYTES - used))
        drop_half_character(text);
}

static void append_both(struct message *message, const char *en, const char *es, va_list arguments)
{
    va_list again;
    va_copy(again, arguments);
    append(message->en, en, arguments);
    append(message->es, es, again);
    va_end(again);
}

void message_append(struct message *message, enum language language, const char *format,
                    va_list arguments)
{
    append(language == LANGUAGE_ES ? message->es : message->en, format, arguments);
}

void message_clear(struct message *message)
{
    message->en[0] = message->es[0] = '\0';
}

void message_say(struct message *message, const char *en, const char *es, ...)
{
    va_list arguments;
    va_start(arguments, es);
    message_say_list(message, en, es, arguments);
    va_end(arguments);
}

void message_say_list(struct message *message, const char *en, const char *es, va_list arguments)
{
    message_clear(message);
    append_both(message, en, es, arguments);
}

void message_add(struct message *message, const char *en, const char *es, ...)
{
    va_list arguments;
    va_start(arguments, es);
    append_both(message, en, es, arguments);
    va_end(arguments);
}

void message_en(struct message *message, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    append(message->en, format, arguments);
    va_end(arguments);
}

void message_es(struct message *message, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    append(message->es, format, arguments);
    va_end(arguments);
}

void message_set_phrase(struct message *message, struct phrase phrase)
{
    message_clear(message);
    message_add_phrase(message, phrase);
}

void message_add_phrase(struct message *message, struct phrase phrase)
{
    message_en(message, "%s", phrase_text(phrase, LANGUAGE_EN));
    message_es(message, "%s", phrase_text(phrase, LANGUAGE_ES));
}

struct phrase message_phrase(const struct message *message)
{
    return (struct phrase){message->en, message->es};
}
