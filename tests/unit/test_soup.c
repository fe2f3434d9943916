/* Isolated triangles and welding. */
#include "reference/mesh/generate.h"
#include "reference/mesh/soup.h"
#include "tests/unit/mesh_measures.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void welding_gives_the_surface_back(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 100; seed++) {
        struct mesh mesh = random_mesh(seed), welded;
        struct soup soup;
        assert_int_equal(soup_from_mesh(&soup, &mesh, NULL), 0);
        assert_int_equal(soup_check(&soup, NULL), 0);
        assert_int_equal(soup.triangle_count, mesh.triangle_count);
        assert_int_equal(soup_to_mesh(&welded, &soup, NULL), 0);
        assert_int_equal(mesh_check(&welded, NULL), 0);
        assert_true(surface_hash(&welded) == surface_hash(&mesh));
        for (int64_t v = 0; v < welded.vertex_count; v++) /* no two are equal */
            for (int64_t w = 0; w < v; w++)
                assert_true(memcmp(welded.positions + 3 * v, welded.positions + 3 * w, 12) != 0);
        soup_release(&soup);
        mesh_release(&mesh);
        mesh_release(&welded);
    }
}

static void vertices_are_numbered_by_first_appearance(void **state)
{
    (void)state;
    struct mesh cube, welded;
    struct soup soup;
    assert_int_equal(generate_cube(&cube, NULL), 0);
    assert_int_equal(soup_from_mesh(&soup, &cube, NULL), 0);
    assert_int_equal(soup_to_mesh(&welded, &soup, NULL), 0);
    assert_int_equal(welded.vertex_count, 8);
    int32_t next = 0;
    for (int corner = 0; corner < 36; corner++) {
        assert_true(welded.triangles[corner] <= next);
        next += welded.triangles[corner] == next;
    }
    soup_release(&soup);
    mesh_release(&cube);
    mesh_release(&welded);
}

static void zeros_of_both_signs_are_one_vertex(void **state)
{
    (void)state;
    float corners[9] = {0.0F, 1.0F, 0.0F, -0.0F, 1.0F, -0.0F, 1.0F, 1.0F, 1.0F};
    struct soup soup = {corners, 1};
    struct mesh welded;
    assert_int_equal(soup_to_mesh(&welded, &soup, NULL), 0);
    assert_int_equal(welded.vertex_count, 2);
    assert_int_equal(welded.triangles[0], welded.triangles[1]);
    mesh_release(&welded);
    struct error err = {0};
    corners[4] = NAN;
    assert_int_equal(soup_check(&soup, &err), -1);
    assert_string_equal(err.text, "triangle 0 of the soup: y of corner 1 is not finite");
}

static void soups_of_nothing_and_too_much(void **state)
{
    (void)state;
    struct soup soup;
    struct mesh mesh = {0};
    struct error err = {0};
    assert_int_equal(soup_from_mesh(&soup, &mesh, NULL), 0);
    assert_int_equal(soup_to_mesh(&mesh, &soup, NULL), 0);
    assert_int_equal(mesh.vertex_count, 0);
    assert_int_equal(soup_init(&soup, INT32_MAX / 9 + 1, &err), -1);
    assert_non_null(strstr(err.text, "the count must be 0 to 238609294"));
    assert_int_equal(soup_init(&soup, -1, NULL), -1);
    assert_int_equal(soup_bytes(2 * 128 * 128), 36 * 32768);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(welding_gives_the_surface_back),
        cmocka_unit_test(vertices_are_numbered_by_first_appearance),
        cmocka_unit_test(zeros_of_both_signs_are_one_vertex),
        cmocka_unit_test(soups_of_nothing_and_too_much),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
