/* Disjoint groups (union-find by Tarjan): which of n things hang together. */
#ifndef REFERENCE_MESH_GROUPS_H
#define REFERENCE_MESH_GROUPS_H

#include "reference/base/error.h"

#include <stdbool.h>
#include <stdint.h>

struct groups {
    int32_t *parent; /* towards the root; a root is its own parent */
    uint8_t *parity; /* 1: opposite to the parent; see groups_join_parity */
};

/* Makes `count` (0 ... INT32_MAX) groups of one thing each; the caller owns them (groups_release).
 * Returns 0, or -1 and *err (out of memory). */
int groups_init(struct groups *groups, int64_t count, struct error *err) MUST_CHECK;
void groups_release(struct groups *groups);

/* Joins the groups of a and b. Returns true when they were two groups until now. Cost: logarithmic
 * at worst, nearly constant in the long run. */
bool groups_join(struct groups *groups, int32_t a, int32_t b);

/* The thing that stands for the group of i: the same for all of a group, until it is joined with
 * another. Cost as above. */
int32_t groups_root(struct groups *groups, int32_t i);

/* Joins as above and remembers whether a and b are opposite to each other (two triangles of which
 * one must be flipped). Returns false when this contradicts what was joined before. */
bool groups_join_parity(struct groups *groups, int32_t a, int32_t b, bool opposite);

#endif
