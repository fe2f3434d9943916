/* Every change does what generate.h promises, and nothing else. */
#include "reference/mesh/check.h"
#include "reference/mesh/generate.h"
#include "tests/unit/mesh_measures.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct mesh torus(void)
{
    struct mesh mesh;
    assert_int_equal(generate_torus(&mesh, 2, 600, NULL), 0);
    return mesh;
}

static struct topology topology(const struct mesh *mesh)
{
    struct topology found;
    assert_int_equal(mesh_check(mesh, NULL), 0);
    assert_int_equal(mesh_topology(mesh, &found, NULL), 0);
    return found;
}

/* Another numbering and order; the same surface with the same winding, the same topology. */
static void assert_reordered(int (*change)(struct mesh *, uint64_t, struct error *))
{
    for (uint64_t seed = 0; seed < 30; seed++) {
        struct mesh mesh = random_mesh(seed), before, again;
        struct topology was = topology(&mesh);
        assert_int_equal(mesh_copy(&before, &mesh, NULL), 0);
        assert_int_equal(mesh_copy(&again, &mesh, NULL), 0);
        assert_int_equal(change(&mesh, seed + 1, NULL), 0);
        assert_int_equal(change(&again, seed + 1, NULL), 0);
        assert_true(same_mesh(&mesh, &again));
        assert_true(surface_hash(&mesh) == surface_hash(&before));
        if (mesh.triangle_count > 20)
            assert_false(same_mesh(&mesh, &before));
        struct topology is = topology(&mesh);
        assert_int_equal(is.edge_count, was.edge_count);
        assert_int_equal(is.euler_characteristic, was.euler_characteristic);
        assert_int_equal(is.boundary.count, was.boundary.count);
        assert_int_equal(is.incoherent.count, was.incoherent.count);
        assert_int_equal(is.isolated.count, was.isolated.count);
        assert_int_equal(is.nonmanifold_vertex.count, was.nonmanifold_vertex.count);
        mesh_release(&mesh);
        mesh_release(&before);
        mesh_release(&again);
    }
}

static void scrambling_keeps_the_surface(void **state)
{
    (void)state;
    assert_reordered(change_scramble);
}

static void adversarial_numbering_keeps_the_surface(void **state)
{
    (void)state;
    assert_reordered(change_adversarial_numbering);
}

static void adversarial_numbers_agree_in_their_low_bits(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_grid(&mesh, 3, 1023, NULL), 0);
    assert_int_equal(change_adversarial_numbering(&mesh, 1, NULL), 0);
    int64_t agreeing = 0;
    for (int64_t t = 0; t < mesh.triangle_count; t++) {
        const int32_t *corner = mesh.triangles + 3 * t;
        for (int i = 0; i < 3; i++)
            agreeing += ((corner[i] ^ corner[(i + 1) % 3]) & 0x3f) == 0;
    }
    /* With random numbers one pair in 64 would; without the change, none of these. */
    assert_true(agreeing > mesh.triangle_count);
    mesh_release(&mesh);
}

static void flipping_reverses_the_given_share(void **state)
{
    (void)state;
    struct mesh mesh = torus(), before;
    assert_int_equal(mesh_copy(&before, &mesh, NULL), 0);
    assert_int_equal(change_flip(&mesh, 0.0, 1, NULL), 0);
    assert_true(same_mesh(&mesh, &before));
    double volume = signed_volume(&mesh);
    assert_int_equal(change_flip(&mesh, 1.0, 1, NULL), 0);
    assert_true(signed_volume(&mesh) < -0.999 * volume);
    assert_int_equal(topology(&mesh).incoherent.count, 0);
    assert_int_equal(change_flip(&mesh, 0.5, 1, NULL), 0);
    struct topology found = topology(&mesh);
    assert_true(found.is_orientable);
    assert_in_range(found.incoherent.count, found.edge_count / 3, 2 * found.edge_count / 3);
    struct error err = {0};
    assert_int_equal(change_flip(&mesh, 1.5, 1, &err), -1);
    assert_non_null(strstr(err.text, "probability is 1.5"));
    mesh_release(&mesh);
    mesh_release(&before);
}

static void appending_adds_a_component(void **state)
{
    (void)state;
    struct mesh mesh = torus(), cube;
    int32_t vertices = mesh.vertex_count, triangles = mesh.triangle_count;
    assert_int_equal(generate_cube(&cube, NULL), 0);
    assert_int_equal(change_append(&mesh, &cube, 2.0F, 0.0F, -1.0F, NULL), 0);
    assert_int_equal(mesh.vertex_count, vertices + 8);
    assert_int_equal(mesh.triangle_count, triangles + 12);
    assert_true(mesh.positions[3 * vertices] == cube.positions[0] + 2.0F);
    assert_true(mesh.positions[3 * vertices + 2] == cube.positions[2] - 1.0F);
    struct topology found = topology(&mesh);
    assert_int_equal(found.component_count, 2);
    assert_int_equal(found.euler_characteristic, -2 + 2);
    struct mesh empty = {0};
    assert_int_equal(change_append(&empty, &cube, 0.0F, 0.0F, 0.0F, NULL), 0);
    assert_true(same_mesh(&empty, &cube));
    mesh_release(&empty);
    mesh_release(&mesh);
    mesh_release(&cube);
}

static void isolated_vertices_leave_the_surface(void **state)
{
    (void)state;
    struct mesh mesh = torus();
    uint64_t hash = surface_hash(&mesh);
    int32_t vertices = mesh.vertex_count;
    assert_int_equal(change_add_isolated_vertices(&mesh, 25, 4, NULL), 0);
    assert_int_equal(mesh.vertex_count, vertices + 25);
    assert_true(surface_hash(&mesh) == hash);
    struct topology found = topology(&mesh);
    assert_int_equal(found.isolated.count, 25);
    assert_true(found.isolated.first < vertices); /* mixed in, not put at the end */
    assert_int_equal(found.euler_characteristic, -2);
    assert_int_equal(change_add_isolated_vertices(&mesh, -1, 4, NULL), -1);
    mesh_release(&mesh);
    struct mesh empty = {0};
    assert_int_equal(change_add_isolated_vertices(&empty, 3, 4, NULL), 0);
    assert_int_equal(topology(&empty).isolated.count, 3);
    mesh_release(&empty);
}

static void duplicates_and_degenerates_are_found_again(void **state)
{
    (void)state;
    struct mesh mesh = torus();
    int64_t edges = topology(&mesh).edge_count;
    int32_t triangles = mesh.triangle_count;
    assert_int_equal(change_add_duplicate_triangles(&mesh, 7, 1, NULL), 0);
    struct topology found = topology(&mesh);
    assert_int_equal(found.duplicate.count, 7);
    assert_int_equal(found.duplicate.first, triangles);
    assert_int_equal(found.edge_count, edges);
    assert_int_equal(change_add_degenerate_triangles(&mesh, 9, 1, NULL), 0);
    found = topology(&mesh);
    assert_int_equal(found.degenerate.count, 9);
    assert_int_equal(found.degenerate.first, triangles + 7);
    assert_int_equal(found.edge_count, edges);
    const int32_t *last = mesh.triangles + 3 * (int64_t)(mesh.triangle_count - 3);
    assert_true(last[0] == last[1] && last[1] != last[2]);
    assert_true(last[3] == last[5] && last[3] != last[4]);
    assert_true(last[6] == last[7] && last[7] == last[8]);
    mesh_release(&mesh);
    struct mesh empty = {0};
    struct error err = {0};
    assert_int_equal(change_add_duplicate_triangles(&empty, 1, 1, &err), -1);
    assert_non_null(strstr(err.text, "the count is 1 and must be 0 to 0"));
    assert_int_equal(change_add_degenerate_triangles(&empty, 1, 1, NULL), -1);
    assert_int_equal(change_add_degenerate_triangles(&empty, 0, 1, NULL), 0);
}

static void removing_makes_holes(void **state)
{
    (void)state;
    struct mesh mesh = torus();
    int32_t triangles = mesh.triangle_count;
    assert_int_equal(change_remove_triangles(&mesh, 5, 1, NULL), 0);
    assert_int_equal(mesh.triangle_count, triangles - 5);
    struct topology found = topology(&mesh);
    assert_true(found.boundary.count > 0 && found.boundary.count <= 15);
    struct error err = {0};
    assert_int_equal(change_remove_triangles(&mesh, triangles, 1, &err), -1);
    assert_non_null(strstr(err.text, "removing triangles: the count is"));
    assert_int_equal(mesh.triangle_count, triangles - 5);
    assert_int_equal(change_remove_triangles(&mesh, mesh.triangle_count, 1, NULL), 0);
    assert_int_equal(mesh.triangle_count, 0);
    mesh_release(&mesh);
}

static void moving_and_scaling_are_in_binary32(void **state)
{
    (void)state;
    struct mesh cube;
    assert_int_equal(generate_cube(&cube, NULL), 0);
    change_scale(&cube, 4.0F);
    change_translate(&cube, 1.0F, 2.0F, 3.0F);
    assert_true(cube.positions[0] == -1.0F && cube.positions[1] == 0.0F);
    assert_true(cube.positions[3 * 7 + 2] == 5.0F);
    change_translate(&cube, 1e9F, 0.0F, 0.0F); /* numbers there are 64 apart */
    assert_true(cube.positions[0] == 1e9F && cube.positions[3] == 1e9F);
    mesh_release(&cube);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scrambling_keeps_the_surface),
        cmocka_unit_test(adversarial_numbering_keeps_the_surface),
        cmocka_unit_test(adversarial_numbers_agree_in_their_low_bits),
        cmocka_unit_test(flipping_reverses_the_given_share),
        cmocka_unit_test(appending_adds_a_component),
        cmocka_unit_test(isolated_vertices_leave_the_surface),
        cmocka_unit_test(duplicates_and_degenerates_are_found_again),
        cmocka_unit_test(removing_makes_holes),
        cmocka_unit_test(moving_and_scaling_are_in_binary32),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
