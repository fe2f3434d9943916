/* Every generator makes the mesh that generate.h promises. */
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

/* What a surface must be; counts of -1 are not looked at. */
struct facts {
    int64_t vertices, triangles, euler, components, boundary_edges, boundary_loops;
    int64_t nonmanifold_edges, nonmanifold_vertices;
    bool is_orientable;
};

/* Checks validity, the facts, coherence where it is possible, and outward normals where closed. */
static void assert_facts(struct mesh *mesh, const struct facts *facts)
{
    struct topology found;
    struct error err = {0};
    assert_int_equal(mesh_check(mesh, &err), 0);
    assert_int_equal(mesh_topology(mesh, &found, &err), 0);
    if (facts->vertices >= 0)
        assert_int_equal(mesh->vertex_count, facts->vertices);
    if (facts->triangles >= 0)
        assert_int_equal(mesh->triangle_count, facts->triangles);
    assert_int_equal(found.euler_characteristic, facts->euler);
    assert_int_equal(found.component_count, facts->components);
    assert_int_equal(found.boundary.count, facts->boundary_edges);
    assert_int_equal(found.boundary_loop_count, facts->boundary_loops);
    assert_int_equal(found.nonmanifold_edge.count, facts->nonmanifold_edges);
    assert_int_equal(found.nonmanifold_vertex.count, facts->nonmanifold_vertices);
    assert_int_equal(found.is_orientable, facts->is_orientable);
    assert_int_equal(found.degenerate.count + found.duplicate.count + found.isolated.count, 0);
    if (facts->is_orientable)
        assert_int_equal(found.incoherent.count, 0);
    if (facts->boundary_edges == 0 && mesh->triangle_count > 0)
        assert_true(signed_volume(mesh) > 0.0);
    for (int64_t i = 0; i < 3 * (int64_t)mesh->vertex_count; i++)
        assert_true(fabsf(mesh->positions[i]) <= 0.75F);
    mesh_release(mesh);
}

static struct facts closed_surface(int64_t vertices, int64_t triangles, int64_t euler)
{
    return (struct facts){.vertices = vertices,
                          .triangles = triangles,
                          .euler = euler,
                          .components = 1,
                          .is_orientable = true};
}

static struct facts open_disc(int64_t vertices, int64_t triangles, int64_t boundary_edges)
{
    return (struct facts){.vertices = vertices,
                          .triangles = triangles,
                          .euler = 1,
                          .components = 1,
                          .boundary_edges = boundary_edges,
                          .boundary_loops = 1,
                          .is_orientable = true};
}

static void grids_are_open_discs(void **state)
{
    (void)state;
    for (int64_t m = 1; m <= 5; m++)
        for (int64_t n = 1; n <= 5; n++) {
            struct mesh mesh;
            assert_int_equal(generate_grid(&mesh, m, n, NULL), 0);
            struct facts facts = open_disc((m + 1) * (n + 1), 2 * m * n, 2 * (m + n));
            assert_facts(&mesh, &facts);
        }
}

static void grid_vertices_stand_where_the_header_says(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_grid(&mesh, 4, 2, NULL), 0);
    for (int r = 0; r <= 4; r++)
        for (int c = 0; c <= 2; c++) {
            const float *p = mesh.positions + 3 * (r * 3 + c);
            assert_true(p[0] == (float)c / 2.0F - 0.5F && p[1] == (float)r / 4.0F - 0.5F);
        }
    mesh_release(&mesh);
}

static void spheres_are_closed_of_genus_0(void **state)
{
    (void)state;
    for (int64_t around = 3; around <= 7; around++)
        for (int64_t rows = 1; rows <= 5; rows++) {
            struct mesh mesh;
            assert_int_equal(generate_uv_sphere(&mesh, around, rows, NULL), 0);
            struct facts facts = closed_surface(rows * around + 2, 2 * rows * around, 2);
            assert_facts(&mesh, &facts);
        }
    for (int levels = 0; levels <= 4; levels++) {
        struct mesh mesh;
        int64_t triangles = 20 * (INT64_C(1) << (2 * levels));
        assert_int_equal(generate_icosphere(&mesh, levels, NULL), 0);
        for (int64_t v = 0; v < mesh.vertex_count; v++) {
            const float *p = mesh.positions + 3 * v;
            assert_true(fabs(hypot(hypot((double)p[0], (double)p[1]), (double)p[2]) - 0.5) < 1e-7);
        }
        struct facts facts = closed_surface(triangles / 2 + 2, triangles, 2);
        assert_facts(&mesh, &facts);
    }
}

static void tori_have_their_genus(void **state)
{
    (void)state;
    const int64_t sizes[] = {1, 30, 100, 333, 1000, 5000};
    for (int genus = 0; genus <= 6; genus++)
        for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
            struct mesh mesh;
            assert_int_equal(generate_torus(&mesh, genus, sizes[i], NULL), 0);
            if (sizes[i] == 5000) /* "about": within a tenth for fine meshes */
                assert_in_range(mesh.triangle_count, 4500, 5500);
            struct facts facts = closed_surface(-1, -1, 2 - 2 * genus);
            assert_facts(&mesh, &facts);
        }
}

static void discs_and_fans_are_open_discs(void **state)
{
    (void)state;
    for (int64_t n = 3; n <= 9; n++) {
        struct mesh mesh;
        assert_int_equal(generate_disc(&mesh, 4, n, NULL), 0);
        struct facts facts = open_disc(4 * n + 1, 7 * n, n);
        assert_facts(&mesh, &facts);
        assert_int_equal(generate_fan(&mesh, n - 2, NULL), 0);
        facts = open_disc(n, n - 2, n);
        assert_facts(&mesh, &facts);
        assert_int_equal(generate_needles(&mesh, n, 0.001, 5, NULL), 0);
        facts = open_disc(n + 2, n, n + 2);
        assert_facts(&mesh, &facts);
    }
    struct mesh mesh;
    assert_int_equal(generate_one_triangle(&mesh, NULL), 0);
    struct facts facts = open_disc(3, 1, 3);
    assert_facts(&mesh, &facts);
}

static void small_solids_are_closed(void **state)
{
    (void)state;
    struct mesh mesh;
    for (int64_t valence = 3; valence <= 40; valence++) {
        assert_int_equal(generate_bipyramid(&mesh, valence, NULL), 0);
        struct facts facts = closed_surface(valence + 2, 2 * valence, 2);
        assert_facts(&mesh, &facts);
    }
    assert_int_equal(generate_tetrahedron(&mesh, NULL), 0);
    struct facts facts = closed_surface(4, 4, 2);
    assert_facts(&mesh, &facts);
    assert_int_equal(generate_cube(&mesh, NULL), 0);
    assert_true(signed_volume(&mesh) == 1.0);
    facts = closed_surface(8, 12, 2);
    assert_facts(&mesh, &facts);
}

static void a_moebius_strip_has_one_side(void **state)
{
    (void)state;
    for (int64_t quads = 3; quads <= 20; quads++) {
        struct mesh mesh;
        assert_int_equal(generate_moebius(&mesh, quads, NULL), 0);
        struct facts facts = {.vertices = 2 * quads,
                              .triangles = 2 * quads,
                              .components = 1,
                              .boundary_edges = 2 * quads,
                              .boundary_loops = 1};
        assert_facts(&mesh, &facts);
    }
}

static void nonmanifold_surfaces_are_so_where_promised(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_two_cones(&mesh, 6, NULL), 0);
    struct facts cones = closed_surface(15, 24, 3);
    cones.nonmanifold_vertices = 1;
    assert_facts(&mesh, &cones);
    assert_int_equal(generate_two_cubes(&mesh, NULL), 0);
    struct facts cubes = closed_surface(14, 24, 3);
    cubes.nonmanifold_edges = 1;
    cubes.nonmanifold_vertices = 2;
    assert_facts(&mesh, &cubes);
    for (int64_t leaves = 3; leaves < 8; leaves++) {
        assert_int_equal(generate_book(&mesh, leaves, NULL), 0);
        struct facts book = open_disc(leaves + 2, leaves, 2 * leaves);
        book.nonmanifold_edges = 1;
        book.nonmanifold_vertices = 2;
        assert_facts(&mesh, &book);
    }
}

static void soups_share_nothing_and_follow_their_seed(void **state)
{
    (void)state;
    struct mesh a, b, c;
    assert_int_equal(generate_soup(&a, 40, 1, NULL), 0);
    assert_int_equal(generate_soup(&b, 40, 1, NULL), 0);
    assert_int_equal(generate_soup(&c, 40, 2, NULL), 0);
    assert_true(same_mesh(&a, &b));
    assert_false(same_mesh(&a, &c));
    mesh_release(&b);
    mesh_release(&c);
    struct facts facts = {.vertices = 120,
                          .triangles = 40,
                          .euler = 40,
                          .components = 40,
                          .boundary_edges = 120,
                          .boundary_loops = 40,
                          .is_orientable = true};
    assert_facts(&a, &facts);
    assert_int_equal(generate_soup(&a, 0, 1, NULL), 0);
    facts = (struct facts){.is_orientable = true};
    assert_facts(&a, &facts);
    assert_int_equal(generate_empty(&a, NULL), 0);
    assert_facts(&a, &facts);
}

static void needles_have_their_ratio(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_needles(&mesh, 30, 0.01, 3, NULL), 0);
    for (int64_t t = 0; t < mesh.triangle_count; t++) {
        float low = 1, high = -1, bottom = 1, top = -1;
        for (int corner = 0; corner < 3; corner++) {
            const float *p = mesh.positions + 3 * (int64_t)mesh.triangles[3 * t + corner];
            low = fminf(low, p[0]);
            high = fmaxf(high, p[0]);
            bottom = fminf(bottom, p[1]);
            top = fmaxf(top, p[1]);
        }
        float ratio = (top - bottom) / (high - low);
        assert_true(ratio > 0.008F && ratio < 0.0126F); /* bases keep 0.8 to 1.2 of their length */
    }
    mesh_release(&mesh);
}

/* A refusal leaves the empty mesh and names the argument. */
static void assert_refused(int result, struct mesh *mesh, struct error *err, const char *names)
{
    assert_int_equal(result, -1);
    assert_null(mesh->positions);
    assert_null(mesh->triangles);
    assert_int_equal(mesh->vertex_count, 0);
    assert_non_null(strstr(err->text, names));
    err->text[0] = '\0';
}

static void arguments_out_of_range_are_refused(void **state)
{
    (void)state;
    struct mesh m;
    struct error e = {0};
    assert_refused(generate_grid(&m, 0, 1, &e), &m, &e, "the number of rows is 0");
    assert_refused(generate_grid(&m, 1, -3, &e), &m, &e, "the number of columns is -3");
    assert_refused(generate_grid(&m, 1 << 20, 1 << 20, &e), &m, &e, "vertices");
    assert_refused(generate_uv_sphere(&m, 2, 4, &e), &m, &e, "meridians is 2");
    assert_refused(generate_uv_sphere(&m, 3, 0, &e), &m, &e, "parallels is 0");
    assert_refused(generate_icosphere(&m, 10, &e), &m, &e, "10 levels");
    assert_refused(generate_icosphere(&m, -1, &e), &m, &e, "-1 levels");
    assert_refused(generate_torus(&m, -1, 100, &e), &m, &e, "genus is -1");
    assert_refused(generate_torus(&m, 1, 0, &e), &m, &e, "0 triangles");
    assert_refused(generate_disc(&m, 0, 9, &e), &m, &e, "rings is 0");
    assert_refused(generate_disc(&m, 1, 2, &e), &m, &e, "sectors is 2");
    assert_refused(generate_fan(&m, 0, &e), &m, &e, "triangles is 0");
    assert_refused(generate_bipyramid(&m, 2, &e), &m, &e, "valence is 2");
    assert_refused(generate_moebius(&m, 2, &e), &m, &e, "quads is 2");
    assert_refused(generate_two_cones(&m, 2, &e), &m, &e, "2 sectors");
    assert_refused(generate_book(&m, 2, &e), &m, &e, "2 leaves");
    assert_refused(generate_soup(&m, -1, 0, &e), &m, &e, "triangles is -1");
    assert_refused(generate_needles(&m, 5, 0.0, 0, &e), &m, &e, "ratio is 0");
    assert_refused(generate_needles(&m, 5, NAN, 0, &e), &m, &e, "ratio is");
    assert_refused(generate_needles(&m, 0, 0.5, 0, &e), &m, &e, "triangles is 0");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(grids_are_open_discs),
        cmocka_unit_test(grid_vertices_stand_where_the_header_says),
        cmocka_unit_test(spheres_are_closed_of_genus_0),
        cmocka_unit_test(tori_have_their_genus),
        cmocka_unit_test(discs_and_fans_are_open_discs),
        cmocka_unit_test(small_solids_are_closed),
        cmocka_unit_test(a_moebius_strip_has_one_side),
        cmocka_unit_test(nonmanifold_surfaces_are_so_where_promised),
        cmocka_unit_test(soups_share_nothing_and_follow_their_seed),
        cmocka_unit_test(needles_have_their_ratio),
        cmocka_unit_test(arguments_out_of_range_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
