/* A region: memory that the engine shares with a box by descriptor, of sealed size.
 *
 * The size cannot change (a shrink by the box would turn the engine's reads into SIGBUS). An input
 * region can be written through the engine's mapping only, never through the descriptor. */
#ifndef GRADERS_ENGINE_RUN_REGION_H
#define GRADERS_ENGINE_RUN_REGION_H

#include "reference/base/error.h"

#include <stdbool.h>
#include <stddef.h>

struct region {
    int fd; /* -1: none */
    unsigned char *bytes;
    size_t capacity; /* a multiple of the page size */
};

/* Makes a region of at least `bytes` bytes, all zero. The caller owns it (region_release).
 *
 * input    true: the box may only read it
 * returns  0, or -1 and *err (then *region is the empty one) */
int region_make(struct region *region, size_t bytes, bool input, struct error *err) MUST_CHECK;

/* Unmaps and closes; the empty region (bytes NULL) may be released. */
void region_release(struct region *region);

#endif
