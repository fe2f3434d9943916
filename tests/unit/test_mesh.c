/* The mesh itself: making, copying, checking. */
#include "reference/mesh/generate.h"
#include "tests/unit/mesh_measures.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void the_empty_mesh_is_valid_and_released_twice(void **state)
{
    (void)state;
    struct mesh mesh = {0}, copy;
    struct error err = {0};
    assert_int_equal(mesh_check(&mesh, &err), 0);
    assert_int_equal(mesh_copy(&copy, &mesh, &err), 0);
    assert_int_equal(copy.vertex_count + copy.triangle_count, 0);
    mesh_release(&copy);
    mesh_release(&mesh);
    mesh_release(&mesh);
}

static void impossible_counts_are_refused(void **state)
{
    (void)state;
    const int64_t bad[] = {-1, INT32_MAX / 3 + INT64_C(1), INT64_MAX, INT64_MIN};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct mesh mesh;
        struct error err = {0};
        assert_int_equal(mesh_init(&mesh, bad[i], 1, &err), -1);
        assert_non_null(strstr(err.text, "vertices: the count must be 0 to 715827882"));
        assert_null(mesh.positions);
        err.text[0] = '\0';
        assert_int_equal(mesh_init(&mesh, 1, bad[i], &err), -1);
        assert_non_null(strstr(err.text, "triangles: the count must be"));
        assert_null(mesh.positions);
    }
}

static void a_copy_is_equal_and_separate(void **state)
{
    (void)state;
    struct mesh cube, copy;
    assert_int_equal(generate_cube(&cube, NULL), 0);
    assert_int_equal(mesh_copy(&copy, &cube, NULL), 0);
    assert_true(same_mesh(&cube, &copy));
    copy.positions[0] = 7.0F;
    assert_false(same_mesh(&cube, &copy));
    mesh_release(&copy);
    mesh_release(&cube);
}

static void bad_elements_are_named(void **state)
{
    (void)state;
    struct mesh cube;
    struct error err = {0};
    assert_int_equal(generate_cube(&cube, NULL), 0);
    cube.triangles[3 * 5 + 2] = 8;
    assert_int_equal(mesh_check(&cube, &err), -1);
    assert_string_equal(err.text, "triangle 5: corner 2 names vertex 8, the mesh has 8");
    cube.triangles[3 * 5 + 2] = -1;
    assert_int_equal(mesh_check(&cube, NULL), -1);
    cube.triangles[3 * 5 + 2] = 0;
    assert_int_equal(mesh_check(&cube, NULL), 0);
    err.text[0] = '\0';
    cube.positions[3 * 2 + 1] = NAN;
    assert_int_equal(mesh_check(&cube, &err), -1);
    assert_string_equal(err.text, "vertex 2: its y is not a finite number");
    cube.positions[3 * 2 + 1] = INFINITY;
    assert_int_equal(mesh_check(&cube, NULL), -1);
    mesh_release(&cube);
}

static void bytes_are_those_of_the_course(void **state)
{
    (void)state;
    assert_int_equal(mesh_bytes(129 * 129, 2 * 128 * 128), 592908); /* problem 4.2, m = n = 128 */
    assert_true(mesh_bytes(INT32_MAX / 3, INT32_MAX / 3) == INT64_C(17179869168));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_empty_mesh_is_valid_and_released_twice),
        cmocka_unit_test(impossible_counts_are_refused),
        cmocka_unit_test(a_copy_is_equal_and_separate),
        cmocka_unit_test(bad_elements_are_named),
        cmocka_unit_test(bytes_are_those_of_the_course),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
