/* The words that reports use, in the two languages of the course. */
#ifndef GRADERS_REPORT_WORDS_H
#define GRADERS_REPORT_WORDS_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

/* A text in both languages; neither is NULL. */
struct words {
    const char *en, *es;
};

/* The text {en, es} under `key` of an object, borrowed from it; both empty when there is none. */
struct words words_in(const json_t *object, const char *key);

const char *words_choose(struct words words, bool spanish);

/* "wrong answer" / "respuesta incorrecta" for "wrong-answer"; the verdicts are those of
 * graders/report/README.md, `not-measured` and `not-reached` included. */
struct words words_verdict(const char *verdict);
bool words_know_verdict(const char *verdict);

/* What sort of outcome a verdict is, for its colour and symbol. */
enum outcome {
    OUTCOME_PASSED,
    OUTCOME_PARTIAL, /* never a verdict's: some points were given and some lost */
    OUTCOME_FAILED,
    OUTCOME_UNSCORED, /* fault or flagged: a person must look */
    OUTCOME_ABSENT    /* nothing submitted, not measured, not reached */
};
enum { OUTCOME_COUNT = OUTCOME_ABSENT + 1 };
enum outcome words_outcome(const char *verdict);

/* One word for an outcome, also its CSS class (in English), and its symbol. */
struct words words_of_outcome(enum outcome outcome);
const char *words_symbol(enum outcome outcome);

/* A slug as words: "duplicate-edge" becomes "duplicate edge"; a "self-edge" is told as the
 * "degenerate edge" that its mark shows. Writes at most `capacity` bytes. */
void words_of_slug(const char *slug, char *text, size_t capacity);

/* A cause for people: "duplicate edge", "arista duplicada" for "duplicate-edge"; a verdict's words
 * for a verdict. The English words go to `text`, at most `capacity` bytes; causes that are not
 * known stay English. */
struct words words_cause(const char *slug, char *text, size_t capacity);

/* An element of a case, "edge 3 (1,0)", "arista 3 (1,0)". The Spanish words go to `spanish`, at
 * most `capacity` bytes; the English are `element` itself. */
struct words words_element(const char *element, char *spanish, size_t capacity);

/* Bytes in the course's units, where a KB is 1024 bytes: "3375 bytes", "64.5 KB", "970 KB". Writes
 * at most `capacity` bytes. */
void words_of_bytes(double bytes, char *text, size_t capacity);

/* Points without needless zeros: "10", "7.5", "0.25". Writes at most `capacity` bytes. */
void words_of_points(double points, char *text, size_t capacity);

#endif
