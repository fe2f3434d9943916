/* Triangle strips: decoding, cutting a mesh into them, and back. */
#include "reference/mesh/check.h"
#include "reference/mesh/generate.h"
#include "reference/mesh/strips.h"
#include "tests/unit/mesh_measures.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void odd_triangles_are_wound_the_other_way(void **state)
{
    (void)state;
    const int32_t length = 5;
    struct strips strips;
    struct soup soup;
    assert_int_equal(strips_init(&strips, 1, &length, NULL), 0);
    for (int v = 0; v < 5; v++)
        strips.positions[3 * v] = (float)v;
    assert_int_equal(strips_triangle_count(&strips), 3);
    assert_int_equal(strips_to_soup(&soup, &strips, NULL), 0);
    const float expected[9] = {0, 1, 2, 2, 1, 3, 2, 3, 4};
    for (int corner = 0; corner < 9; corner++)
        assert_true(soup.corners[3 * corner] == expected[corner]);
    soup_release(&soup);
    strips_release(&strips);
    strips_release(&strips);
}

static void every_triangle_comes_back_once_with_its_winding(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 200; seed++) {
        struct mesh mesh = random_mesh(seed), back;
        struct strips strips;
        assert_int_equal(strips_from_mesh(&strips, &mesh, NULL), 0);
        assert_int_equal(strips_check(&strips, NULL), 0);
        assert_int_equal(strips_triangle_count(&strips), mesh.triangle_count);
        assert_int_equal(strips_to_mesh(&back, &strips, NULL), 0);
        assert_int_equal(back.triangle_count, mesh.triangle_count);
        assert_true(surface_hash(&back) == surface_hash(&mesh));
        strips_release(&strips);
        mesh_release(&back);
        mesh_release(&mesh);
    }
}

static void regular_meshes_make_long_strips(void **state)
{
    (void)state;
    struct mesh mesh;
    struct strips strips;
    assert_int_equal(generate_grid(&mesh, 8, 16, NULL), 0);
    assert_int_equal(strips_from_mesh(&strips, &mesh, NULL), 0);
    assert_int_equal(strips.strip_count, 8); /* a strip a row, as in problem 4.3 */
    assert_int_equal(strips.vertex_count, 8 * 2 * 17);
    assert_int_equal(strips_bytes(strips.strip_count, strips.vertex_count),
                     4 + 8 * 8 + 24 * 8 * 17);
    strips_release(&strips);
    mesh_release(&mesh);
    assert_int_equal(generate_torus(&mesh, 1, 4000, NULL), 0);
    assert_int_equal(change_scramble(&mesh, 3, NULL), 0);
    assert_int_equal(strips_from_mesh(&strips, &mesh, NULL), 0);
    assert_true(strips.vertex_count < 3 * mesh.triangle_count / 2);
    strips_release(&strips);
    mesh_release(&mesh);
}

static void bytes_are_those_of_the_course(void **state)
{
    (void)state;
    assert_int_equal(strips_bytes(128, 2 * 129 * 128), 397316); /* problem 4.3, m = n = 128 */
}

static void impossible_strips_are_refused(void **state)
{
    (void)state;
    struct strips strips;
    struct error err = {0};
    const int32_t lengths[2] = {4, 2};
    assert_int_equal(strips_init(&strips, 2, lengths, &err), -1);
    assert_string_equal(err.text, "strip 1 of 2 vertices: a strip has at least 3");
    assert_int_equal(strips_init(&strips, -1, NULL, NULL), -1);
    assert_int_equal(strips_init(&strips, 0, NULL, NULL), 0);
    assert_int_equal(strips_check(&strips, NULL), 0);
    assert_int_equal(strips_init(&strips, 1, lengths, NULL), 0);
    assert_int_equal(strips_check(&strips, NULL), 0);
    err.text[0] = '\0';
    strips.positions[3 * 3 + 2] = INFINITY;
    assert_int_equal(strips_check(&strips, &err), -1);
    assert_string_equal(err.text, "strip 0: z of its vertex 3 is not finite");
    strips.positions[3 * 3 + 2] = 0.0F;
    strips.first_vertex[1] = 3;
    assert_int_equal(strips_check(&strips, NULL), -1);
    strips.first_vertex[1] = 5;
    assert_int_equal(strips_check(&strips, NULL), -1);
    strips_release(&strips);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(odd_triangles_are_wound_the_other_way),
        cmocka_unit_test(every_triangle_comes_back_once_with_its_winding),
        cmocka_unit_test(regular_meshes_make_long_strips),
        cmocka_unit_test(bytes_are_those_of_the_course),
        cmocka_unit_test(impossible_strips_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
