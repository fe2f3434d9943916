/* The dumps that callgrind writes while it counts a submission, as one stream.
 *
 * The submission runs in valgrind's process: whatever file valgrind may open, it may open as well,
 * and nobody outside can tell who wrote what. So each name under which callgrind dumps leads to the
 * same pipe, which only the engine can read. What is once written cannot be taken back, replaced or
 * kept from being seen; and callgrind numbers its dumps, the one at its end included. A dump that
 * was written by the submission is therefore one too many, or the number of a later one is wrong.
 */
#ifndef GRADERS_ENGINE_RUN_DUMPS_H
#define GRADERS_ENGINE_RUN_DUMPS_H

#include "bench/measure/callgrind.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct dumps {
    int fd;         /* the pipe's reading end; -1: none */
    char *text;     /* what came since the last dumps_take */
    size_t count;   /* of it */
    bool too_long;  /* more came than any honest dump has, and the rest is left unread */
    int64_t number; /* of the next dump */
};

/* No pipe: dumps_drain and dumps_release leave it alone. */
struct dumps dumps_none(void);

/* Makes the names of a base dump and of `count` numbered ones in a folder: "counts", "counts.1" ...
 * Nobody can read them by name, everybody can write to them.
 *
 * returns  0, or -1 and *err; dumps_release must follow in both cases */
int dumps_make(struct dumps *dumps, const char *folder, int count, struct error *err) MUST_CHECK;

/* Reads what has come so far; never waits. A pipe holds 64 KiB: whoever waits for the program calls
 * this meanwhile. The argument is a struct dumps (session_plan.meanwhile). */
void dumps_drain(void *dumps);

/* The dump that callgrind must have written by now, and nothing beside it.
 *
 * trigger  what must have made it dump, as in struct callgrind_dump
 * calls    as callgrind_parse_calls
 * returns  0, or -1 and *err: nothing came, or something that is not exactly this dump */
int dumps_take(struct dumps *dumps, const char *trigger, const struct callgrind_calls *calls,
               struct callgrind_dump *dump, struct error *err) MUST_CHECK;

void dumps_release(struct dumps *dumps);

#endif
