/* Boxes in a tree, to find those that meet a box, or each other.
 *
 * The items are sorted along a curve that fills space (Morton 1966), and neighbours on it share
 * nodes. Boxes that meet in a point meet. */
#ifndef REFERENCE_SURVEY_BOX_TREE_H
#define REFERENCE_SURVEY_BOX_TREE_H

#include "reference/base/error.h"

#include <stdbool.h>
#include <stdint.h>

struct bounds {
    float low[3], high[3]; /* finite, low <= high */
};

struct box_tree {
    struct bounds *boxes; /* in the order of the curve */
    int32_t *items;       /* their numbers */
    struct bounds *nodes; /* node i has children 2i + 1 and 2i + 2 */
    int32_t count, leaf_count;
};

/* Builds a tree of `count` boxes, copied; it belongs to the caller (box_tree_release). Returns 0,
 * or -1 and *err (out of memory). O(n log n), 60 bytes an item. */
int box_tree_build(struct box_tree *tree, const struct bounds *boxes, int32_t count,
                   struct error *err) MUST_CHECK;
void box_tree_release(struct box_tree *tree);

/* Visits the items whose boxes meet the box, in no promised but always the same order, until visit
 * returns false. */
void box_tree_find(const struct box_tree *tree, const struct bounds *box,
                   bool (*visit)(void *context, int32_t item), void *context);

/* Visits every pair whose boxes meet, once, until visit returns false: by their places on the curve, the
 * earlier first, so that who keeps data in that order finds it together. The item at a place is
 * tree->items[place]. */
void box_tree_find_pairs(const struct box_tree *tree,
                         bool (*visit)(void *context, int32_t one, int32_t other), void *context);

/* The smallest box around points: start with bounds_empty. */
struct bounds bounds_empty(void);
void bounds_include(struct bounds *box, const float point[3]);

#endif
