/* Area and normals: variants equal plain (the area within its bound), plain equals the formula. */
#include "reference/mesh/edges.h"
#include "reference/mesh/generate.h"
#include "tests/unit/kernel_checks.h"

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* (b - a) x (c - a) in extended precision. */
static void cross_of(const struct mesh *mesh, int64_t triangle, long double cross[3])
{
    long double u[3], v[3];
    const int32_t *t = mesh->triangles + 3 * triangle;
    for (int axis = 0; axis < 3; axis++) {
        long double a = mesh->positions[3 * (int64_t)t[0] + axis];
        u[axis] = mesh->positions[3 * (int64_t)t[1] + axis] - a;
        v[axis] = mesh->positions[3 * (int64_t)t[2] + axis] - a;
    }
    for (int axis = 0; axis < 3; axis++) {
        int y = (axis + 1) % 3, z = (axis + 2) % 3;
        cross[axis] = u[y] * v[z] - u[z] * v[y];
    }
}

static long double length_of(const long double v[3])
{
    return sqrtl(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static double area_by(const struct kernel *kernel, const struct mesh *mesh)
{
    int64_t count;
    double *output = run_guarded(kernel, mesh, &count), area = *output;
    assert_int_equal(count, 1);
    free_guarded(output);
    return area;
}

static double area_on(int thread_count, const struct mesh *mesh)
{
    int64_t count;
    double *output =
        run_guarded_on_threads(kernel_find("area", "threads"), mesh, thread_count, &count);
    double area = *output;
    free_guarded(output);
    return area;
}

/* The bound of area.h, and the sum in extended precision as what is right. */
static void area_is_within_bound(const struct mesh *mesh)
{
    long double right = 0;
    for (int64_t t = 0; t < mesh->triangle_count; t++) {
        long double cross[3];
        cross_of(mesh, t, cross);
        right += 0.5L * length_of(cross);
    }
    double plain = area_by(kernel_find("area", "plain"), mesh);
    double bound = (mesh->triangle_count + 1) * DBL_EPSILON * plain;
    /* In binary64 the products of the worst needle of the set still keep nine digits. */
    if (fabsl(plain - right) > 1e-9L * right)
        fail_msg("area of %d triangles is %.17g for %.17Lg", mesh->triangle_count, plain, right);
    for (const struct kernel *k = kernel_table; k->name; k++) {
        if (strcmp(k->name, "area") != 0 || !k->available())
            continue;
        double area = area_by(k, mesh);
        if (!(fabs(area - plain) <= bound))
            fail_msg("area by %s is %.17g for %.17g", k->variant, area, plain);
        assert_true(area == area_by(k, mesh));
    }
    for (int threads = 1; threads <= 7; threads += 3) {
        double area = area_on(threads, mesh);
        assert_true(fabs(area - plain) <= bound);
        assert_true(area == area_on(threads, mesh));
    }
}

static void area_variants_are_within_the_bound(void **state)
{
    (void)state;
    with_every_mesh(area_is_within_bound);
}

/* A millionth of a cube, and a cube of a million: squares of binary32 would underflow and overflow.
 */
static void area_keeps_its_range(void **state)
{
    (void)state;
    for (float scale = 1e-18F; scale < 1e19F; scale *= 1e6F) {
        struct mesh mesh;
        assert_int_equal(generate_icosphere(&mesh, 2, NULL), 0);
        double unit = area_by(kernel_find("area", "plain"), &mesh);
        change_scale(&mesh, scale);
        double square = (double)scale * (double)scale;
        for (const struct kernel *k = kernel_table; k->name; k++)
            if (strcmp(k->name, "area") == 0 && k->available())
                assert_true(fabs(area_by(k, &mesh) / square / unit - 1) < 1e-6);
        mesh_release(&mesh);
    }
}

static void normal_variants_equal(const struct mesh *mesh)
{
    check_variants_equal("face-normals", mesh, 3 * sizeof(float));
    check_variants_equal("vertex-normals", mesh, 3 * sizeof(float));
}

static void normal_variants_are_equal(void **state)
{
    (void)state;
    with_every_mesh(normal_variants_equal);
}

/* Equal to the right vector made of length 1, as far as the vector is known to within `error`. */
static void assert_direction(const float *normal, const long double right[3], long double error)
{
    long double length = length_of(right);
    if (length == 0 && error == 0) {
        assert_true(normal[0] == 0 && normal[1] == 0 && normal[2] == 0);
        return;
    }
    for (int axis = 0; axis < 3; axis++) {
        assert_true(fabsf(normal[axis]) <= 1.000001F);
        if (length > error)
            assert_true(fabsl(normal[axis] - right[axis] / length) <= 1e-6L + 2 * error / length);
    }
}

static void face_normals_follow_the_formula(const struct mesh *mesh)
{
    int64_t count;
    float *normals = run_guarded(kernel_find("face-normals", "plain"), mesh, &count);
    assert_int_equal(count, mesh->triangle_count);
    for (int64_t t = 0; t < count; t++) {
        long double cross[3];
        cross_of(mesh, t, cross);
        /* Products of sides of at most 2, rounded to binary64; none is rounded at a corner met
         * twice. */
        bool degenerate = triangle_is_degenerate(mesh->triangles + 3 * t);
        assert_direction(normals + 3 * t, cross, degenerate ? 0 : 16 * (long double)DBL_EPSILON);
    }
    free_guarded(normals);
}

static void vertex_normals_follow_the_formula(const struct mesh *mesh)
{
    size_t n = (size_t)mesh->vertex_count;
    long double *sums = calloc(3 * n + 1, sizeof *sums), *sizes = calloc(n + 1, sizeof *sizes);
    assert_true(sums && sizes);
    for (int64_t t = 0; t < mesh->triangle_count; t++) {
        long double cross[3];
        cross_of(mesh, t, cross);
        const int32_t *corner = mesh->triangles + 3 * t;
        for (int k = 0; k < 3; k++) {
            for (int axis = 0; axis < 3; axis++)
                sums[3 * (size_t)corner[k] + axis] += cross[axis];
            sizes[corner[k]] += 1;
        }
    }
    int64_t count;
    float *normals = run_guarded(kernel_find("vertex-normals", "plain"), mesh, &count);
    assert_int_equal(count, n);
    for (size_t v = 0; v < n; v++) {
        /* Products of sides of at most 2, rounded to binary32, as many as the valence. */
        long double error = sizes[v] * (sizes[v] + 8) * 4 * (long double)FLT_EPSILON;
        assert_direction(normals + 3 * v, sums + 3 * v, error);
    }
    free(sums);
    free(sizes);
    free_guarded(normals);
}

static void normals_follow_the_formula(void **state)
{
    (void)state;
    with_every_mesh(face_normals_follow_the_formula);
    with_every_mesh(vertex_normals_follow_the_formula);
}

/* Outwards, and on a sphere along the radius. */
static void normals_of_a_sphere_point_outwards(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_icosphere(&mesh, 5, NULL), 0);
    int64_t count;
    float *normals = run_guarded(kernel_find("vertex-normals", NULL), &mesh, &count);
    for (int64_t k = 0; k < 3 * count; k++)
        assert_true(fabsf(normals[k] - 2 * mesh.positions[k]) < 0.01F);
    free_guarded(normals);
    mesh_release(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(area_variants_are_within_the_bound),
        cmocka_unit_test(area_keeps_its_range),
        cmocka_unit_test(normal_variants_are_equal),
        cmocka_unit_test(normals_follow_the_formula),
        cmocka_unit_test(normals_of_a_sphere_point_outwards),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
