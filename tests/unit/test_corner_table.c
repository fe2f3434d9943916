/* The corner table and directed edges: the smallest tables by hand, and damage found. */
#include "reference/mesh/generate.h"
#include "reference/representation/corner_table.h"
#include "reference/representation/directed_edges.h"
#include "tests/unit/damage.h"
#include "tests/unit/mesh_measures.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

/* Two triangles 0 1 2 and 2 1 3: their common side is 1 -> 2, corner 1, and 2 -> 1, corner 3. */
static float positions[12];
static int32_t triangles[6] = {0, 1, 2, 2, 1, 3};
static const struct mesh two_triangles = {positions, triangles, 4, 2};

static void corners_face_their_opposites(void **state)
{
    (void)state;
    struct corner_table table;
    assert_int_equal(corner_table_build(&table, &two_triangles, NULL), 0);
    const int32_t opposite[6] = {5, -1, -1, -1, -1, 0};
    const int32_t at[4] = {0, 4, 2, 5}; /* where the fan of each vertex starts */
    assert_memory_equal(table.opposite, opposite, sizeof opposite);
    assert_memory_equal(table.vertex, triangles, sizeof triangles);
    assert_memory_equal(table.vertex_corner, at, sizeof at);
    assert_int_equal(corner_table_swing(&table, 4), 1); /* around vertex 1 */
    assert_int_equal(corner_table_swing(&table, 1), -1);
    assert_int_equal(corner_table_across(&table, 1), 1);
    assert_int_equal(corner_table_across(&table, 0), -1);
    corner_table_release(&table);
}

static void edges_without_neighbour_lead_along_the_hole(void **state)
{
    (void)state;
    struct directed_edge_mesh de;
    assert_int_equal(directed_edges_build(&de, &two_triangles, NULL), 0);
    const struct directed_edge want[6] = {{0, ~4}, {1, 3}, {2, ~0}, {2, 1}, {1, ~5}, {3, ~2}};
    assert_memory_equal(de.edges, want, sizeof want);
    assert_int_equal(directed_edge_turn_left(&de, 4), 1);
    assert_true(directed_edge_turn_left(&de, 1) < 0);
    directed_edges_release(&de);
}

/* -- damage --------------------------------------------------------------------------------- */

static int check_corners(const void *self, struct error *err)
{
    return corner_table_check(self, err);
}

static uint64_t shape_of_corners(const void *self)
{
    struct mesh mesh;
    assert_int_equal(corner_table_to_mesh(self, &mesh, NULL), 0);
    uint64_t hash = surface_hash(&mesh);
    mesh_release(&mesh);
    return hash;
}

static void damage_to_corners_is_found(void **state)
{
    (void)state;
    for (int i = 0; i < DAMAGE_MESHES; i++) {
        struct mesh mesh = damage_mesh(i);
        struct corner_table table;
        assert_int_equal(corner_table_build(&table, &mesh, NULL), 0);
        const struct damage damage = {&table, check_corners, shape_of_corners};
        int64_t corner_count = 3 * (int64_t)table.triangle_count;
        damage_every_number(&damage, "vertex", table.vertex, corner_count, NO_CHOICE);
        damage_every_number(&damage, "opposite", table.opposite, corner_count, NO_CHOICE);
        damage_every_number(&damage, "vertex_corner", table.vertex_corner, table.vertex_count,
                            SOME_CHOICE);
        corner_table_release(&table);
        mesh_release(&mesh);
    }
}

static int check_directed(const void *self, struct error *err)
{
    return directed_edges_check(self, err);
}

static uint64_t shape_of_directed(const void *self)
{
    struct mesh mesh;
    assert_int_equal(directed_edges_to_mesh(self, &mesh, NULL), 0);
    uint64_t hash = surface_hash(&mesh);
    mesh_release(&mesh);
    return hash;
}

static void damage_to_directed_edges_is_found(void **state)
{
    (void)state;
    for (int i = 0; i < DAMAGE_MESHES; i++) {
        struct mesh mesh = damage_mesh(i);
        struct directed_edge_mesh de;
        assert_int_equal(directed_edges_build(&de, &mesh, NULL), 0);
        const struct damage damage = {&de, check_directed, shape_of_directed};
        damage_every_number(&damage, "edges", &de.edges->vertex, 6 * (int64_t)de.triangle_count,
                            NO_CHOICE);
        damage_every_number(&damage, "vertex_edge", de.vertex_edge, de.vertex_count, SOME_CHOICE);
        directed_edges_release(&de);
        mesh_release(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(corners_face_their_opposites),
        cmocka_unit_test(edges_without_neighbour_lead_along_the_hole),
        cmocka_unit_test(damage_to_corners_is_found),
        cmocka_unit_test(damage_to_directed_edges_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
