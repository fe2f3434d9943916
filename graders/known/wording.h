/* Whether what a student reads was put together well: messages are composed of pieces, and pieces may
 * meet badly. */
#ifndef GRADERS_KNOWN_WORDING_H
#define GRADERS_KNOWN_WORDING_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

/* Looks through every message and summary of a result, in each language: a sentence that begins
 * without a blank before it ("the face.After"), two blanks, a blank before a stop or at an end, no stop
 * at the end. When there is one, `why` quotes it. */
bool wording_is_sound(json_t *result, char *why, size_t capacity);

#endif
