/* Texts for people, in both languages of the project.
 *
 * A text that stands in the program is a phrase: two strings, declared where the thing is declared
 * that they name.
 *
 *     static const struct phrase edge_noun = {"edge", "arista"};
 *
 * A text that is composed is a message: one call when both languages take the same arguments, two
 * when words differ. The compiler checks every format against its arguments.
 *
 *     message_say(&m, "%d edges are missing.", "Faltan %d aristas.", count);
 *
 *     message_en(&m, "%s %d is wrong.", noun.en, i);
 *     message_es(&m, "%s %d no es correcta.", noun.es, i); */
#ifndef REFERENCE_BASE_PHRASE_H
#define REFERENCE_BASE_PHRASE_H

#include <stdarg.h>

enum language { LANGUAGE_EN, LANGUAGE_ES, LANGUAGE_COUNT };

struct phrase {
    const char *en, *es; /* UTF-8; borrowed, usually literals; both NULL: no text */
};

enum { MESSAGE_BYTES = 640 };

struct message {
    char en[MESSAGE_BYTES], es[MESSAGE_BYTES]; /* UTF-8, ended by a zero byte; empty: no text */
};

/* A kind of mistake: a slug for machines, which also groups the mistakes of a class, and its name
 * for people. Declared where the mistake is found:
 *
 *     static const struct cause lost_edge = {"missing-edge", {"missing edge", "falta una arista"}};
 */
struct cause {
    const char *slug; /* lower case with dashes, shorter than CAUSE_SLUG */
    struct phrase name;
};
enum { CAUSE_SLUG = 48 };

/* The text of a language; "" where there is none. */
const char *phrase_text(struct phrase phrase, enum language language);
const char *message_text(const struct message *message, enum language language);

/* Sets both languages, printf style; both formats take the same arguments in the same order (use
 * %1$d positions to change the order in one language). What is too long is cut between characters.
 */
void message_say(struct message *message, const char *en, const char *es, ...)
    __attribute__((format(printf, 2, 4), format(printf, 3, 4)));

/* The same with a list of arguments, for functions that take a format themselves. */
void message_say_list(struct message *message, const char *en, const char *es, va_list arguments)
    __attribute__((format(printf, 2, 0), format(printf, 3, 0)));

/* Appends to both languages. */
void message_add(struct message *message, const char *en, const char *es, ...)
    __attribute__((format(printf, 2, 4), format(printf, 3, 4)));

/* Appends to one language: for texts whose words differ, not only their order. */
void message_en(struct message *message, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void message_es(struct message *message, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* The same with the arguments as a list, for functions that say messages of their own. */
void message_append(struct message *message, enum language language, const char *format,
                    va_list arguments) __attribute__((format(printf, 3, 0)));

/* No text. */
void message_clear(struct message *message);

/* Sets, or appends, a phrase. */
void message_set_phrase(struct message *message, struct phrase phrase);
void message_add_phrase(struct message *message, struct phrase phrase);

/* The message as a phrase, borrowed from it. */
struct phrase message_phrase(const struct message *message);

#endif
