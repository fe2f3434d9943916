/* Counts the rows of tables that queries read.
 *
 * The sources of the representations are compiled a second time with the compiler's instrumentation
 * of memory accesses (-fsanitize=thread), in which it calls a function before every read. The
 * sanitizer's own library is not linked: the functions are ours, and count. So what is counted is
 * the very source that is timed, nothing in it is marked by hand, and nothing that is timed counts.
 * The Makefile joins the counted objects into one with a single name, the table below.
 *
 * An access is the reading of a row of a table. A row read again while it is the last one read of
 * its table counts once: its parts are not counted one by one. Not for several threads. */
#ifndef BENCH_COMPARE_COUNTED_READS_H
#define BENCH_COMPARE_COUNTED_READS_H

#include "reference/representation/representation.h"

/* The representations of representation_table, with instrumented functions. */
extern const struct representation *const counted_representation_table[];

/* From here on counts what is read of the tables of `self`, which a kind of the table above made.
 */
void counted_reads_begin(const struct representation *kind, const void *self);

/* Ends counting; returns the accesses since it began. */
int64_t counted_reads_end(void);

#endif
