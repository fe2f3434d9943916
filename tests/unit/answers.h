/* Answers of any bytes against a judge: it must judge each without a fault, give a reason for each
 * rejection, and never change its mind. Under a sanitizer this also finds reads out of bounds. */
#ifndef TESTS_UNIT_ANSWERS_H
#define TESTS_UNIT_ANSWERS_H

#include "graders/judges/judge.h"

/* Takes the reference's answer to every case (at most 64 KB of it) and gives the judge `rounds`
 * changed ones in all, with a seed of its own each: cut off, bits flipped, values replaced by
 * extremes, NaN and values from elsewhere, or all random. Fails the test when a rule above is
 * broken. An answer that is accepted although it differs is judged by the caller's other tests, not
 * here: permutations are legal. */
void answers_fuzz(const struct judge *judge, const char *group, int rounds);

#endif
