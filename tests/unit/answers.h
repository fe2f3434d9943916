/* Answers of any bytes against a judge: it must judge each without a fault, give a reason for each
 * rejection, and never change its mind. Under a sanitizer this also finds reads out of bounds. */
#ifndef TESTS_UNIT_ANSWERS_H
#define TESTS_UNIT_ANSWERS_H

#include "graders/library/judge.h"

/* Takes the reference's answer to every case (of at most 64 KB, to an input of at most 256 KB) and
 * gives the judge `rounds` changed ones in all, with a seed of its own each: cut off, bits flipped,
 * values replaced by extremes, NaN and values from elsewhere, or all random. Fails the test when a
 * rule above is broken. An answer that is accepted although it differs is judged by the caller's
 * other tests, not here: permutations are legal. */
void answers_fuzz(const struct judge *judge, const char *group, int rounds);

/* What is no answer at all to a case must be rejected: nothing, the right answer cut short, random
 * bytes of its length, and huge counts. Takes every public case. */
void answers_refuse_garbage(const struct judge *judge, const char *group);

#endif
