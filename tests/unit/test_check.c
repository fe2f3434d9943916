/* Topology checks: facts of small meshes by hand, and a quadratic count over random ones. */
#include "reference/mesh/check.h"
#include "reference/mesh/generate.h"
#include "tests/unit/mesh_measures.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void the_edges_of_two_triangles(void **state)
{
    (void)state;
    float positions[12] = {0};
    int32_t triangles[6] = {0, 1, 2, 3, 2, 1};
    struct mesh mesh = {positions, triangles, 4, 2};
    struct edge_list list;
    assert_int_equal(edge_list_init(&list, &mesh, NULL), 0);
    const int32_t expected[5][2] = {{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}};
    assert_int_equal(list.edge_count, 5);
    for (int e = 0; e < 5; e++) {
        assert_int_equal(list.edges[e].low, expected[e][0]);
        assert_int_equal(list.edges[e].high, expected[e][1]);
        assert_int_equal(edge_use_count(&list.edges[e]), e == 2 ? 2 : 1);
    }
    const struct edge *shared = &list.edges[2];
    assert_int_equal(shared->forward_count, 1);
    assert_int_equal(list.uses[shared->first_use], 1);     /* 1 -> 2 of triangle 0 */
    assert_int_equal(list.uses[shared->first_use + 1], 4); /* 2 -> 1 of triangle 1 */
    struct finding boundary = mesh_boundary_edges(&list);
    assert_int_equal(boundary.count, 4);
    assert_int_equal(boundary.first, 0);
    assert_int_equal(mesh_nonmanifold_edges(&list).first, -1);
    edge_list_release(&list);
    edge_list_release(&list);
}

static void the_first_element_at_fault_is_named(void **state)
{
    (void)state;
    float positions[21] = {0};
    /* 1 runs 0 -> 1 like 0; 2 is 1 again, reversed; 3 is degenerate; 6 is isolated. */
    int32_t triangles[15] = {0, 1, 2, 0, 1, 3, 3, 1, 0, 4, 4, 5, 3, 4, 5};
    struct mesh mesh = {positions, triangles, 7, 5};
    struct topology found;
    assert_int_equal(mesh_topology(&mesh, &found, NULL), 0);
    assert_int_equal(found.degenerate.count, 1);
    assert_int_equal(found.degenerate.first, 3);
    assert_int_equal(found.duplicate.count, 1);
    assert_int_equal(found.duplicate.first, 2);
    assert_int_equal(found.isolated.count, 1);
    assert_int_equal(found.isolated.first, 6);
    assert_int_equal(found.nonmanifold_edge.count, 1); /* 0-1 has three triangles */
    assert_int_equal(found.nonmanifold_edge.first, 0);
    assert_int_equal(found.nonmanifold_vertex.count, 3); /* 0, 1, and 3 with two fans */
    assert_int_equal(found.nonmanifold_vertex.first, 0);
    assert_int_equal(found.component_count, 1);
    triangles[6] = 5, triangles[7] = 6, triangles[8] = 5; /* now degenerate: nothing conflicts */
    assert_int_equal(mesh_topology(&mesh, &found, NULL), 0);
    assert_int_equal(found.degenerate.first, 2);
    assert_int_equal(found.incoherent.count, 1);
    assert_int_equal(found.incoherent.first, 0);
    assert_true(found.is_orientable);
}

static void boundary_loops_are_counted(void **state)
{
    (void)state;
    struct mesh mesh, disc;
    struct topology found;
    assert_int_equal(generate_grid(&mesh, 6, 6, NULL), 0);
    /* One quad out of the middle: two loops, Euler characteristic 0. */
    int64_t hole = 2 * (2 * 6 + 2);
    int64_t after = mesh.triangle_count - hole - 2;
    memmove(mesh.triangles + 3 * hole, mesh.triangles + 3 * hole + 6, 12 * (size_t)after);
    mesh.triangle_count -= 2;
    assert_int_equal(mesh_topology(&mesh, &found, NULL), 0);
    assert_int_equal(found.boundary_loop_count, 2);
    assert_int_equal(found.euler_characteristic, 0);
    assert_int_equal(generate_disc(&disc, 2, 5, NULL), 0);
    assert_int_equal(change_append(&mesh, &disc, 5.0F, 0.0F, 0.0F, NULL), 0);
    assert_int_equal(mesh_topology(&mesh, &found, NULL), 0);
    assert_int_equal(found.boundary_loop_count, 3);
    assert_int_equal(found.component_count, 2);
    mesh_release(&mesh);
    mesh_release(&disc);
}

static bool shares_edge(const int32_t *s, int corner, int32_t low, int32_t high)
{
    int32_t a = s[corner], b = s[(corner + 1) % 3];
    return (a == low && b == high) || (a == high && b == low);
}

/* Uses of each edge, counted anew by looking at every triangle. */
static void random_meshes_have_the_edges_that_their_triangles_have(void **state)
{
    (void)state;
    for (uint64_t seed = 100; seed < 220; seed++) {
        struct mesh mesh = random_mesh(seed);
        struct edge_list list;
        assert_int_equal(edge_list_init(&list, &mesh, NULL), 0);
        int64_t sides = 0;
        for (int64_t e = 0; e < list.edge_count; e++) {
            const struct edge *edge = &list.edges[e];
            assert_true(edge->low < edge->high);
            if (e > 0)
                assert_true(edge[-1].low < edge->low ||
                            (edge[-1].low == edge->low && edge[-1].high < edge->high));
            int64_t uses = 0;
            for (int64_t t = 0; t < mesh.triangle_count; t++)
                if (!triangle_is_degenerate(mesh.triangles + 3 * t))
                    for (int corner = 0; corner < 3; corner++)
                        uses += shares_edge(mesh.triangles + 3 * t, corner, edge->low, edge->high);
            assert_int_equal(edge_use_count(edge), uses);
            sides += uses;
        }
        assert_int_equal(sides, 3 * (mesh.triangle_count - mesh_degenerate_triangles(&mesh).count));
        edge_list_release(&list);
        mesh_release(&mesh);
    }
}

static bool same_set(const int32_t *s, const int32_t *t)
{
    for (int turn = 0; turn < 3; turn++)
        for (int step = 1; step < 3; step++)
            if (s[0] == t[turn] && s[1] == t[(turn + step) % 3] && s[2] == t[(turn + 2 * step) % 3])
                return true;
    return false;
}

static void random_meshes_have_the_duplicates_that_pairs_show(void **state)
{
    (void)state;
    for (uint64_t seed = 300; seed < 400; seed++) {
        struct mesh mesh = random_mesh(seed);
        struct finding expected = {0, -1}, found;
        for (int64_t t = 0; t < mesh.triangle_count; t++) {
            bool seen = false;
            for (int64_t s = 0; s < t && !seen; s++)
                seen = same_set(mesh.triangles + 3 * s, mesh.triangles + 3 * t);
            if (seen && expected.count++ == 0)
                expected.first = t;
        }
        assert_int_equal(mesh_duplicate_triangles(&mesh, &found, NULL), 0);
        assert_int_equal(found.count, expected.count);
        assert_int_equal(found.first, expected.first);
        mesh_release(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_edges_of_two_triangles),
        cmocka_unit_test(the_first_element_at_fault_is_named),
        cmocka_unit_test(boundary_loops_are_counted),
        cmocka_unit_test(random_meshes_have_the_edges_that_their_triangles_have),
        cmocka_unit_test(random_meshes_have_the_duplicates_that_pairs_show),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
