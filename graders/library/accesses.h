/* Counted accesses: an exercise gives the student functions to read a structure, element by element
 * (exercise.json's "given", graders/runner/call.h), and each call of them is one access.
 *
 *     if (accesses_reject(task->usage, least, out))   fewer than any right answer needs
 *         return 0;
 *     judge_quality(out, (double)task->usage->access_count / listed);
 *     judge_accept(out);
 *
 * The count is a claim of the student's process. So a judge says what a right answer to this input
 * needs at the least, and the engine compares the claims on sized inputs with callgrind's count of
 * the same calls; what differs there is flagged. Against the reference's own count an answer is
 * judged by exercise.json's "accesses". */
#ifndef GRADERS_LIBRARY_ACCESSES_H
#define GRADERS_LIBRARY_ACCESSES_H

#include "graders/library/judge.h"

/* Rejects an answer whose accesses cannot be true. Returns whether it did. */
bool accesses_reject(const struct usage *usage, int64_t least, struct judgement *out);

#endif
