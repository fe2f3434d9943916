/* Cause, element and message of a judgement for people. Judges name causes by slugs and elements in
 * English; this file goes when they declare both languages themselves. */
#ifndef GRADERS_ENGINE_RUN_JUDGEMENT_WORDS_H
#define GRADERS_ENGINE_RUN_JUDGEMENT_WORDS_H

#include "graders/engine/run/attempt.h"

/* Fills the texts of an attempt from what the judge said. */
void judgement_words(const struct judgement *judgement, struct attempt *attempt);

#endif
