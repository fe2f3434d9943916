/* A session: one program in a box, called any number of times over the shared control page.
 *
 *   engine                         box
 *   session_start  ---- spawn ---> runner maps the regions
 *                  <--- futex ---- ready, waits
 *   session_call   ---- futex ---> run_call: the student's function, once
 *                  <--- futex ---- answer and claims
 *   session_end    ---- kill, or where its end tells something:
 *                  ---- quit ----> ends; killed if it does not
 *
 * What comes back is claims and bytes of untrusted code. A session never blocks: CPU time and idle
 * time are limited for every call, and for all runs of a submission together. */
#ifndef GRADERS_ENGINE_RUN_SESSION_H
#define GRADERS_ENGINE_RUN_SESSION_H

#include "graders/box/box.h"
#include "graders/engine/base/budget.h"
#include "graders/engine/run/region.h"
#include "graders/wire/control.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What to start. Zero it, then fill it. */
struct session_plan {
    enum box_profile profile;
    int program_fd;              /* BOX_RUN: the static program; -1: argv */
    char *const *argv;           /* BOX_TOOLS: what to run, paths inside the box */
    char *const *envp;           /* NULL: the box's own */
    const char *work_folder;     /* host folder seen as /work, or NULL */
    const char *covered;         /* as in struct box_plan, */
    const char *uncovered;       /* and the one file in it that is seen; both or none */
    const struct region *input;  /* borrowed for the session's life */
    size_t answer_bytes;         /* capacity of the answer region */
    uint32_t mode;               /* runner_mode flags */
    int64_t heap_limit_bytes;    /* what the student's function may hold; 0: no limit of ours */
    uint64_t memory_limit_bytes; /* of the whole box */
    unsigned cpu_seconds;        /* hard limit of the whole session */
    struct budget *budget;       /* of the submission, borrowed; NULL: none */
    bool ends_by_itself;         /* its end tells something: it is told to quit, and gets some time
                                    for that. Else it is killed where it stands: what it would
                                    still do concerns nobody */
    int cpu;                     /* pin, -1: not */
    /* Called with its argument every few milliseconds while the program is waited for; NULL: not */
    void (*meanwhile)(void *argument);
    void *meanwhile_argument;
};

/* How a call ended. */
enum call_end {
    CALL_ANSWERED, /* the runner says it is done, with the right nonce */
    CALL_CPU,      /* more CPU time than allowed */
    CALL_IDLE,     /* neither working nor waiting for a CPU */
    CALL_SPENT,    /* more than is left of the submission's budget */
    CALL_DIED,     /* the program ended: the outcome of session_end tells how */
    CALL_NOT_READY /* the same, before the runner was ready: no code of a submission had run */
};

struct call_limits {
    int64_t cpu_ns;
    int64_t
        idle_ns; /* wall time in which it slept: it neither had nor waited for a CPU or a disk */
};

struct session {
    struct box box;
    struct region control_region, answer, output;
    struct control *control;
    uint32_t call_index;
    uint32_t input_page; /* of the input region, where the next call's input begins; 0 at first */
    bool alive, is_ready, ends_by_itself;
    struct budget *budget;
    int64_t taken_cpu_ns; /* from the budget, so far */
    int64_t cpu_start_ns; /* CPU time charged before the present call */
    void (*meanwhile)(void *argument);
    void *meanwhile_argument;
    /* of the last call */
    struct control claims; /* a copy, taken once; every field is a claim */
    int64_t call_cpu_ns;   /* charged by the engine's own reading */
};

/* Starts the program. Returns 0, or -1 and *err: a fault, nothing is left behind. */
int session_start(struct session *session, const struct session_plan *plan,
                  struct error *err) MUST_CHECK;

/* Waits until the runner has its memory and stands before its first call: every end that comes
 * later is the submission's, whatever it writes into the page. session_call does so by itself.
 * Returns CALL_ANSWERED, or CALL_NOT_READY or CALL_SPENT: the program is dead. */
enum call_end session_await_ready(struct session *session);

/* Calls once with `input_bytes` bytes of the input region, from session->input_page on. The first
 * call begins when the runner is ready; what it needs for that is charged to no call.
 *
 * failing_allocation  as struct control; 0: none
 * returns             how it ended. After anything but CALL_ANSWERED the program is dead, and
 *                     session_end must follow. */
enum call_end session_call(struct session *session, size_t input_bytes, int64_t failing_allocation,
                           const struct call_limits *limits);

/* Ends the program, tells how it went, and from then on nothing can change the answer region or the
 * output any more. Returns 0, or -1 and *err (a fault of the box). */
int session_end(struct session *session, struct box_outcome *outcome, struct error *err) MUST_CHECK;

/* What the program printed (stdout and stderr), untrusted: copies at most `capacity` - 1 bytes and
 * ends them with a zero byte. Returns the number of bytes printed. */
size_t session_output(const struct session *session, char *text, size_t capacity);

/* Frees the regions. */
void session_release(struct session *session);

#endif
