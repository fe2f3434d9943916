/* What each exercise gives to the runner: how to call the student's function once.
 *
 * graders/runner/<group>/<name>.c defines run_call, includes the exercise's public header (as
 * "<name>.h") and this file, and does four plain steps: read the arguments from the packet, call
 * the student's function between measure_begin() and measure_end(), write the answer, free what the
 * student returned. It runs inside the box, in the student's process: it is believed in nothing,
 * and all that it writes is judged as bytes that may be anything.
 *
 * Arrays from the packet lie in memory that cannot be written; hand them to the student in place.
 * Follow a pointer that the student returned only to write the answer (a wild one then ends this
 * process, and the verdict says so). Free what was returned with free(): what is left afterwards is
 * the student's leak. Never allocate between measure_begin() and measure_end(). */
#ifndef GRADERS_RUNNER_CALL_H
#define GRADERS_RUNNER_CALL_H

#include "graders/wire/packet.h"

/* The student's function reported, in the exercise's documented way, that memory ran out. Say so
 * instead of writing an answer. */
void call_out_of_memory(void);

/* One call: reads `input`, calls the student, writes `answer`. The work that is counted is what the
 * exercise's functions take when they are called from here, from this very function. */
void run_call(struct reader *input, struct writer *answer);

/* Around the student's call, and nothing else: allocations and stack count from here ... */
void measure_begin(void);

/* ... to here. Exactly one pair in a call of run_call. */
void measure_end(void);

/* Before what the student returned is written, or looked at: was it ever set? Under memcheck, which
 * knows, these end the process when it was not, and say where; elsewhere they do nothing. Tables are
 * looked at in the order of the answer; one that cannot be read as far as that is left to memcheck. */
void look_at_result(const void *result, size_t bytes);
void look_at_table(const void *table, size_t bytes);

/* An exercise that builds a structure and is then asked queries has both measured apart: a call is
 * either a building or a round of queries (the case's number says which). For queries the runner
 * builds first, in a function that is called run_prepare and is not inlined, between these two: that
 * is not the call, whose measures begin afterwards. What was built is asked, and released, in that
 * function too, after measure_end(). */
void prepare_begin(void);
void prepare_end(void);

/* An exercise may give the student functions to ask for what they need, element by element. Its
 * header declares them, exercise.json lists them as "given", and the file of run_call defines them,
 * the only functions in it beside run_call that are not static: these are what a submission can
 * call. Each begins with this, which counts the call. What they read is kept in static variables of
 * that file, which run_call sets before measure_begin(). */
void count_access(void);

#endif
