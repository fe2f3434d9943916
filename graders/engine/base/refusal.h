/* Why something that a student handed in cannot be taken: a slug for machines, one sentence for
 * people in English and Spanish. Filled by the screens (upload, policy, screen); a refusal is a
 * verdict on the submission, unless the machine is at fault, which only the upload can say. */
#ifndef GRADERS_ENGINE_BASE_REFUSAL_H
#define GRADERS_ENGINE_BASE_REFUSAL_H

#include <stdbool.h>
#include <stddef.h>

enum { REFUSAL_TEXT = 400, REFUSAL_NAME = 64 };

struct refusal {
    bool refused;
    bool is_fault;                 /* no doing of the student: reported, never marked */
    char cause[48];                /* "constructor", "inline-assembly", "archive-symlink", ... */
    char message[REFUSAL_TEXT];    /* may quote the student's names: untrusted, printable ASCII */
    char message_es[REFUSAL_TEXT]; /* the same in Spanish, UTF-8 */
};

/* Refuses; only the first refusal counts. Both formats take the same arguments in the same order
 * (use %1$s positions to change the order in one language). Returns -1. */
int refuse(struct refusal *refusal, const char *cause, const char *english, const char *spanish,
           ...) __attribute__((format(printf, 3, 5), format(printf, 4, 5)));

/* A name that a student chose, made fit to stand in a message: printable ASCII, `?` for every other
 * byte, cut with "..." when longer than the buffer.
 *
 * bytes  `count` bytes, need not end in zero
 * out    REFUSAL_NAME chars
 * returns out */
const char *refusal_name(char out[REFUSAL_NAME], const char *bytes, size_t count);

#endif
