/* Octrees; see octree.h. */
#include "reference/representation/octree.h"

#include <stdlib.h>
#include <string.h>

/* -- making ----------------------------------------------------------------------------------- */

/* What a cube of `size` cells from (x, y, z) on is: OCTREE_EMPTY, OCTREE_FULL, or DIVIDE when that
 * is not known before its parts are. Of single cells it is always known. */
enum { DIVIDE = 0 };
typedef int32_t classify(const void *solid, int32_t x, int32_t y, int32_t z, int32_t size);

struct maker {
    struct octree *tree;
    classify *solid_class;
    const void *solid;
    struct error *err;
};

/* Appends a block of eight children; its place, or -1 and *err. */
static int32_t add_block(struct maker *maker, const int32_t children[8])
{
    struct octree *tree = maker->tree;
    if (tree->divided_count == tree->capacity) {
        int64_t capacity = tree->capacity ? 2 * tree->capacity : 64;
        int32_t *nodes = capacity <= INT32_MAX / 8
                             ? realloc(tree->nodes, 8 * (size_t)capacity * sizeof *nodes)
                             : NULL;
        if (!nodes)
            return error_set(maker->err, "out of memory: an octree of %lld divided nodes",
                             (long long)capacity);
        tree->nodes = nodes;
        tree->capacity = capacity;
    }
    int32_t place = 8 * tree->divided_count++;
    memcpy(tree->nodes + place, children, 8 * sizeof *children);
    return place;
}

/* Makes the node of a cube, children first. Returns 0, or -1 and *err. */
static int make_node(struct maker *maker, int32_t x, int32_t y, int32_t z, int32_t size,
                     int32_t *node)
{
    *node = maker->solid_class(maker->solid, x, y, z, size);
    if (*node != DIVIDE)
        return 0;
    int32_t half = size / 2, children[8];
    bool is_uniform = true;
    for (int i = 0; i < 8; i++) {
        if (make_node(maker, x + (i & 1) * half, y + (i >> 1 & 1) * half, z + (i >> 2) * half, half,
                      &children[i]))
            return -1;
        is_uniform = is_uniform && children[i] < 0 && children[i] == children[0];
    }
    if (is_uniform) {
        *node = children[0];
        return 0;
    }
    *node = add_block(maker, children);
    return *node < 0 ? -1 : 0;
}

static int make_tree(struct octree *tree, int levels, classify *solid_class, const void *solid,
                     struct error *err)
{
    *tree = (struct octree){.levels = levels};
    struct maker maker = {tree, solid_class, solid, err};
    if (make_node(&maker, 0, 0, 0, INT32_C(1) << levels, &tree->root) == 0)
        return 0;
    octree_release(tree);
    return -1;
}

void octree_release(struct octree *tree)
{
    free(tree->nodes);
    *tree = (struct octree){.root = OCTREE_EMPTY};
}

/* -- the sphere ------------------------------------------------------------------------------- */

/* Squares of the least and the greatest distance from the middle to centres of cells c ... c + size
 * - 1 along one axis, in half cells; k is even here but for a single cell. */
static void axis_distances(int64_t k, int64_t c, int64_t size, int64_t *least, int64_t *greatest)
{
    int64_t low = 2 * c + 1 - k, high = 2 * (c + size - 1) + 1 - k;
    int64_t a = low < 0 ? -low : low, b = high < 0 ? -high : high;
    bool spans = low < 0 && high > 0;
    *greatest = a > b ? a * a : b * b;
    *least = spans ? 1 : a < b ? a * a : b * b;
}

static int32_t classify_sphere(const void *solid, int32_t x, int32_t y, int32_t z, int32_t size)
{
    int64_t k = *(const int32_t *)solid, at[3] = {x, y, z}, least = 0, greatest = 0;
    for (int axis = 0; axis < 3; axis++) {
        int64_t near, far;
        axis_distances(k, at[axis], size, &near, &far);
        least += near;
        greatest += far;
    }
    if (greatest <= k * k)
        return OCTREE_FULL;
    return least > k * k ? OCTREE_EMPTY : DIVIDE;
}

int octree_sphere(struct octree *tree, int levels, struct error *err)
{
    *tree = (struct octree){.root = OCTREE_EMPTY};
    if (levels < 0 || levels > OCTREE_MOST_LEVELS)
        return error_set(err, "an octree of %d levels: 0 to %d are possible", levels,
                         OCTREE_MOST_LEVELS);
    int32_t k = INT32_C(1) << levels;
    return make_tree(tree, levels, classify_sphere, &k, err);
}

/* -- grids ------------------------------------------------------------------------------------ */

static int32_t classify_grid(const void *solid, int32_t x, int32_t y, int32_t z, int32_t size)
{
    if (size > 1)
        return DIVIDE;
    return voxel_grid_at(solid, x, y, z) ? OCTREE_FULL : OCTREE_EMPTY;
}

int octree_from_grid(struct octree *tree, const struct voxel_grid *grid, struct error *err)
{
    *tree = (struct octree){.root = OCTREE_EMPTY};
    int levels = 0;
    while (INT32_C(1) << levels < grid->k)
        levels++;
    if (INT32_C(1) << levels != grid->k)
        return error_set(err, "a grid of %d cells a side: an octree needs a power of two", grid->k);
    return make_tree(tree, levels, classify_grid, grid, err);
}

static void fill_cube(const struct octree *tree, int32_t node, int32_t x, int32_t y, int32_t z,
                      int32_t size, struct voxel_grid *grid)
{
    if (node == OCTREE_EMPTY)
        return;
    if (node >= 0) {
        int32_t half = size / 2;
        for (int i = 0; i < 8; i++)
            fill_cube(tree, tree->nodes[node + i], x + (i & 1) * half, y + (i >> 1 & 1) * half,
                      z + (i >> 2) * half, half, grid);
        return;
    }
    for (int32_t c = z; c < z + size; c++)
        for (int32_t b = y; b < y + size; b++)
            for (int32_t a = x; a < x + size; a++)
                voxel_grid_set(grid, a, b, c, true);
}

int octree_to_grid(const struct octree *tree, struct voxel_grid *grid, struct error *err)
{
    if (voxel_grid_init(grid, INT32_C(1) << tree->levels, err))
        return -1;
    fill_cube(tree, tree->root, 0, 0, 0, grid->k, grid);
    return 0;
}

/* -- asking ----------------------------------------------------------------------------------- */

int64_t octree_bytes(const struct octree *tree)
{
    return 4 + 32 * (int64_t)tree->divided_count;
}

bool octree_at(const struct octree *tree, int32_t x, int32_t y, int32_t z)
{
    int32_t node = tree->root;
    for (int level = tree->levels - 1; node >= 0; level--)
        node = tree->nodes[node + (x >> level & 1) + 2 * (y >> level & 1) + 4 * (z >> level & 1)];
    return node == OCTREE_FULL;
}

static int64_t count_cells(const struct octree *tree, int32_t node, int level)
{
    if (node < 0)
        return node == OCTREE_FULL ? INT64_C(1) << 3 * level : 0;
    int64_t count = 0;
    for (int i = 0; i < 8; i++)
        count += count_cells(tree, tree->nodes[node + i], level - 1);
    return count;
}

int64_t octree_count(const struct octree *tree)
{
    return count_cells(tree, tree->root, tree->levels);
}

/* -- checking --------------------------------------------------------------------------------- */

static int check_node(const struct octree *tree, int32_t node, int64_t before, int level,
                      uint8_t *has_parent, struct error *err)
{
    if (node == OCTREE_EMPTY || node == OCTREE_FULL)
        return 0;
    if (node < 0 || node % 8 || node >= before)
        return error_set(err, "node %d: its parent stands at %lld, blocks stand at multiples of 8",
                         node, (long long)before);
    if (level == 0)
        return error_set(err, "node %d is divided, and is a single cell", node);
    if (has_parent[node / 8])
        return error_set(err, "node %d has two parents", node);
    has_parent[node / 8] = 1;
    const int32_t *child = tree->nodes + node;
    bool is_uniform = child[0] < 0;
    for (int i = 0; i < 8; i++) {
        is_uniform = is_uniform && child[i] == child[0];
        if (check_node(tree, child[i], node, level - 1, has_parent, err))
            return -1;
    }
    return is_uniform ? error_set(err, "node %d is divided into eight equal leaves", node) : 0;
}

int octree_check(const struct octree *tree, struct error *err)
{
    if (tree->levels < 0 || tree->levels > OCTREE_MOST_LEVELS || tree->divided_count < 0)
        return error_set(err, "an octree of %d levels and %d divided nodes", tree->levels,
                         tree->divided_count);
    uint8_t *has_parent = calloc((size_t)tree->divided_count + 1, 1);
    if (!has_parent)
        return error_set(err, "out of memory: checking %d nodes", tree->divided_count);
    int result = check_node(tree, tree->root, 8 * (int64_t)tree->divided_count, tree->levels,
                            has_parent, err);
    for (int32_t b = 0; b < tree->divided_count && result == 0; b++)
        if (!has_parent[b])
            result = error_set(err, "node %d has no parent", 8 * b);
    free(has_parent);
    return result;
}
