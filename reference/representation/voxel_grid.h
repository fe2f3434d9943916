/* Voxel grid (enumeración espacial) of problem 4.1: the cube around a solid cut into k x k x k
 * cells, one bit a cell: 1 where the cell's centre is in the solid.
 *
 *      k = 8, the layer just above the middle of the sphere       bits of the first row: 0 ... 7,
 *                                                                 eight to a byte, lowest first
 *      . . # # # # . .
 *      . # # # # # # .         cell (x, y, z) is bit  x + k (y + k z)
 *      # # # # # # # #
 *      # # # # # # # #
 *      # # # # # # # #
 *      # # # # # # # #
 *      . # # # # # # .
 *      . . # # # # . .
 *
 * It knows all of the inside and nothing of the surface: whether a point is in the solid takes one
 * access, the volume k^3 / 64 of them (64 bits at a time), and there are no normals; a mesh knows
 * the surface and nothing of the inside. It is no mesh, so it is not in representation_table.
 *
 * Invariants: bits behind the last cell are 0.
 *
 * Bytes: ceil(k^3 / 8): 512 for k = 16, 128 MB for k = 1024. It grows by the cube of k where meshes
 * and octrees (octree.h) of the same sphere grow by the square: a mesh of k meridians with k
 * vertices each, about 36 k^2 bytes, is the smaller one from k = 288 on. */
#ifndef REFERENCE_REPRESENTATION_VOXEL_GRID_H
#define REFERENCE_REPRESENTATION_VOXEL_GRID_H

#include "reference/base/error.h"

#include <stdbool.h>
#include <stdint.h>

enum { VOXEL_GRID_MOST = 4096 }; /* cells a side: 8 GiB */

struct voxel_grid {
    uint8_t *bits;
    int32_t k; /* cells along each side */
};

/* Makes an empty grid of k (1 ... VOXEL_GRID_MOST) cells a side; the caller owns it
 * (voxel_grid_release). Returns 0, or -1 and *err. */
int voxel_grid_init(struct voxel_grid *grid, int32_t k, struct error *err) MUST_CHECK;
void voxel_grid_release(struct voxel_grid *grid); /* a zeroed one may be released */

/* The sphere that touches the sides of the cube. The test is exact: in units of half a cell,
 * centres have odd whole coordinates and the radius is k. Cost: one square root a row, then its
 * bytes. Returns 0, or -1 and *err. */
int voxel_grid_sphere(struct voxel_grid *grid, int32_t k, struct error *err) MUST_CHECK;

/* Checks the invariant. Returns 0, or -1 and *err naming the bit. */
int voxel_grid_check(const struct voxel_grid *grid, struct error *err) MUST_CHECK;

int64_t voxel_grid_bytes(int32_t k);

/* Whether the cell is full; 0 <= x, y, z < k. */
static inline bool voxel_grid_at(const struct voxel_grid *grid, int32_t x, int32_t y, int32_t z)
{
    int64_t bit = x + (int64_t)grid->k * (y + (int64_t)grid->k * z);
    return grid->bits[bit / 8] >> bit % 8 & 1;
}

void voxel_grid_set(struct voxel_grid *grid, int32_t x, int32_t y, int32_t z, bool is_full);

/* Full cells: the volume is this times (1 / k)^3 of the cube. */
int64_t voxel_grid_count(const struct voxel_grid *grid);

#endif
