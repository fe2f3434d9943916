/* The words that reports use, in the two languages of the course. */
#ifndef GRADERS_REPORT_WORDS_H
#define GRADERS_REPORT_WORDS_H

#include "graders/engine/base/verdict.h"

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

/* The text under `key` of an object, borrowed from it: {en, es}, or a string, which stands for
 * both. Both are empty when there is none. */
struct phrase words_in(const json_t *object, const char *key);

/* "wrong answer" / "respuesta incorrecta" for "wrong-answer"; the verdicts are those of
 * graders/report/README.md, `not-measured` and `not-reached` included. */
struct phrase words_verdict(const char *verdict);
bool words_know_verdict(const char *verdict);

/* What sort of verdict it is; one that is not known is absent. */
enum standing words_standing(const char *verdict);

/* One word for a standing, also its CSS class (in English), and its symbol. */
struct phrase words_of_standing(enum standing standing);
const char *words_symbol(enum standing standing);

/* The cause of a case, check or result, for people: its `cause_name`; in a result without one (of
 * an earlier version) the slug with spaces for dashes, written to `room`. */
struct phrase words_cause(const json_t *part, char *room, size_t capacity);

/* Bytes in the course's units, where a KB is 1024 bytes: "3375 bytes", "64.5 KB", "970 KB". Writes
 * at most `capacity` bytes. */
void words_of_bytes(double bytes, char *text, size_t capacity);

/* measures.quality in a line: "1.31 indices per triangle (fair 1.6, good 1.25)". */
void words_of_quality(const json_t *quality, struct message *text);

/* Points without needless zeros: "10", "7.5", "0.25". Writes at most `capacity` bytes. */
void words_of_points(double points, char *text, size_t capacity);

#endif
