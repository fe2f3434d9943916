/* A tree of boxes; see box_tree.h. */
#include "reference/survey/box_tree.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LEAF_ITEMS = 4, CURVE_BITS = 20, DEPTH_LIMIT = 64 };

struct bounds bounds_empty(void)
{
    return (struct bounds){{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
}

void bounds_include(struct bounds *box, const float point[3])
{
    for (int axis = 0; axis < 3; axis++) {
        box->low[axis] = fminf(box->low[axis], point[axis]);
        box->high[axis] = fmaxf(box->high[axis], point[axis]);
    }
}

/* An empty box adds nothing. */
static void include_box(struct bounds *box, const struct bounds *other)
{
    for (int axis = 0; axis < 3; axis++) {
        box->low[axis] = fminf(box->low[axis], other->low[axis]);
        box->high[axis] = fmaxf(box->high[axis], other->high[axis]);
    }
}

static inline bool boxes_meet(const struct bounds *a, const struct bounds *b)
{
    return a->low[0] <= b->high[0] && b->low[0] <= a->high[0] && a->low[1] <= b->high[1] &&
           b->low[1] <= a->high[1] && a->low[2] <= b->high[2] && b->low[2] <= a->high[2];
}

/* -- the curve -------------------------------------------------------------------------------- */

struct place_on_curve {
    uint64_t place;
    int32_t item;
};

/* Puts two zero bits before each of the low 20 bits. */
static uint64_t spread(uint64_t bits)
{
    bits = (bits | bits << 32) & UINT64_C(0x001f00000000ffff);
    bits = (bits | bits << 16) & UINT64_C(0x001f0000ff0000ff);
    bits = (bits | bits << 8) & UINT64_C(0x100f00f00f00f00f);
    bits = (bits | bits << 4) & UINT64_C(0x10c30c30c30c30c3);
    return (bits | bits << 2) & UINT64_C(0x1249249249249249);
}

static uint64_t place_of(const struct bounds *box, const struct bounds *all)
{
    uint64_t place = 0;
    for (int axis = 0; axis < 3; axis++) {
        double size = (double)all->high[axis] - (double)all->low[axis];
        double middle = ((double)box->low[axis] + (double)box->high[axis]) / 2;
        double share = size > 0 ? (middle - (double)all->low[axis]) / size : 0;
        place |= spread((uint64_t)(share * ((1 << CURVE_BITS) - 1))) << axis;
    }
    return place;
}

/* Sorts by place, 11 bits at a time, equal ones as they came. `room` is as large as `places`;
 * returns which of the two holds the result. */
static struct place_on_curve *sort_places(struct place_on_curve *places,
                                          struct place_on_curve *room, int32_t count)
{
    enum { BITS = 12, BUCKETS = 1 << BITS };
    static const int passes = 3 * CURVE_BITS / BITS;
    int32_t starts[BUCKETS + 1];
    for (int pass = 0; pass < passes; pass++) {
        int shift = pass * BITS;
        memset(starts, 0, sizeof starts);
        for (int32_t i = 0; i < count; i++)
            starts[(places[i].place >> shift & (BUCKETS - 1)) + 1]++;
        for (int b = 0; b < BUCKETS; b++)
            starts[b + 1] += starts[b];
        for (int32_t i = 0; i < count; i++)
            room[starts[places[i].place >> shift & (BUCKETS - 1)]++] = places[i];
        struct place_on_curve *sorted = room;
        room = places;
        places = sorted;
    }
    return places;
}

/* -- building --------------------------------------------------------------------------------- */

/* The items that lie below a leaf. */
static int32_t leaf_begin(const struct box_tree *tree, int32_t leaf)
{
    int64_t begin = (int64_t)leaf * LEAF_ITEMS;
    return begin < tree->count ? (int32_t)begin : tree->count;
}

/* Leaves are the last leaf_count nodes, a power of two. */
static void fill_nodes(struct box_tree *tree)
{
    for (int32_t leaf = 0; leaf < tree->leaf_count; leaf++) {
        struct bounds box = bounds_empty();
        for (int32_t i = leaf_begin(tree, leaf); i < leaf_begin(tree, leaf + 1); i++)
            include_box(&box, &tree->boxes[i]);
        tree->nodes[tree->leaf_count - 1 + leaf] = box;
    }
    for (int32_t node = tree->leaf_count - 2; node >= 0; node--) {
        tree->nodes[node] = tree->nodes[2 * node + 1];
        include_box(&tree->nodes[node], &tree->nodes[2 * node + 2]);
    }
}

static void sort_items(struct box_tree *tree, const struct bounds *boxes,
                       struct place_on_curve *places)
{
    struct bounds all = bounds_empty();
    for (int32_t i = 0; i < tree->count; i++)
        include_box(&all, &boxes[i]);
    for (int32_t i = 0; i < tree->count; i++)
        places[i] = (struct place_on_curve){place_of(&boxes[i], &all), i};
    const struct place_on_curve *sorted = sort_places(places, places + tree->count, tree->count);
    for (int32_t i = 0; i < tree->count; i++) {
        tree->items[i] = sorted[i].item;
        tree->boxes[i] = boxes[sorted[i].item];
    }
}

int box_tree_build(struct box_tree *tree, const struct bounds *boxes, int32_t count,
                   struct error *err)
{
    *tree = (struct box_tree){.count = count, .leaf_count = 1};
    while ((int64_t)tree->leaf_count * LEAF_ITEMS < count)
        tree->leaf_count *= 2;
    size_t room = (size_t)count + 1;
    struct place_on_curve *places = calloc(2 * room, sizeof *places);
    tree->boxes = malloc(room * sizeof *tree->boxes);
    tree->items = malloc(room * sizeof *tree->items);
    tree->nodes = malloc(2 * (size_t)tree->leaf_count * sizeof *tree->nodes);
    bool ok = places && tree->boxes && tree->items && tree->nodes;
    if (ok) {
        sort_items(tree, boxes, places);
        fill_nodes(tree);
    }
    free(places);
    if (ok)
        return 0;
    box_tree_release(tree);
    return error_set(err, "out of memory: a tree of %d boxes", count);
}

void box_tree_release(struct box_tree *tree)
{
    free(tree->boxes);
    free(tree->items);
    free(tree->nodes);
    *tree = (struct box_tree){0};
}

/* -- searching -------------------------------------------------------------------------------- */

/* A walk over the leaves from `first` on that meet a box: call next_leaf until it returns -1. */
struct leaf_walk {
    const struct box_tree *tree;
    const struct bounds *box;
    int32_t first;
    int32_t stack[DEPTH_LIMIT]; /* nodes to look at, the next one last */
    int depth;
};

static void start_walk(struct leaf_walk *walk, const struct box_tree *tree,
                       const struct bounds *box, int32_t first)
{
    walk->tree = tree;
    walk->box = box;
    walk->first = first;
    walk->stack[0] = 0;
    walk->depth = 1;
}

/* The last leaf below a node: its row has as many nodes as the highest bit of node + 1 says. */
static int32_t last_leaf(const struct box_tree *tree, int32_t node)
{
    uint32_t place = (uint32_t)node + 1;
    int below = __builtin_clz(place) - __builtin_clz((uint32_t)tree->leaf_count);
    return (int32_t)(((place + 1) << below) - 1 - (uint32_t)tree->leaf_count);
}

static int32_t next_leaf(struct leaf_walk *walk)
{
    const struct box_tree *tree = walk->tree;
    while (walk->depth > 0) {
        int32_t node = walk->stack[--walk->depth];
        if (!boxes_meet(&tree->nodes[node], walk->box) || last_leaf(tree, node) < walk->first)
            continue;
        if (node >= tree->leaf_count - 1)
            return node - (tree->leaf_count - 1);
        walk->stack[walk->depth++] = 2 * node + 2;
        walk->stack[walk->depth++] = 2 * node + 1;
    }
    return -1;
}

void box_tree_find(const struct box_tree *tree, const struct bounds *box,
                   bool (*visit)(void *context, int32_t item), void *context)
{
    struct leaf_walk walk;
    start_walk(&walk, tree, box, 0);
    for (int32_t leaf; (leaf = next_leaf(&walk)) >= 0;)
        for (int32_t i = leaf_begin(tree, leaf); i < leaf_begin(tree, leaf + 1); i++)
            if (boxes_meet(&tree->boxes[i], box) && !visit(context, tree->items[i]))
                return;
}

/* What find_pairs looks for. */
struct pair_search {
    const struct box_tree *tree;
    bool (*visit)(void *context, int32_t one, int32_t other);
    void *context;
};

/* The pairs of item i with the items k ... end - 1. Returns false when the search ends. */
static bool find_pairs_of(const struct pair_search *search, int32_t i, int32_t k, int32_t end)
{
    const struct box_tree *tree = search->tree;
    for (; k < end; k++)
        if (boxes_meet(&tree->boxes[i], &tree->boxes[k]) && !search->visit(search->context, i, k))
            return false;
    return true;
}

static bool find_pairs_of_leaf(const struct pair_search *search, int32_t own)
{
    const struct box_tree *tree = search->tree;
    struct leaf_walk walk;
    start_walk(&walk, tree, &tree->nodes[tree->leaf_count - 1 + own], own);
    for (int32_t leaf; (leaf = next_leaf(&walk)) >= 0;)
        for (int32_t i = leaf_begin(tree, own); i < leaf_begin(tree, own + 1); i++)
            if (!find_pairs_of(search, i, leaf == own ? i + 1 : leaf_begin(tree, leaf),
                               leaf_begin(tree, leaf + 1)))
                return false;
    return true;
}

void box_tree_find_pairs(const struct box_tree *tree,
                         bool (*visit)(void *context, int32_t one, int32_t other), void *context)
{
    const struct pair_search search = {tree, visit, context};
    for (int32_t leaf = 0; leaf < tree->leaf_count; leaf++)
        if (!find_pairs_of_leaf(&search, leaf))
            return;
}
