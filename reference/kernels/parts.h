/* Ranges of vertices, for kernels that first sort a scattered mesh by them: what belongs to one
 * part then stays in a core's cache while it is worked on. */
#ifndef REFERENCE_KERNELS_PARTS_H
#define REFERENCE_KERNELS_PARTS_H

#include "reference/kernels/order.h"

#include <stdint.h>

/* Parts of 64 KiB of rows stay in the second-level cache also on a busy machine. More parts than
 * these at once would outgrow the first level by the lines to which they are being written. */
enum { LEAST_PART_BITS = 10, MOST_PARTS = 1024 };

struct parts {
    int shift;                /* vertex v is of part v >> shift */
    int32_t ends[MOST_PARTS]; /* of each part's entries; while filling, where the next one goes */
};

/* Counts the entries of each part, three a triangle: two of its least corner, one of the middle
 * one. ends then holds where each part begins. */
static inline void parts_begin(struct parts *parts, const struct mesh *mesh)
{
    *parts = (struct parts){.shift = LEAST_PART_BITS};
    while (mesh->vertex_count >> parts->shift >= MOST_PARTS)
        parts->shift++;
    const int32_t *t = mesh->triangles;
    for (int32_t left = mesh->triangle_count; left > 0; left--, t += 3) {
        struct sorted s = sort_corners(t);
        parts->ends[s.low >> parts->shift] += 2;
        parts->ends[s.middle >> parts->shift]++;
    }
    int32_t total = 0;
    for (int k = 0; k < MOST_PARTS; k++) {
        int32_t count = parts->ends[k];
        parts->ends[k] = total;
        total += count;
    }
}

#endif
