/* A worker process (worker.h) seen from the side that asks: started, told a line, read a line. */
#ifndef BENCH_MEASURE_PROCESS_H
#define BENCH_MEASURE_PROCESS_H

#include "reference/base/error.h"

#include <stdbool.h>
#include <sys/types.h>

enum { PROCESS_LINE_CAPACITY = 1024 };

struct process {
    pid_t pid; /* 0: none */
    int to, from;
    char line[PROCESS_LINE_CAPACITY]; /* its last answer, without the newline */
    char rest[PROCESS_LINE_CAPACITY]; /* read, not yet an answer */
    int rest_length;
};

/* One that was not started. */
struct process process_none(void);

/* Starts a program with pipes at its input and output; what it says on stderr is dropped. It dies
 * when we do.
 *
 * argv         ends with NULL; argv[0] is a path
 * environment  more variables, "NAME=value", ends with NULL; NULL: none
 * returns      0, or -1 and *err. A program that cannot be executed shows at the first answer. */
int process_start(struct process *process, const char *const *argv, const char *const *environment,
                  struct error *err) MUST_CHECK;

/* Waits for a line. Returns 0, or -1 and *err: it ended (how), said nothing for `seconds`, or said
 * too long a line. */
int process_read(struct process *process, int seconds, struct error *err) MUST_CHECK;

/* Tells a line, "warm area" say, and waits for the answer. */
int process_ask(struct process *process, const char *verb, const char *name, int seconds,
                struct error *err) MUST_CHECK;

/* Closes the pipes and waits for the end; kills it when it does not end within `seconds`. Returns
 * whether it ended by itself with 0. A process that was not started, or stopped before, is true. */
bool process_stop(struct process *process, int seconds);

#endif
