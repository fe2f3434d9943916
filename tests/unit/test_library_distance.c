/* Distances of points, triangles and surfaces: against fine sampling and all pairs. */
#include "graders/library/distance.h"
#include "reference/base/random.h"
#include "reference/mesh/generate.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct surface_mesh surface_of(const struct mesh *mesh)
{
    return (struct surface_mesh){mesh->positions, mesh->triangles, mesh->vertex_count,
                                 mesh->triangle_count};
}

static double length(const double p[3], const double q[3])
{
    return sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                (p[2] - q[2]) * (p[2] - q[2]));
}

static void known_distances(void **state)
{
    (void)state;
    const double a[3] = {0, 0, 0}, b[3] = {4, 0, 0}, c[3] = {0, 4, 0};
    static const struct {
        double p[3], distance, nearest[3];
    } trials[] = {{{1, 1, 2}, 2, {1, 1, 0}},
                  {{1, 1, 0}, 0, {1, 1, 0}},
                  {{2, -3, 4}, 5, {2, 0, 0}},
                  {{-3, -4, 0}, 5, {0, 0, 0}},
                  {{6, 0, 0}, 2, {4, 0, 0}},
                  {{-2, 3, 0}, 2, {0, 3, 0}},
                  {{3, 3, 0}, 1.4142135623730951, {2, 2, 0}}};
    for (size_t i = 0; i < sizeof trials / sizeof *trials; i++) {
        double nearest[3];
        double distance = distance_point_triangle(trials[i].p, a, b, c, nearest);
        assert_true(fabs(distance - trials[i].distance) < 1e-15);
        assert_true(length(nearest, trials[i].nearest) < 1e-15);
    }
    assert_true(distance_point_triangle(a, b, b, b, NULL) == 4);
}

/* A point of a triangle of an answer is never nearer, and some of a fine lattice nearly as near. */
static void distances_are_as_sampled(void **state)
{
    (void)state;
    enum { FINE = 60 };
    struct random rng;
    random_init(&rng, 91);
    for (int trial = 0; trial < 300; trial++) {
        double corner[3][3], p[3], sampled = INFINITY, longest = 0;
        bool is_flat = random_below(&rng, 5) == 0;
        for (int axis = 0; axis < 3; axis++) {
            for (int c = 0; c < 3; c++)
                corner[c][axis] = random_real(&rng) * (axis == 1 && trial % 3 == 0 ? 1e-7 : 1);
            if (is_flat)
                corner[2][axis] = 0.25 * corner[0][axis] + 0.75 * corner[1][axis];
            p[axis] = 2 * random_real(&rng) - 0.5;
        }
        for (int i = 0; i <= FINE; i++)
            for (int j = 0; i + j <= FINE; j++) {
                double q[3];
                for (int axis = 0; axis < 3; axis++)
                    q[axis] = (i * corner[0][axis] + j * corner[1][axis] +
                               (FINE - i - j) * corner[2][axis]) /
                              FINE;
                sampled = fmin(sampled, length(p, q));
            }
        for (int c = 0; c < 3; c++)
            longest = fmax(longest, length(corner[c], corner[(c + 1) % 3]));
        double nearest[3];
        double distance = distance_point_triangle(p, corner[0], corner[1], corner[2], nearest);
        assert_true(distance <= sampled + 1e-12);
        assert_true(distance >= sampled - 2 * longest / FINE);
        assert_true(fabs(length(p, nearest) - distance) < 1e-12);
    }
}

static double corner_at(const struct surface_mesh *mesh, int64_t corner, int axis)
{
    return (double)mesh->positions[3 * (int64_t)mesh->triangles[corner] + axis];
}

static double nearest_slowly(const struct surface_mesh *mesh, const double p[3])
{
    double best = INFINITY;
    for (int64_t t = 0; t < mesh->triangle_count; t++) {
        double corner[3][3];
        bool is_fine = true;
        for (int c = 0; c < 3; c++) {
            int32_t v = mesh->triangles[3 * t + c];
            is_fine = is_fine && v >= 0 && v < mesh->vertex_count;
            for (int axis = 0; is_fine && axis < 3; axis++) {
                corner[c][axis] = corner_at(mesh, 3 * t + c, axis);
                is_fine = isfinite(corner[c][axis]);
            }
        }
        if (is_fine)
            best = fmin(best, distance_point_triangle(p, corner[0], corner[1], corner[2], NULL));
    }
    return best;
}

/* Triangles that may be anything, most of them near the origin. */
static struct mesh random_triangles(struct random *rng, int32_t most)
{
    static const float wild[] = {NAN, INFINITY, 1e4F, -1e3F, 0};
    struct mesh mesh;
    assert_int_equal(generate_soup(&mesh, 1 + (int64_t)random_below(rng, (uint64_t)most),
                                   random_next(rng), NULL),
                     0);
    for (int damage = (int)random_below(rng, 4); damage > 0; damage--) {
        mesh.positions[random_below(rng, (uint64_t)(3 * mesh.vertex_count))] =
            wild[random_below(rng, 5)];
        mesh.triangles[random_below(rng, (uint64_t)(3 * mesh.triangle_count))] =
            random_below(rng, 3) ? (int32_t)random_below(rng, (uint64_t)mesh.vertex_count)
                                 : (int32_t)random_next(rng);
    }
    return mesh;
}

static void the_tree_finds_what_all_pairs_find(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 92);
    const double low[3] = {-1, -1, -1}, high[3] = {1, 1, 1};
    for (int trial = 0; trial < 1500; trial++) {
        struct mesh mesh = random_triangles(&rng, 60);
        struct surface_mesh surface = surface_of(&mesh);
        struct triangle_tree tree;
        assert_int_equal(triangle_tree_build(&tree, &surface, low, high, NULL), 0);
        for (int ask = 0; ask < 20; ask++) {
            double p[3], scale = ask % 5 ? 1 : 1e6;
            int32_t triangle = -1;
            for (int axis = 0; axis < 3; axis++)
                p[axis] = scale * (2 * random_real(&rng) - 1);
            double right = nearest_slowly(&surface, p);
            double found = triangle_tree_distance(&tree, p, 0, &triangle);
            assert_true(found == right || fabs(found - right) <= 1e-9);
            assert_int_equal(triangle >= 0, isfinite(right));
            found = triangle_tree_distance(&tree, p, 1.5 * right, &triangle);
            assert_true(right == found || (found >= right - 1e-9 && found <= 1.5 * right + 1e-9));
        }
        triangle_tree_release(&tree);
        triangle_tree_release(&tree);
        mesh_release(&mesh);
    }
}

/* The farthest of the points of one surface, by all pairs. */
static double farthest_slowly(const struct surface_mesh *from, const struct surface_mesh *to)
{
    double farthest = 0;
    for (int64_t t = 0; t < from->triangle_count; t++)
        for (int i = 0; i < 13; i++) {
            double weight[3] = {i == 10, i == 11, i == 12}, p[3] = {0, 0, 0};
            int row = i < 1 ? 0 : i < 3 ? 1 : i < 6 ? 2 : 3, place = i - row * (row + 1) / 2;
            if (i < 10) {
                weight[0] = (3 - row + 1 / 3.0) / 4;
                weight[1] = (place + 1 / 3.0) / 4;
                weight[2] = 1 - weight[0] - weight[1];
            }
            for (int c = 0; c < 3; c++)
                for (int axis = 0; axis < 3; axis++)
                    p[axis] += weight[c] * corner_at(from, 3 * t + c, axis);
            farthest = fmax(farthest, nearest_slowly(to, p));
        }
    return farthest;
}

static void surfaces_are_as_far_as_all_pairs_say(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 93);
    for (int trial = 0; trial < 150; trial++) {
        struct mesh a, b;
        assert_int_equal(
            generate_soup(&a, 1 + (int64_t)random_below(&rng, 20), random_next(&rng), NULL), 0);
        assert_int_equal(generate_icosphere(&b, (int)random_below(&rng, 2), NULL), 0);
        struct surface_mesh answer = surface_of(&a), right = surface_of(&b);
        struct surface_distance d;
        assert_int_equal(surface_distance_find(&answer, &right, &d, NULL), 0);
        double there = farthest_slowly(&answer, &right), back = farthest_slowly(&right, &answer);
        assert_true(d.from_answer.distance <= there + 1e-12);
        assert_true(d.from_answer.distance >= there * 0.9989);
        assert_true(d.from_right.distance <= back + 1e-12);
        assert_true(d.from_right.distance >= back * 0.9989);
        assert_true(d.hausdorff == fmax(d.from_answer.distance, d.from_right.distance));
        assert_true(fabs(nearest_slowly(&right, d.from_answer.point) - d.from_answer.distance) <
                    1e-12);
        mesh_release(&a);
        mesh_release(&b);
    }
}

static void a_coarse_sphere_lies_inside(void **state)
{
    (void)state;
    struct mesh fine, coarse;
    assert_int_equal(generate_icosphere(&fine, 4, NULL), 0);
    assert_int_equal(generate_icosphere(&coarse, 2, NULL), 0);
    struct surface_mesh right = surface_of(&fine), answer = surface_of(&coarse);
    struct surface_distance d;
    assert_int_equal(surface_distance_find(&answer, &right, &d, NULL), 0);
    /* Radius 1/2, 320 triangles: the sag is 4.84 R / F for equal ones. */
    assert_true(d.hausdorff > 0.5 * 4.84 / 320 && d.hausdorff < 2 * 0.5 * 4.84 / 320);
    assert_int_equal(surface_distance_find(&right, &right, &d, NULL), 0);
    assert_true(d.hausdorff < 1e-15);
    mesh_release(&fine);
    mesh_release(&coarse);
}

/* As near to its middle as to any: all triangles of an answer in one place, and far away. */
static void shrunk_answers_end(void **state)
{
    (void)state;
    struct mesh fine, answer;
    assert_int_equal(generate_icosphere(&fine, 4, NULL), 0);
    assert_int_equal(mesh_copy(&answer, &fine, NULL), 0);
    struct surface_mesh right = surface_of(&fine), shrunk = surface_of(&answer);
    struct surface_distance d;
    change_scale(&answer, 1e-6F);
    assert_int_equal(surface_distance_find(&shrunk, &right, &d, NULL), 0);
    assert_true(fabs(d.hausdorff - 0.5) < 2e-3);
    for (int i = 0; i < 30; i++) /* boxes and distances of such corners are only rough */
        answer.positions[97 * i] = i % 2 ? 3e38F : -1e30F;
    assert_int_equal(surface_distance_find(&shrunk, &right, &d, NULL), 0);
    assert_true(d.hausdorff > 1e20);
    memcpy(answer.positions, fine.positions, 3 * (size_t)fine.vertex_count * sizeof(float));
    change_scale(&answer, 1e-6F);
    change_translate(&answer, 1e6F, 0, 0);
    assert_int_equal(surface_distance_find(&shrunk, &right, &d, NULL), 0);
    assert_true(fabs(d.hausdorff - 1e6) < 2e3);
    mesh_release(&fine);
    mesh_release(&answer);
}

static void bad_answers_are_infinitely_far(void **state)
{
    (void)state;
    struct mesh mesh, copy;
    assert_int_equal(generate_cube(&mesh, NULL), 0);
    assert_int_equal(mesh_copy(&copy, &mesh, NULL), 0);
    struct surface_mesh right = surface_of(&mesh), answer = surface_of(&copy);
    struct surface_mesh none = {NULL, NULL, 0, 0};
    struct surface_distance d;
    struct error err = {0};
    assert_int_equal(surface_distance_find(&none, &right, &d, NULL), 0);
    assert_true(isinf(d.hausdorff));
    assert_int_equal(surface_distance_find(&none, &none, &d, NULL), 0);
    assert_true(d.hausdorff == 0);
    copy.triangles[7] = INT32_MAX;
    assert_int_equal(surface_distance_find(&answer, &right, &d, NULL), 0);
    assert_true(isinf(d.hausdorff));
    assert_int_equal(d.bad_corner, 7);
    assert_int_equal(surface_distance_find(&right, &answer, &d, &err), -1);
    assert_true(err.text[0]);
    copy.triangles[7] = mesh.triangles[7];
    copy.positions[0] = NAN;
    assert_int_equal(surface_distance_find(&answer, &right, &d, NULL), 0);
    assert_true(isinf(d.hausdorff));
    none.triangle_count = -1;
    assert_int_equal(surface_distance_find(&none, &right, &d, NULL), -1);
    mesh_release(&mesh);
    mesh_release(&copy);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_distances),
        cmocka_unit_test(distances_are_as_sampled),
        cmocka_unit_test(the_tree_finds_what_all_pairs_find),
        cmocka_unit_test(surfaces_are_as_far_as_all_pairs_say),
        cmocka_unit_test(a_coarse_sphere_lies_inside),
        cmocka_unit_test(shrunk_answers_end),
        cmocka_unit_test(bad_answers_are_infinitely_far),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
