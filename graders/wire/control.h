/* The page that the engine and the runner share: the handshake and what the runner measured.
 *
 * The engine writes a packet into the input region, sets call_index and wakes the runner; the
 * runner answers into the answer region, fills the rest of this page, sets done_index and wakes the
 * engine. The whole page can be overwritten by the student's code: the engine takes every field as
 * a claim, reads it once, and never follows a length from here without a bound. */
#ifndef GRADERS_WIRE_CONTROL_H
#define GRADERS_WIRE_CONTROL_H

#include <stdalign.h>
#include <stdatomic.h>
#include <stdint.h>

/* Descriptors that the runner finds open. */
enum { CONTROL_FD = 3, INPUT_FD = 4, ANSWER_FD = 5 };

enum { CONTROL_BYTES = 4096, INPUT_PAGE_BYTES = 4096 };

/* How the runner ends when it cannot map its regions, or cannot give up what the student's code
 * must not have. Either comes before it says that it is ready, or was not said by the runner. */
enum { EXIT_NO_REGIONS = 99, EXIT_NOT_SECLUDED = 97 };

/* The exit code by which a tool tells that it found an error, as text for its options. */
#define EXIT_TOOL_FOUND "86"

/* In done_index, by the engine: the runner is not ready yet. Ready is 0, as after no call. */
enum { NOT_READY = UINT32_MAX };

enum runner_mode {
    MODE_PLAIN = 0,
    MODE_COUNT = 1,    /* under callgrind */
    MODE_MEMCHECK = 2, /* under memcheck: report its error count after each call */
    MODE_STACK = 4     /* measure the stack */
};

/* Where the runner stood last, so that a crash can be told apart. */
enum runner_phase {
    PHASE_START,  /* before the student's function was called */
    PHASE_CALL,   /* inside it */
    PHASE_ANSWER, /* reading what it returned */
    PHASE_DONE
};

/* What a fault of memory was, as the runner's signal handler saw it. */
enum fault_kind {
    FAULT_NONE,
    FAULT_NULL,  /* an address below 64 KiB */
    FAULT_STACK, /* the stack is exhausted */
    FAULT_INPUT, /* a write to the input, or a read beyond its end */
    FAULT_OTHER
};

enum { CALL_QUIT = UINT32_MAX }; /* in call_index */

struct control {
    alignas(64) _Atomic uint32_t call_index; /* engine: 1, 2, ...; CALL_QUIT ends the runner */
    alignas(64) _Atomic uint32_t done_index; /* runner: the call that is done */

    /* engine to runner, before each call */
    uint64_t nonce; /* copied into `echo` when the answer is complete */
    uint64_t input_bytes;
    uint64_t input_capacity;    /* size of the input region, fixed */
    uint64_t answer_capacity;   /* size of the answer region, fixed */
    uint64_t heap_limit_bytes;  /* an allocation beyond this gets NULL */
    int64_t failing_allocation; /* the how-manieth allocation of the call gets NULL; 0: none */
    uint32_t mode;              /* runner_mode flags */
    uint32_t input_page;        /* the page of the input region at which the input begins */

    /* runner to engine, after each call */
    alignas(64) uint64_t echo;
    uint64_t answer_bytes;   /* may exceed the capacity: then the answer was too long */
    uint32_t phase;          /* runner_phase */
    uint32_t out_of_memory;  /* the student's function said that memory ran out */
    int64_t heap_peak_bytes; /* most bytes live at once during the call */
    int64_t heap_held_bytes; /* allocated by the call and live when it returned */
    int64_t heap_left_bytes; /* still live after everything returned was freed: leaked */
    int64_t leaked_blocks;
    int64_t allocation_count;
    int64_t refused_count;  /* allocations refused because of heap_limit_bytes */
    int64_t bad_free_count; /* free or realloc of a pointer that is no live block */
    int64_t prepared_bytes; /* most bytes live at once in what was prepared before the call */
    int64_t prepared_count; /* allocations of that */
    int64_t access_count;   /* calls of functions that the exercise gives, during the call */
    int64_t stack_bytes;    /* with MODE_STACK */
    int64_t tool_errors;    /* with MODE_MEMCHECK: errors so far */
    uint32_t fault;         /* fault_kind */
    uint32_t unset_table;   /* with MODE_MEMCHECK: where the answer was never written: 0 what was */
    int64_t unset_place; /* returned, 1 the first table ...; and 1 + the first such byte; 0: none */
};

#endif
