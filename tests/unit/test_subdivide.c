/* Subdivision: counts, topology and shape are what subdivide.h promises. */
#include "reference/mesh/check.h"
#include "reference/mesh/generate.h"
#include "reference/mesh/subdivide.h"
#include "tests/unit/mesh_measures.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct topology topology(const struct mesh *mesh)
{
    struct topology found;
    assert_int_equal(mesh_check(mesh, NULL), 0);
    assert_int_equal(mesh_topology(mesh, &found, NULL), 0);
    return found;
}

static double area(const struct mesh *mesh)
{
    double sum = 0.0;
    for (int64_t t = 0; t < mesh->triangle_count; t++) {
        double u[3], v[3], cross = 0.0;
        const int32_t *c = mesh->triangles + 3 * t;
        for (int axis = 0; axis < 3; axis++) {
            double base = (double)mesh->positions[3 * (int64_t)c[0] + axis];
            u[axis] = (double)mesh->positions[3 * (int64_t)c[1] + axis] - base;
            v[axis] = (double)mesh->positions[3 * (int64_t)c[2] + axis] - base;
        }
        for (int axis = 0; axis < 3; axis++) {
            int i = (axis + 1) % 3, j = (axis + 2) % 3;
            cross += (u[i] * v[j] - u[j] * v[i]) * (u[i] * v[j] - u[j] * v[i]);
        }
        sum += 0.5 * sqrt(cross);
    }
    return sum;
}

/* Everything that must stay stays; counts grow as the formulas say. */
static void assert_subdivided(const struct topology *was, const struct topology *is, int64_t parts)
{
    int64_t inner = (parts - 1) * (parts - 2) / 2;
    assert_int_equal(is->vertex_count, was->vertex_count + (parts - 1) * was->edge_count +
                                           inner * was->triangle_count);
    assert_int_equal(is->edge_count,
                     parts * was->edge_count + 3 * parts * (parts - 1) / 2 * was->triangle_count);
    assert_int_equal(is->triangle_count, parts * parts * was->triangle_count);
    assert_int_equal(is->euler_characteristic, was->euler_characteristic);
    assert_int_equal(is->component_count, was->component_count);
    assert_int_equal(is->boundary_loop_count, was->boundary_loop_count);
    assert_int_equal(is->boundary.count, parts * was->boundary.count);
    assert_int_equal(is->incoherent.count, parts * was->incoherent.count);
    assert_int_equal(is->nonmanifold_edge.count, parts * was->nonmanifold_edge.count);
    assert_int_equal(is->isolated.count, was->isolated.count);
    assert_int_equal(is->is_orientable, was->is_orientable);
    assert_int_equal(is->degenerate.count, 0);
}

static void topology_stays_and_counts_follow_the_formula(void **state)
{
    (void)state;
    int tried = 0;
    for (uint64_t seed = 0; seed < 150; seed++) {
        struct mesh mesh = random_mesh(seed);
        struct topology was = topology(&mesh);
        if (was.degenerate.count == 0 && was.duplicate.count == 0) {
            int parts = 1 + (int)(seed % 5);
            struct mesh smooth;
            assert_int_equal(mesh_copy(&smooth, &mesh, NULL), 0);
            double area_before = area(&mesh);
            uint64_t hash = surface_hash(&mesh);
            assert_int_equal(subdivide_flat(&mesh, parts, NULL), 0);
            struct topology is = topology(&mesh);
            assert_subdivided(&was, &is, parts);
            assert_true(fabs(area(&mesh) - area_before) <= 1e-4 * area_before);
            if (parts == 1)
                assert_true(surface_hash(&mesh) == hash);
            assert_int_equal(subdivide_loop(&smooth, NULL), 0);
            is = topology(&smooth);
            assert_subdivided(&was, &is, 2);
            mesh_release(&smooth);
            tried++;
        }
        mesh_release(&mesh);
    }
    assert_true(tried > 60);
}

static void a_triangle_splits_as_in_the_picture(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(mesh_init(&mesh, 3, 1, NULL), 0);
    const float corners[9] = {0, 0, 0, 3, 0, 0, 0, 3, 0};
    const int32_t triangle[3] = {0, 1, 2};
    memcpy(mesh.positions, corners, sizeof corners);
    memcpy(mesh.triangles, triangle, sizeof triangle);
    assert_int_equal(subdivide_flat(&mesh, 3, NULL), 0);
    /* 3 4 on edge 0 1, 5 6 on edge 0 2, 7 8 on edge 1 2, 9 inside. */
    const int32_t expected[27] = {0, 3, 5, 3, 9, 5, 3, 4, 9, 4, 7, 9, 4, 1,
                                  7, 5, 9, 6, 9, 8, 6, 9, 7, 8, 6, 8, 2};
    assert_memory_equal(mesh.triangles, expected, sizeof expected);
    const float inside[3] = {1, 1, 0}, third[3] = {1, 0, 0}, seventh[3] = {2, 1, 0};
    assert_memory_equal(mesh.positions + 27, inside, sizeof inside);
    assert_memory_equal(mesh.positions + 9, third, sizeof third);
    assert_memory_equal(mesh.positions + 21, seventh, sizeof seventh);
    mesh_release(&mesh);
}

static void loop_weights_are_those_of_the_paper(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_tetrahedron(&mesh, NULL), 0);
    float old[12];
    memcpy(old, mesh.positions, sizeof old);
    assert_int_equal(subdivide_loop(&mesh, NULL), 0);
    for (int axis = 0; axis < 3; axis++) {
        double others = (double)old[3 + axis] + (double)old[6 + axis] + (double)old[9 + axis];
        double corner = 7.0 / 16.0 * (double)old[axis] + 3.0 / 16.0 * others;
        assert_true(fabs((double)mesh.positions[axis] - corner) < 1e-6);
        /* The first new vertex lies on edge 0 1; the other two corners are opposite to it. */
        double edge = 0.375 * ((double)old[axis] + (double)old[3 + axis]) +
                      0.125 * ((double)old[6 + axis] + (double)old[9 + axis]);
        assert_true(fabs((double)mesh.positions[12 + axis] - edge) < 1e-6);
    }
    mesh_release(&mesh);
    /* One triangle is all boundary: corners 3/4 1/8 1/8, edges 1/2 1/2. */
    assert_int_equal(generate_one_triangle(&mesh, NULL), 0);
    memcpy(old, mesh.positions, 9 * sizeof *old);
    assert_int_equal(subdivide_loop(&mesh, NULL), 0);
    for (int axis = 0; axis < 3; axis++) {
        double corner = 0.75 * (double)old[axis] + 0.125 * (double)(old[3 + axis] + old[6 + axis]);
        assert_true(fabs((double)mesh.positions[axis] - corner) < 1e-6);
        assert_true(fabs((double)mesh.positions[9 + axis] -
                         0.5 * (double)(old[axis] + old[3 + axis])) < 1e-6);
    }
    mesh_release(&mesh);
}

static void loop_smooths_a_body_without_turning_it(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_icosphere(&mesh, 1, NULL), 0);
    double volume = signed_volume(&mesh);
    for (int step = 0; step < 3; step++)
        assert_int_equal(subdivide_loop(&mesh, NULL), 0);
    assert_int_equal(mesh.triangle_count, 80 * 64);
    assert_true(signed_volume(&mesh) > 0.7 * volume && signed_volume(&mesh) < volume);
    mesh_release(&mesh);
}

static void a_wanted_count_is_met_as_closely_as_squares_allow(void **state)
{
    (void)state;
    const int64_t cases[][2] = {{1, 12},
                                {12, 12},
                                {29, 12},
                                {31, 48},
                                {100, 108},
                                {48, 48},
                                {12000, 31 * 31 * 12 + 12 * 63}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct mesh mesh;
        assert_int_equal(generate_cube(&mesh, NULL), 0);
        assert_int_equal(subdivide_to(&mesh, cases[i][0], NULL), 0);
        assert_int_equal(mesh.triangle_count, cases[i][1]);
        mesh_release(&mesh);
    }
}

static void what_cannot_be_split_is_refused_and_left(void **state)
{
    (void)state;
    struct mesh mesh, before;
    struct error err = {0};
    assert_int_equal(generate_cube(&mesh, NULL), 0);
    assert_int_equal(subdivide_flat(&mesh, 0, &err), -1);
    assert_string_equal(err.text, "splitting edges in 0 parts, it must be 1 to 30000");
    err.text[0] = '\0';
    assert_int_equal(subdivide_flat(&mesh, 30000, &err), -1); /* more than a mesh can hold */
    assert_true(err.text[0] != '\0');
    assert_int_equal(subdivide_to(&mesh, 0, NULL), -1);
    assert_int_equal(subdivide_to(&mesh, INT64_MAX, NULL), -1);
    assert_int_equal(change_add_degenerate_triangles(&mesh, 1, 1, NULL), 0);
    assert_int_equal(mesh_copy(&before, &mesh, NULL), 0);
    err.text[0] = '\0';
    assert_int_equal(subdivide_flat(&mesh, 2, &err), -1);
    assert_non_null(strstr(err.text, "is degenerate: remove it before the mesh is subdivided"));
    assert_int_equal(subdivide_loop(&mesh, NULL), -1);
    assert_true(same_mesh(&mesh, &before));
    mesh_release(&before);
    mesh_release(&mesh);
    assert_int_equal(generate_empty(&mesh, NULL), 0);
    assert_int_equal(subdivide_loop(&mesh, NULL), 0);
    assert_int_equal(mesh.vertex_count + mesh.triangle_count, 0);
    assert_int_equal(subdivide_to(&mesh, 5, NULL), -1);
    mesh_release(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(topology_stays_and_counts_follow_the_formula),
        cmocka_unit_test(a_triangle_splits_as_in_the_picture),
        cmocka_unit_test(loop_weights_are_those_of_the_paper),
        cmocka_unit_test(loop_smooths_a_body_without_turning_it),
        cmocka_unit_test(a_wanted_count_is_met_as_closely_as_squares_allow),
        cmocka_unit_test(what_cannot_be_split_is_refused_and_left),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
