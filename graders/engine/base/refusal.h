/* Why something that a student handed in cannot be taken: a slug for machines, one sentence for
 * people in English and Spanish. Filled by the screens (upload, policy, screen); a refusal is a
 * verdict on the submission, unless the machine is at fault, which only the upload can say. */
#ifndef GRADERS_ENGINE_BASE_REFUSAL_H
#define GRADERS_ENGINE_BASE_REFUSAL_H

#include "reference/base/phrase.h"

#include <stdbool.h>
#include <stddef.h>

enum { REFUSAL_NAME = 64 };

struct refusal {
    bool refused;
    bool is_fault;            /* no doing of the student: reported, never marked */
    char cause[CAUSE_SLUG];   /* "constructor", "inline-assembly", "archive-link", ... */
    struct phrase cause_name; /* borrowed from the cause */
    struct message message;   /* may quote the student's names: untrusted, printable ASCII */
};

/* Refuses; only the first refusal counts. The cause must stay. Both formats take the same arguments
 * in the same order (use %1$s positions to change the order in one language). Returns -1. */
int refuse(struct refusal *refusal, const struct cause *cause, const char *en, const char *es, ...)
    __attribute__((format(printf, 3, 5), format(printf, 4, 5)));

/* The same with a message that is composed already. */
int refuse_saying(struct refusal *refusal, const struct cause *cause,
                  const struct message *message);

/* Gives a refusal another cause. */
void refusal_rename(struct refusal *refusal, const struct cause *cause);

/* A name that a student chose, made fit to stand in a message: printable ASCII, `?` for every other
 * byte, cut with "..." when longer than the buffer.
 *
 * bytes  `count` bytes, need not end in zero
 * out    REFUSAL_NAME chars
 * returns out */
const char *refusal_name(char out[REFUSAL_NAME], const char *bytes, size_t count);

#endif
