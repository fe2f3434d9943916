/* How deep the stack went in a call.
 *
 * Before the call the pages below are given back to the kernel; after it, those that are there again
 * were used. Nothing that the call writes can undo that, and the engine sees the same pages from
 * outside, in the growth of the process: what is claimed too low there is memory that nothing
 * explains (graders/engine/run/count.c). */
#ifndef GRADERS_RUNNER_STACK_H
#define GRADERS_RUNNER_STACK_H

#include <stdint.h>

/* Once, before the first call. */
void stack_prepare(void);

/* Right before the call, and after all that follows it: none of the pages below is resident any
 * more. */
void stack_give_back(void);

/* Right after the call: bytes from where stack_give_back was called down to the lowest that was
 * used. */
int64_t stack_used_bytes(void);

#endif
