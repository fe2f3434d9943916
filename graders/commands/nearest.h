/* Names like the one that was mistyped, for "there is no ...; nearest: ...". */
#ifndef GRADERS_COMMANDS_NEAREST_H
#define GRADERS_COMMANDS_NEAREST_H

#include <stddef.h>

/* Writes the names that `wanted` may have meant to `text`, the nearest first, at most three, with
 * commas between; empty when there are none. Near is what is spelt nearly so (a letter more, less
 * or other in every three, whatever the case) or holds the wanted name as a part.
 *
 * names  `count` names of at most 255 bytes; equal ones are told once */
void nearest_names(const char *wanted, const char *const *names, size_t count, char *text,
                   size_t capacity);

#endif
