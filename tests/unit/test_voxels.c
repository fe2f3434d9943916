/* Voxel grids and octrees of the sphere. */
#include "reference/base/random.h"
#include "reference/representation/octree.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* The membership test of problem 4.1 with all numbers times 2 k: exact. */
static bool is_inside(int64_t k, int64_t x, int64_t y, int64_t z)
{
    int64_t a = 2 * x + 1 - k, b = 2 * y + 1 - k, c = 2 * z + 1 - k;
    return a * a + b * b + c * c <= k * k;
}

static void cells_are_full_where_their_centres_are_inside(void **state)
{
    (void)state;
    for (int32_t k = 1; k <= 40; k++) {
        struct voxel_grid grid;
        int64_t count = 0;
        assert_int_equal(voxel_grid_sphere(&grid, k, NULL), 0);
        assert_int_equal(voxel_grid_check(&grid, NULL), 0);
        for (int32_t z = 0; z < k; z++)
            for (int32_t y = 0; y < k; y++)
                for (int32_t x = 0; x < k; x++) {
                    count += is_inside(k, x, y, z);
                    assert_int_equal(voxel_grid_at(&grid, x, y, z), is_inside(k, x, y, z));
                }
        assert_int_equal(voxel_grid_count(&grid), count);
        voxel_grid_release(&grid);
    }
}

static void the_volume_comes_near(void **state)
{
    (void)state;
    struct voxel_grid grid;
    assert_int_equal(voxel_grid_sphere(&grid, 201, NULL), 0);
    double volume = (double)voxel_grid_count(&grid) / (201.0 * 201.0 * 201.0);
    assert_true(fabs(volume - 3.14159265358979 / 6) < 1e-4);
    voxel_grid_release(&grid);
}

static void bytes_are_those_of_the_course(void **state)
{
    (void)state;
    assert_int_equal(voxel_grid_bytes(16), 512);
    assert_int_equal(voxel_grid_bytes(1024), 128 * 1024 * 1024);
    assert_int_equal(voxel_grid_bytes(3), 4);
    /* Against a mesh of 36 k^2 bytes, k = 288 is where they cross. */
    assert_true(voxel_grid_bytes(287) < 36 * 287 * 287);
    assert_true(voxel_grid_bytes(288) == 36 * 288 * 288);
}

static void cells_can_be_set(void **state)
{
    (void)state;
    struct voxel_grid grid;
    struct error err = {0};
    assert_int_equal(voxel_grid_init(&grid, 5, NULL), 0);
    voxel_grid_set(&grid, 4, 3, 2, true);
    voxel_grid_set(&grid, 0, 0, 0, true);
    voxel_grid_set(&grid, 0, 0, 0, false);
    assert_true(voxel_grid_at(&grid, 4, 3, 2));
    assert_int_equal(voxel_grid_count(&grid), 1);
    grid.bits[15] |= 0x80;
    assert_int_equal(voxel_grid_check(&grid, &err), -1);
    assert_string_equal(err.text, "bit 127 is set behind the 125 cells");
    voxel_grid_release(&grid);
    assert_int_equal(voxel_grid_init(&grid, 0, NULL), -1);
    assert_int_equal(voxel_grid_init(&grid, VOXEL_GRID_MOST + 1, NULL), -1);
    assert_null(grid.bits);
}

/* -- octrees ---------------------------------------------------------------------------------- */

static bool same_grid(const struct voxel_grid *a, const struct voxel_grid *b)
{
    return a->k == b->k && memcmp(a->bits, b->bits, (size_t)voxel_grid_bytes(a->k)) == 0;
}

static void octrees_hold_the_same_sphere(void **state)
{
    (void)state;
    for (int levels = 0; levels <= 6; levels++) {
        struct voxel_grid grid, back;
        struct octree direct, made;
        assert_int_equal(voxel_grid_sphere(&grid, 1 << levels, NULL), 0);
        assert_int_equal(octree_sphere(&direct, levels, NULL), 0);
        assert_int_equal(octree_from_grid(&made, &grid, NULL), 0);
        assert_int_equal(octree_check(&direct, NULL), 0);
        assert_int_equal(octree_check(&made, NULL), 0);
        assert_int_equal(made.divided_count, direct.divided_count);
        assert_int_equal(octree_bytes(&made), octree_bytes(&direct));
        assert_int_equal(octree_count(&direct), voxel_grid_count(&grid));
        assert_int_equal(octree_to_grid(&direct, &back, NULL), 0);
        assert_true(same_grid(&grid, &back));
        voxel_grid_release(&back);
        assert_int_equal(octree_to_grid(&made, &back, NULL), 0);
        assert_true(same_grid(&grid, &back));
        voxel_grid_release(&back);
        voxel_grid_release(&grid);
        octree_release(&direct);
        octree_release(&made);
    }
}

static void octrees_hold_any_grid(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 9);
    for (int round = 0; round < 60; round++) {
        struct voxel_grid grid;
        struct octree tree;
        int levels = round % 5;
        int32_t k = 1 << levels;
        assert_int_equal(voxel_grid_init(&grid, k, NULL), 0);
        for (uint64_t i = random_below(&rng, 2 + (uint64_t)(k * k * k)); i > 0; i--)
            voxel_grid_set(&grid, (int32_t)random_below(&rng, (uint64_t)k),
                           (int32_t)random_below(&rng, (uint64_t)k),
                           (int32_t)random_below(&rng, (uint64_t)k), true);
        assert_int_equal(octree_from_grid(&tree, &grid, NULL), 0);
        assert_int_equal(octree_check(&tree, NULL), 0);
        assert_int_equal(octree_count(&tree), voxel_grid_count(&grid));
        for (int32_t z = 0; z < k; z++)
            for (int32_t y = 0; y < k; y++)
                for (int32_t x = 0; x < k; x++)
                    assert_int_equal(octree_at(&tree, x, y, z), voxel_grid_at(&grid, x, y, z));
        octree_release(&tree);
        voxel_grid_release(&grid);
    }
}

/* Memory follows the surface: doubling k takes about four times the bytes, not eight. */
static void octrees_grow_by_the_square(void **state)
{
    (void)state;
    double previous = 0.0;
    for (int levels = 5; levels <= 8; levels++) {
        struct octree tree;
        assert_int_equal(octree_sphere(&tree, levels, NULL), 0);
        double bytes = (double)octree_bytes(&tree), square = (double)(1 << 2 * levels);
        assert_true(bytes / square > 27 && bytes / square < 29.5);
        assert_true(bytes < 36 * square); /* the mesh of problem 4.1 */
        assert_int_equal(octree_bytes(&tree) < voxel_grid_bytes(1 << levels), levels >= 8);
        assert_true(previous == 0.0 || (bytes / previous > 3.8 && bytes / previous < 4.4));
        previous = bytes;
        octree_release(&tree);
    }
}

static void damaged_octrees_are_found(void **state)
{
    (void)state;
    struct octree tree;
    assert_int_equal(octree_sphere(&tree, 3, NULL), 0);
    int32_t *entries[9] = {&tree.root};
    for (int i = 1; i < 9; i++)
        entries[i] = &tree.nodes[(i * 37) % (8 * tree.divided_count)];
    for (int i = 0; i < 9; i++) {
        int32_t right = *entries[i];
        const int32_t wrong[] = {INT32_MIN, -3, 8 * tree.divided_count, INT32_MAX, 3};
        for (size_t w = 0; w < sizeof wrong / sizeof *wrong; w++) {
            struct error err = {0};
            *entries[i] = wrong[w];
            assert_int_equal(octree_check(&tree, &err), -1);
            assert_non_null(strstr(err.text, "node "));
        }
        *entries[i] = right;
    }
    struct error err = {0};
    for (int i = 1; i < 8; i++)
        assert_true(tree.nodes[i] < 0); /* the first block's children are cells */
    for (int i = 0; i < 8; i++)
        tree.nodes[i] = OCTREE_FULL;
    assert_int_equal(octree_check(&tree, &err), -1);
    assert_string_equal(err.text, "node 0 is divided into eight equal leaves");
    octree_release(&tree);
    octree_release(&tree);
}

static void impossible_octrees_are_refused(void **state)
{
    (void)state;
    struct octree tree;
    struct voxel_grid grid;
    struct error err = {0};
    assert_int_equal(octree_sphere(&tree, -1, NULL), -1);
    assert_int_equal(octree_sphere(&tree, OCTREE_MOST_LEVELS + 1, NULL), -1);
    assert_int_equal(voxel_grid_init(&grid, 6, NULL), 0);
    assert_int_equal(octree_from_grid(&tree, &grid, &err), -1);
    assert_string_equal(err.text, "a grid of 6 cells a side: an octree needs a power of two");
    voxel_grid_release(&grid);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cells_are_full_where_their_centres_are_inside),
        cmocka_unit_test(the_volume_comes_near),
        cmocka_unit_test(bytes_are_those_of_the_course),
        cmocka_unit_test(cells_can_be_set),
        cmocka_unit_test(octrees_hold_the_same_sphere),
        cmocka_unit_test(octrees_hold_any_grid),
        cmocka_unit_test(octrees_grow_by_the_square),
        cmocka_unit_test(damaged_octrees_are_found),
        cmocka_unit_test(impossible_octrees_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
