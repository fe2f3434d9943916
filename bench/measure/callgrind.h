/* What valgrind's callgrind counted around one call: its dump, read from memory.
 *
 * The counts repeat bit for bit when program, input, arguments and environment are the same. The
 * run that gives one dump a call:
 *
 *     valgrind -q --tool=callgrind --vgdb=no --cache-sim=yes --I1=32768,8,64 --D1=32768,8,64
 *       --LL=8388608,16,64 --dump-line=no --dump-before=f --callgrind-out-file=counts program
 *
 * where the program calls the function f after each call that is to be counted: counts.1, counts.2,
 * ... are these; the file without a number is the end of the program.
 *
 * Source: "Callgrind Format Specification" in valgrind's manual. */
#ifndef BENCH_MEASURE_CALLGRIND_H
#define BENCH_MEASURE_CALLGRIND_H

#include "reference/base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct callgrind_counts {
    int64_t instructions; /* Ir */
    int64_t data_reads;   /* Dr */
    int64_t data_writes;  /* Dw */
    int64_t l1_misses;    /* I1mr + D1mr + D1mw */
    int64_t ll_misses;    /* ILmr + DLmr + DLmw: misses of the last level */
};

enum { CALLGRIND_HOTTEST = 8, CALLGRIND_NAME = 96 };

struct callgrind_function {
    char name[CALLGRIND_NAME]; /* printable ASCII, cut when longer; untrusted text */
    int64_t instructions;      /* executed by the function itself, not by what it calls */
};

struct callgrind_dump {
    int64_t part;     /* 1, 2, ...: the how-manieth dump of the run */
    char trigger[80]; /* what made it dump: "--dump-before=function", "Client Request: label",
                         "Program termination" */
    char label[64];   /* of CALLGRIND_DUMP_STATS_AT, "" when something else dumped */
    bool has_misses;  /* false: no cache simulation, and all but instructions are 0 */
    struct callgrind_counts counts; /* all that was collected */
    struct callgrind_counts
        called; /* of that, what certain calls took; see callgrind_parse_calls */
    struct callgrind_counts prepared; /* what other calls of these took; likewise */
    int64_t access_count;             /* calls of certain functions; likewise */
    int hottest_count;                /* functions with instructions of their own, most first */
    struct callgrind_function hottest[CALLGRIND_HOTTEST];
};

/* Reads one dump (one file: dumps combined into one file are refused).
 *
 * text, bytes  the file; need not end in a newline or zero; may be hostile
 * returns      0, or -1 and *err (names the line): not a dump, no instruction count, a count above
 *              10^15, more than 65,536 functions, out of memory
 * Cost: one pass over the text; memory proportional to the largest function number. */
int callgrind_parse(const char *text, size_t bytes, struct callgrind_dump *dump,
                    struct error *err) MUST_CHECK;

/* Calls that are looked for, by the names of functions; lists end with NULL. */
struct callgrind_calls {
    const char *caller;           /* NULL: none are added up */
    const char *const *callees;   /* what its calls of these took, with all that they call in turn,
                                     goes to dump->called */
    const char *preparer;         /* the same calls from this function go to dump->prepared; NULL:
                                     there is none */
    const char *const *accessors; /* how often these are called, by whatever function, goes to
                                     dump->access_count; NULL: none are counted */
};

/* The same, and what those calls come to. */
int callgrind_parse_calls(const char *text, size_t bytes, const struct callgrind_calls *calls,
                          struct callgrind_dump *dump, struct error *err) MUST_CHECK;

/* Counted cost: instructions + 10 first-level + 100 last-level misses, a stand-in for time that
 * repeats exactly. Against time it is within a factor of 2 or so between honest algorithms, so it
 * is one witness of two, never the only one. */
int64_t callgrind_cost(const struct callgrind_counts *counts);

#endif
