/* Strips of a mesh whose triangles are in a good order already, such as one for the vertex cache:
 * that order is kept but for a few places, and what it is good for stays. Where the triangles have
 * no order, stripify.h makes longer strips; the sequence of indices is the same kind.
 *
 * Algorithm: a window slides over the triangles, and a strip goes on with any triangle of the
 * window that shares the side at which it ends; when there is none, through the other side of its
 * last triangle (which repeats a vertex); else the oldest triangle of the window begins a new
 * strip. No twins are looked for, and nothing is kept outside of the window.
 *
 * Source: the window is meshoptimizer's (meshopt_stripify, by Kapoulkine), of 8 triangles there.
 * Cost: linear; a comparison of a side with 16 triangles, which is one vector of 512 bits, once or
 * twice a triangle. */
#ifndef REFERENCE_KERNELS_STRIPS_IN_ORDER_H
#define REFERENCE_KERNELS_STRIPS_IN_ORDER_H

#include "reference/kernels/kernel.h"

enum { STRIP_WINDOW = 16 }; /* triangles that are looked at for the next one */

/* The contract of kernel.h, without scratch. Output as that of stripify (stripify.h): at most
 * 4 * triangle_count indices, strips parted by STRIP_RESTART, every triangle once, rotated but not
 * turned over. */
int64_t strips_in_order_plain(const struct mesh *mesh, void *scratch, void *output);
#if defined(__x86_64__)
int64_t strips_in_order_avx512(const struct mesh *mesh, void *scratch, void *output);
#endif

#endif
