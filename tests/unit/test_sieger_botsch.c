/* The paper's operations give the same on every structure, and what is known of them by hand. */
#include "bench/compare/sieger_botsch.h"
#include "reference/mesh/check.h"
#include "reference/mesh/generate.h"
#include "tests/unit/mesh_measures.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MESHES = 6 };

static struct mesh sample(int which)
{
    struct mesh mesh;
    int code = which == 0   ? generate_tetrahedron(&mesh, NULL)
               : which == 1 ? generate_grid(&mesh, 5, 7, NULL)
               : which == 2 ? generate_torus(&mesh, 2, 900, NULL)
               : which == 3 ? generate_disc(&mesh, 3, 9, NULL)
               : which == 4 ? generate_bipyramid(&mesh, 50, NULL)
                            : generate_one_triangle(&mesh, NULL);
    assert_int_equal(code, 0);
    if (which != 1)
        assert_int_equal(change_scramble(&mesh, 3, NULL), 0);
    if (which == 3)
        assert_int_equal(change_add_isolated_vertices(&mesh, 3, 5, NULL), 0);
    return mesh;
}

static int compare_triangles(const void *a, const void *b)
{
    return memcmp(a, b, 3 * sizeof(int32_t));
}

/* Each triangle from its lowest corner, in one order. */
static void normalise(struct mesh *mesh)
{
    for (int64_t t = 0; t < mesh->triangle_count; t++) {
        int32_t *c = mesh->triangles + 3 * t;
        while (c[0] > c[1] || c[0] > c[2]) {
            int32_t first = c[0];
            c[0] = c[1];
            c[1] = c[2];
            c[2] = first;
        }
    }
    if (mesh->triangle_count)
        qsort(mesh->triangles, (size_t)mesh->triangle_count, 12, compare_triangles);
}

static void require_near(const float *a, const float *b, int64_t count)
{
    for (int64_t i = 0; i < count; i++)
        assert_true(fabs((double)a[i] - (double)b[i]) < 1e-5);
}

/* Does an operation on every structure; returns the first one's mesh, which the caller owns. */
static struct mesh done_by_all(const struct mesh *mesh, enum paper_operation operation)
{
    struct mesh first = {0};
    float *first_normals = NULL;
    int64_t first_sum = 0;
    for (int i = 0; paper_structures[i]; i++) {
        struct paper_run run;
        struct mesh after;
        const float *normals;
        assert_int_equal(paper_open(&run, paper_structures[i], mesh, NULL), 0);
        for (int time = 0; time < 2; time++) {
            assert_int_equal(paper_do(&run, operation, NULL), 0);
            if (time == 0)
                assert_int_equal(paper_undo(&run, operation, NULL), 0);
        }
        assert_int_equal(paper_result(&run, &after, &normals, NULL), 0);
        normalise(&after);
        if (i == 0) {
            size_t size = 12 * (size_t)after.vertex_count;
            first = after;
            first_sum = run.sum;
            first_normals = malloc(size + 1);
            assert_non_null(first_normals);
            if (operation != PAPER_SUBDIVISION)
                memcpy(first_normals, normals, size);
        } else {
            assert_int_equal(run.sum, first_sum);
            assert_int_equal(after.vertex_count, first.vertex_count);
            assert_int_equal(after.triangle_count, first.triangle_count);
            assert_memory_equal(after.triangles, first.triangles,
                                12 * (size_t)first.triangle_count);
            require_near(after.positions, first.positions, 3 * (int64_t)first.vertex_count);
            if (operation != PAPER_SUBDIVISION)
                require_near(normals, first_normals, 3 * (int64_t)first.vertex_count);
            mesh_release(&after);
        }
        paper_close(&run);
    }
    free(first_normals);
    return first;
}

static void all_structures_agree(void **state)
{
    (void)state;
    for (int which = 0; which < MESHES; which++) {
        struct mesh mesh = sample(which);
        for (int operation = 0; operation < PAPER_OPERATION_COUNT; operation++) {
            struct mesh after = done_by_all(&mesh, (enum paper_operation)operation);
            mesh_release(&after);
        }
        mesh_release(&mesh);
    }
}

static void the_circulator_meets_every_corner_twice(void **state)
{
    (void)state;
    struct mesh mesh = sample(3);
    int64_t expected = 0;
    for (int64_t c = 0; c < 3 * (int64_t)mesh.triangle_count; c++)
        expected += c / 3 - mesh.triangles[c];
    for (int i = 0; paper_structures[i]; i++) {
        struct paper_run run;
        assert_int_equal(paper_open(&run, paper_structures[i], &mesh, NULL), 0);
        assert_int_equal(paper_do(&run, PAPER_CIRCULATOR, NULL), 0);
        assert_int_equal(run.sum, expected);
        paper_close(&run);
    }
    mesh_release(&mesh);
}

/* sqrt(3) subdivision triples the faces, puts a vertex on each, and doubles no edge. */
static void subdivision_triples_the_faces(void **state)
{
    (void)state;
    for (int which = 0; which < MESHES; which++) {
        struct mesh mesh = sample(which), finer = done_by_all(&mesh, PAPER_SUBDIVISION);
        struct topology before, after;
        assert_int_equal(mesh_topology(&mesh, &before, NULL), 0);
        assert_int_equal(mesh_topology(&finer, &after, NULL), 0);
        assert_int_equal(after.triangle_count, 3 * before.triangle_count);
        assert_int_equal(after.vertex_count, before.vertex_count + before.triangle_count);
        assert_int_equal(after.edge_count, before.edge_count + 3 * before.triangle_count);
        assert_int_equal(after.euler_characteristic, before.euler_characteristic);
        assert_int_equal(after.boundary.count, before.boundary.count);
        assert_int_equal(after.nonmanifold_edge.count + after.nonmanifold_vertex.count, 0);
        assert_int_equal(after.incoherent.count + after.degenerate.count, 0);
        mesh_release(&finer);
        mesh_release(&mesh);
    }
}

/* A regular tetrahedron: valence 3 has weight (4 - 2 cos 120 degrees) / 9 = 5/9, and the mean of
 * the neighbours is -1/3 of the corner when the centre is the origin. */
static void subdivision_of_a_tetrahedron_is_known(void **state)
{
    (void)state;
    float positions[12] = {1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1};
    int32_t triangles[12] = {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2};
    struct mesh mesh = {positions, triangles, 4, 4};
    assert_true(fabs(paper_sqrt3_weight(3) - 5.0 / 9.0) < 1e-12);
    assert_true(fabs(paper_sqrt3_weight(6) - 1.0 / 3.0) < 1e-12);
    struct mesh finer = done_by_all(&mesh, PAPER_SUBDIVISION);
    const double old = 1.0 - 5.0 / 9.0 - 5.0 / 27.0;
    for (int i = 0; i < 12; i++)
        assert_true(fabs((double)finer.positions[i] - old * (double)positions[i]) < 1e-6);
    for (int i = 12; i < 24; i++) /* centroids: a third of the corner left out, reversed */
        assert_true(fabs(fabs((double)finer.positions[i]) - 1.0 / 3.0) < 1e-6);
    mesh_release(&finer);
}

static void collapse_gives_the_mesh_back(void **state)
{
    (void)state;
    for (int which = 0; which < MESHES; which++) {
        struct mesh mesh = sample(which), after = done_by_all(&mesh, PAPER_COLLAPSE);
        normalise(&mesh);
        assert_true(same_mesh(&mesh, &after));
        mesh_release(&after);
        mesh_release(&mesh);
    }
}

static void the_barycentre_goes_to_the_origin(void **state)
{
    (void)state;
    struct mesh mesh = sample(2), after = done_by_all(&mesh, PAPER_BARYCENTRE);
    double sum[3] = {0};
    for (int64_t i = 0; i < 3 * (int64_t)after.vertex_count; i++)
        sum[i % 3] += (double)after.positions[i];
    for (int axis = 0; axis < 3; axis++)
        assert_true(fabs(sum[axis] / after.vertex_count) < 1e-7);
    mesh_release(&after);
    mesh_release(&mesh);
}

static void meshes_that_are_no_manifold_are_refused(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_two_cubes(&mesh, NULL), 0);
    for (int i = 0; paper_structures[i]; i++) {
        struct paper_run run;
        struct error err = {0};
        assert_int_equal(paper_open(&run, paper_structures[i], &mesh, &err), -1);
        assert_non_null(strstr(err.text, "is non-manifold"));
        assert_ptr_equal(paper_structure_find(paper_structures[i]->name), paper_structures[i]);
    }
    assert_null(paper_structure_find("no such structure"));
    mesh_release(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_structures_agree),
        cmocka_unit_test(the_circulator_meets_every_corner_twice),
        cmocka_unit_test(subdivision_triples_the_faces),
        cmocka_unit_test(subdivision_of_a_tetrahedron_is_known),
        cmocka_unit_test(collapse_gives_the_mesh_back),
        cmocka_unit_test(the_barycentre_goes_to_the_origin),
        cmocka_unit_test(meshes_that_are_no_manifold_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
