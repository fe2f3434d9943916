/* Voxel grids; see voxel_grid.h. */
#include "reference/representation/voxel_grid.h"

#include <math.h>
#include <stdlib.h>

int64_t voxel_grid_bytes(int32_t k)
{
    return ((int64_t)k * k * k + 7) / 8;
}

int voxel_grid_init(struct voxel_grid *grid, int32_t k, struct error *err)
{
    *grid = (struct voxel_grid){0};
    if (k < 1 || k > VOXEL_GRID_MOST)
        return error_set(err, "a grid of %d cells a side: 1 to %d are possible", k,
                         VOXEL_GRID_MOST);
    grid->bits = calloc((size_t)voxel_grid_bytes(k), 1);
    if (!grid->bits)
        return error_set(err, "out of memory: a grid of %d cells a side", k);
    grid->k = k;
    return 0;
}

void voxel_grid_release(struct voxel_grid *grid)
{
    free(grid->bits);
    *grid = (struct voxel_grid){0};
}

/* Sets bits first ... end - 1: single ones up to a byte's border, then bytes. */
static void set_bits(uint8_t *bits, int64_t first, int64_t end)
{
    while (first < end && first % 8)
        bits[first / 8] |= (uint8_t)(1 << first % 8), first++;
    for (; first + 8 <= end; first += 8)
        bits[first / 8] = 0xff;
    for (; first < end; first++)
        bits[first / 8] |= (uint8_t)(1 << first % 8);
}

/* How many cells of a row are in the sphere: those with x^2 <= left, x odd (k even) or even (k
 * odd), |x| < k; they lie in the middle. */
static int64_t cells_within(int64_t k, int64_t left)
{
    if (left < 0)
        return 0;
    int64_t x = (int64_t)sqrt((double)left);
    while (x * x > left)
        x--;
    while ((x + 1) * (x + 1) <= left)
        x++;
    if ((x - (k - 1)) % 2) /* centres are at k - 1, k - 3, ... */
        x--;
    return x < 0 ? 0 : x < k ? x + 1 : k;
}

int voxel_grid_sphere(struct voxel_grid *grid, int32_t k, struct error *err)
{
    if (voxel_grid_init(grid, k, err))
        return -1;
    int64_t row = 0, side = k;
    for (int64_t z = 1 - side; z < side; z += 2)
        for (int64_t y = 1 - side; y < side; y += 2, row += side) {
            int64_t count = cells_within(side, side * side - y * y - z * z);
            int64_t first = row + (side - count) / 2;
            set_bits(grid->bits, first, first + count);
        }
    return 0;
}

int voxel_grid_check(const struct voxel_grid *grid, struct error *err)
{
    int64_t cells = (int64_t)grid->k * grid->k * grid->k;
    for (int64_t bit = cells; bit < 8 * voxel_grid_bytes(grid->k); bit++)
        if (grid->bits[bit / 8] >> bit % 8 & 1)
            return error_set(err, "bit %lld is set behind the %lld cells", (long long)bit,
                             (long long)cells);
    return 0;
}

void voxel_grid_set(struct voxel_grid *grid, int32_t x, int32_t y, int32_t z, bool is_full)
{
    int64_t bit = x + (int64_t)grid->k * (y + (int64_t)grid->k * z);
    uint8_t mask = (uint8_t)(1 << bit % 8);
    if (is_full)
        grid->bits[bit / 8] |= mask;
    else
        grid->bits[bit / 8] &= (uint8_t)~mask;
}

int64_t voxel_grid_count(const struct voxel_grid *grid)
{
    int64_t count = 0;
    for (int64_t i = 0; i < voxel_grid_bytes(grid->k); i++)
        count += __builtin_popcount(grid->bits[i]);
    return count;
}
