/* Octree: a voxel grid of k = 2^levels cells a side in which cubes that are all full or all empty
 * are one leaf. Only cubes that the surface passes are divided, so memory follows the surface.
 *
 *      one layer of k = 8:       the tree, four of the eight children shown:
 *
 *      +---+---+-------+         root --+-- divided --+-- empty
 *      | . |.:#|       |                |             +-- divided: . # # #
 *      +---+---+  ...  |                |             +-- divided: . # # #
 *      |.:#| # |       |                |             +-- full
 *      +---+---+-------+                +-- ...
 *      |  ...  |  ...  |
 *      +-------+-------+
 *
 * A node is one int32: OCTREE_EMPTY, OCTREE_FULL, or the place of the first of its eight children,
 * which stand together; child number x + 2 y + 4 z. Children are stored before their parent; the
 * root is apart. (Document 004: an octree compacts the volume and supports queries.)
 *
 * Invariants: a divided node's children stand before it, and are not all full or all empty; each
 * block of eight has one parent; no node lies deeper than `levels`.
 *
 *     query                   accesses
 *     is a point inside       up to lg k
 *     volume                  one a node
 *
 * Bytes: 4 + 32 a divided node. For the sphere of problem 4.1 about 0.9 k^2 nodes are divided,
 * those at its surface: some 29 k^2 bytes (its test measures it), less than the voxels' k^3 / 8
 * from k = 256 on, and less than the 36 k^2 of the mesh with k meridians and k parallels. */
#ifndef REFERENCE_REPRESENTATION_OCTREE_H
#define REFERENCE_REPRESENTATION_OCTREE_H

#include "reference/representation/voxel_grid.h"

enum { OCTREE_EMPTY = -1, OCTREE_FULL = -2, OCTREE_MOST_LEVELS = 12 };

struct octree {
    int32_t *nodes; /* 8 * divided_count children; NULL when nothing is divided */
    int32_t root;   /* as a node */
    int32_t divided_count;
    int32_t levels;   /* k = 2^levels */
    int64_t capacity; /* blocks that `nodes` has room for */
};

/* The tree of the sphere that touches the sides of the cube, of levels 0 ... OCTREE_MOST_LEVELS,
 * equal cell by cell to voxel_grid_sphere(2^levels). Cost follows the tree, not the cells. The
 * caller owns it (octree_release). Returns 0, or -1 and *err. */
int octree_sphere(struct octree *tree, int levels, struct error *err) MUST_CHECK;

/* The tree of any grid whose k is a power of two. Linear in cells. Returns 0, or -1 and *err. */
int octree_from_grid(struct octree *tree, const struct voxel_grid *grid,
                     struct error *err) MUST_CHECK;

/* The grid of a tree; the caller owns it. Returns 0, or -1 and *err. */
int octree_to_grid(const struct octree *tree, struct voxel_grid *grid,
                   struct error *err) MUST_CHECK;

void octree_release(struct octree *tree); /* a zeroed one may be released */

/* Checks the invariants. Returns 0, or -1 and *err naming the node. */
int octree_check(const struct octree *tree, struct error *err) MUST_CHECK;

int64_t octree_bytes(const struct octree *tree); /* without room to grow */

/* Whether the cell is full; 0 <= x, y, z < 2^levels. */
bool octree_at(const struct octree *tree, int32_t x, int32_t y, int32_t z);

/* Full cells, added up over full leaves. */
int64_t octree_count(const struct octree *tree);

#endif
