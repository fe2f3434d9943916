/* The inputs that judges declare: every recipe makes what its header says. */
#include "graders/library/judge.h"
#include "reference/mesh/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* ------------------------------------------------------------------------------------ families */

static const struct size_family families[] = {
    {"sphere", FAMILY_SPHERE, SCRAMBLED},
    {"grid", FAMILY_GRID, FLIPPED | SCRAMBLED},
    {"torus", FAMILY_TORUS, ADVERSARIAL},
    {"strip", FAMILY_STRIP, 0},
    {"windows", FAMILY_WINDOWS, SCRAMBLED},
    {"separate", FAMILY_SEPARATE, SCRAMBLED},
    {"fan", FAMILY_FAN, 0},
    {"bipyramid", FAMILY_BIPYRAMID, SCRAMBLED},
};

static bool is_closed(const struct size_family *family)
{
    return family->shape == FAMILY_SPHERE || family->shape == FAMILY_TORUS ||
           family->shape == FAMILY_BIPYRAMID;
}

/* Sides that no other side runs against. */
static int64_t boundary_sides(const struct mesh *mesh)
{
    struct edge_list list;
    int64_t count = 0;
    assert_int_equal(edge_list_init(&list, mesh, NULL), 0);
    for (int64_t e = 0; e < list.edge_count; e++) {
        assert_in_range(edge_use_count(&list.edges[e]), 1, 2);
        count += edge_use_count(&list.edges[e]) == 1;
    }
    edge_list_release(&list);
    return count;
}

static void families_have_their_size(void **state)
{
    (void)state;
    static const int64_t sizes[] = {32, 33, 64, 100, 128, 129, 250, 1000, 1001, 4096, 5003};
    for (size_t f = 0; f < sizeof families / sizeof *families; f++)
        for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
            const struct size_family *family = &families[f];
            int64_t wanted = is_closed(family) ? sizes[i] / 2 * 2 : sizes[i];
            struct mesh mesh;
            struct error err = {0};
            if (family_make(family, sizes[i], 7, &mesh, &err) != 0)
                fail_msg("%s of %d: %s", family->name, (int)sizes[i], err.text);
            if (mesh.triangle_count != wanted)
                fail_msg("%s of %d has %d triangles", family->name, (int)sizes[i],
                         mesh.triangle_count);
            assert_int_equal(mesh_check(&mesh, &err), 0);
            assert_int_equal(boundary_sides(&mesh) == 0, is_closed(family));
            mesh_release(&mesh);
        }
}

/* ------------------------------------------------------------------------------------ polygons */

static const struct mesh_recipe closed_shapes[] = {
    {SHAPE_QUAD_CUBE},
    {SHAPE_QUAD_TORUS, .rows = 4, .columns = 5, .changes = SCRAMBLED},
    {SHAPE_PRISM, .count = 7, .changes = SCRAMBLED | WITH_COMPONENTS},
    {SHAPE_COURSE_PRISM, .changes = WITH_ISOLATED},
    {SHAPE_ICO, .levels = 1, .changes = SCRAMBLED | HIGH_NUMBERS},
    {SHAPE_TETRAHEDRON, .changes = REVERSED | WITH_COMPONENTS},
};

/* How often a directed side occurs. */
static int64_t side_count(const struct polygon_mesh *mesh, int32_t from, int32_t to)
{
    int64_t found = 0;
    for (int32_t f = 0; f < mesh->face_count; f++)
        for (int32_t c = mesh->first_corner[f]; c < mesh->first_corner[f + 1]; c++) {
            int32_t next = c + 1 < mesh->first_corner[f + 1] ? c + 1 : mesh->first_corner[f];
            found += mesh->corners[c] == from && mesh->corners[next] == to;
        }
    return found;
}

static void closed_polygons_are_closed_and_coherent(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof closed_shapes / sizeof *closed_shapes; i++) {
        struct polygon_mesh mesh;
        struct error err = {0};
        if (polygon_mesh_make(&closed_shapes[i], 5, NULL, &mesh, &err) != 0)
            fail_msg("shape %d: %s", (int)i, err.text);
        for (int32_t f = 0; f < mesh.face_count; f++)
            for (int32_t c = mesh.first_corner[f]; c < mesh.first_corner[f + 1]; c++) {
                int32_t next = c + 1 < mesh.first_corner[f + 1] ? c + 1 : mesh.first_corner[f];
                int32_t a = mesh.corners[c], b = mesh.corners[next];
                assert_in_range(a, 0, mesh.vertex_count - 1);
                assert_int_equal(side_count(&mesh, a, b), 1);
                assert_int_equal(side_count(&mesh, b, a), 1);
            }
        polygon_mesh_release(&mesh);
    }
}

static void quads_have_their_size(void **state)
{
    (void)state;
    const struct size_family quads = {"quads", FAMILY_QUADS, SCRAMBLED};
    struct polygon_mesh mesh;
    assert_int_equal(polygon_mesh_make_sized(&quads, 1000, 3, &mesh, NULL), 0);
    assert_in_range(mesh.first_corner[mesh.face_count], 960, 1000);
    polygon_mesh_release(&mesh);
    assert_int_equal(polygon_mesh_make_sized(&families[0], 999, 3, &mesh, NULL), 0);
    assert_in_range(mesh.first_corner[mesh.face_count], 993, 999);
    polygon_mesh_release(&mesh);
}

static void windows_are_loops_apart(void **state)
{
    (void)state;
    const struct mesh_recipe recipe = {SHAPE_ICO, .levels = 3, .changes = WITH_WINDOWS | SCRAMBLED};
    struct mesh whole, cut;
    assert_int_equal(
        recipe_make(&(struct mesh_recipe){SHAPE_ICO, .levels = 3}, 9, NULL, &whole, NULL), 0);
    assert_int_equal(recipe_make(&recipe, 9, NULL, &cut, NULL), 0);
    int64_t removed = whole.triangle_count - cut.triangle_count;
    assert_true(removed > 10);
    assert_int_equal(boundary_sides(&cut), 3 * removed);
    mesh_release(&whole);
    mesh_release(&cut);
}

/* --------------------------------------------------------------------------------------- lines */

static struct line_view make_line(const struct line_recipe *recipe, struct writer *writer)
{
    *writer = writer_growing();
    assert_int_equal(line_write(recipe, 11, writer, NULL), 0);
    struct reader reader = reader_of(writer->bytes, writer->count);
    struct line_view view = line_read(&reader);
    assert_false(reader.failed);
    assert_int_equal(view.point_count, recipe->count);
    return view;
}

/* Twice the area of a triangle of three points of the plane; exact. */
static double turn(const float *a, const float *b, const float *c)
{
    return ((double)b[0] - (double)a[0]) * ((double)c[1] - (double)a[1]) -
           ((double)b[1] - (double)a[1]) * ((double)c[0] - (double)a[0]);
}

static bool on_segment(const float *a, const float *b, const float *p)
{
    return turn(a, b, p) == 0 && fminf(a[0], b[0]) <= p[0] && p[0] <= fmaxf(a[0], b[0]) &&
           fminf(a[1], b[1]) <= p[1] && p[1] <= fmaxf(a[1], b[1]);
}

static bool touch(const float *a, const float *b, const float *c, const float *d)
{
    double abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
    if (((abc > 0 && abd < 0) || (abc < 0 && abd > 0)) &&
        ((cda > 0 && cdb < 0) || (cda < 0 && cdb > 0)))
        return true;
    return on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) || on_segment(c, d, b);
}

static void polygons_are_simple_and_turn_left(void **state)
{
    (void)state;
    static const int32_t counts[] = {4, 8, 12, 20, 40, 64};
    for (enum line_shape shape = LINE_CONVEX; shape <= LINE_COLLINEAR; shape++)
        for (size_t k = 0; k < sizeof counts / sizeof *counts; k++) {
            struct writer writer;
            const struct line_recipe recipe = {shape, .count = counts[k], .scrambled = true};
            if (shape == LINE_SPIRAL && counts[k] < 20)
                continue; /* too few points to wind twice */
            struct line_view v = make_line(&recipe, &writer);
            int32_t n = v.point_count;
            double area = 0;
            for (int32_t i = 0; i < n; i++) {
                const float *a = v.points + 2 * i, *b = v.points + 2 * ((i + 1) % n);
                area += (double)a[0] * (double)b[1] - (double)b[0] * (double)a[1];
                for (int32_t j = i + 2; j < n - (i == 0); j++)
                    if (touch(a, b, v.points + 2 * j, v.points + 2 * ((j + 1) % n)))
                        fail_msg("shape %d of %d: sides %d and %d touch", (int)shape, n, i, j);
            }
            if (!(area > 0))
                fail_msg("shape %d of %d turns right", (int)shape, n);
            writer_release(&writer);
        }
}

static void points_differ(void **state)
{
    (void)state;
    static const enum line_shape shapes[] = {POINTS_RANDOM, POINTS_GRID, POINTS_CLUSTERS,
                                             POINTS_ON_LINE, LINE_HELIX};
    for (size_t s = 0; s < sizeof shapes / sizeof *shapes; s++) {
        struct writer writer;
        const struct line_recipe recipe = {shapes[s], .count = 100, .scrambled = true};
        struct line_view v = make_line(&recipe, &writer);
        size_t bytes = sizeof(float) * (size_t)v.dimension;
        for (int32_t i = 0; i < v.point_count; i++)
            for (int32_t j = 0; j < i; j++)
                assert_memory_not_equal(v.points + v.dimension * i, v.points + v.dimension * j,
                                        bytes);
        writer_release(&writer);
    }
}

/* -------------------------------------------------------------------------------------- fields */

static void volumes_have_an_inside_and_an_outside(void **state)
{
    (void)state;
    for (enum field_shape shape = FIELD_SPHERE; shape <= FIELD_NOISE; shape++) {
        const struct field_recipe recipe = {shape, 12, 13, 14};
        struct writer writer = writer_growing();
        assert_int_equal(field_write(&recipe, 3, &writer, NULL), 0);
        struct reader reader = reader_of(writer.bytes, writer.count);
        struct field_view view = field_read(&reader);
        int64_t inside = 0;
        assert_int_equal(view.sample_count, 12 * 13 * 14);
        for (int64_t i = 0; i < view.sample_count; i++)
            inside += view.samples[i] < 0;
        if (shape == FIELD_OUTSIDE)
            assert_int_equal(inside, 0);
        else
            assert_in_range(inside, 1, view.sample_count - 1);
        writer_release(&writer);
    }
    struct writer writer = writer_growing();
    struct error err = {0};
    const struct field_recipe no_volume = {FIELD_SPHERE, 12, 13, 0};
    assert_int_equal(field_write(&no_volume, 3, &writer, &err), -1);
    writer_release(&writer);
}

/* A soup has the corners of its mesh, triangle by triangle; odd numbers of them too. */
static void soups_have_the_corners_of_their_mesh(void **state)
{
    (void)state;
    for (int32_t rows = 1; rows < 40; rows += 6) {
        struct mesh mesh;
        const struct mesh_recipe recipe = {SHAPE_GRID, .rows = rows, .columns = 11,
                                           .changes = WITH_HOLES};
        struct writer writer = writer_growing();
        assert_int_equal(recipe_make(&recipe, 1, NULL, &mesh, NULL), 0);
        assert_int_equal(soup_input_write(&mesh, &writer, NULL), 0);
        struct reader reader = reader_of(writer.bytes, writer.count);
        struct soup_view soup = soup_input_read(&reader);
        assert_false(reader.failed);
        assert_int_equal(reader.at, writer.count);
        assert_int_equal(soup.triangle_count, mesh.triangle_count);
        for (int64_t i = 0; i < 3 * (int64_t)mesh.triangle_count; i++)
            assert_memory_equal(soup.corners + 3 * i,
                                mesh.positions + 3 * (int64_t)mesh.triangles[i], 3 * sizeof(float));
        writer_release(&writer);
        mesh_release(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(families_have_their_size),
        cmocka_unit_test(closed_polygons_are_closed_and_coherent),
        cmocka_unit_test(quads_have_their_size),
        cmocka_unit_test(windows_are_loops_apart),
        cmocka_unit_test(polygons_are_simple_and_turn_left),
        cmocka_unit_test(points_differ),
        cmocka_unit_test(volumes_have_an_inside_and_an_outside),
        cmocka_unit_test(soups_have_the_corners_of_their_mesh),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
