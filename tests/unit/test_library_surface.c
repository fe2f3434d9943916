/* Meshes as surfaces, and the nearest of many points: against slow searches, with damaged meshes.
 */
#include "graders/library/near_points.h"
#include "graders/library/surface.h"
#include "reference/base/random.h"
#include "reference/mesh/generate.h"
#include "tests/unit/mesh_corpus.h"

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

/* -- points ----------------------------------------------------------------------------------- */

static int32_t nearest_slowly(const float *positions, int32_t count, const float p[3], double reach)
{
    int32_t best = -1;
    double least = INFINITY;
    for (int32_t i = 0; i < count; i++) {
        double distance = near_points_distance(p, positions + 3 * (int64_t)i);
        if (distance <= reach && distance < least) {
            least = distance;
            best = i;
        }
    }
    return best;
}

static void the_nearest_point_is_found(void **state)
{
    (void)state;
    enum { MOST = 60 };
    static const float wild[] = {NAN, INFINITY, -INFINITY, 3e38F, 0};
    struct random rng;
    random_init(&rng, 61);
    for (int trial = 0; trial < 3000; trial++) {
        float positions[3 * MOST];
        int32_t count = (int32_t)random_below(&rng, MOST + 1);
        bool is_lattice = random_below(&rng, 2), is_flat = random_below(&rng, 3) == 0;
        for (int i = 0; i < 3 * count; i++) {
            positions[i] = is_lattice ? (float)random_below(&rng, 4) : random_float(&rng, -1, 4);
            if (is_flat && i % 3 == 2)
                positions[i] = 1;
        }
        struct near_points tree;
        assert_int_equal(near_points_build(&tree, positions, count, NULL), 0);
        for (int ask = 0; ask < 20; ask++) {
            float p[3];
            for (int i = 0; i < 3; i++)
                p[i] = is_lattice ? (float)random_below(&rng, 9) / 2 : random_float(&rng, -1, 4);
            if (random_below(&rng, 20) == 0)
                p[random_below(&rng, 3)] = wild[random_below(&rng, 5)];
            double reach = random_below(&rng, 4) ? (double)random_below(&rng, 5) / 2 : 0;
            assert_int_equal(near_points_find(&tree, p, reach),
                             nearest_slowly(positions, count, p, reach));
        }
        near_points_release(&tree);
        near_points_release(&tree);
    }
}

/* -- surfaces --------------------------------------------------------------------------------- */

/* A renumbered copy; origin[new] = old. */
static struct mesh renumbered(const struct mesh *mesh, int32_t *origin, struct random *rng)
{
    struct mesh copy;
    int32_t number[400];
    assert_true(mesh->vertex_count <= 400);
    assert_int_equal(mesh_copy(&copy, mesh, NULL), 0);
    random_permutation(rng, origin, mesh->vertex_count);
    for (int32_t v = 0; v < mesh->vertex_count; v++) {
        number[origin[v]] = v;
        memcpy(copy.positions + 3 * v, mesh->positions + 3 * origin[v], 3 * sizeof(float));
    }
    for (int64_t t = 0; t < mesh->triangle_count; t++) {
        int64_t from = (t * 7 + 3) % mesh->triangle_count;
        if (mesh->triangle_count % 7 == 0)
            from = t;
        for (int c = 0; c < 3; c++)
            copy.triangles[3 * t + c] = number[mesh->triangles[3 * from + (c + t) % 3]];
    }
    return copy;
}

static bool has_coincident_vertices(const struct mesh *mesh)
{
    for (int32_t v = 0; v < mesh->vertex_count; v++)
        for (int32_t u = 0; u < v; u++)
            if (near_points_distance(mesh->positions + 3 * v, mesh->positions + 3 * u) < 1e-2)
                return true;
    return false;
}

static struct surface_fault compare_places(const struct mesh *answer, const struct mesh *right)
{
    struct surface_mesh a = surface_of(answer), b = surface_of(right);
    struct surface_fault fault;
    assert_int_equal(surface_compare_places(&a, &b, 1e-4, 4e-3, &fault, NULL), 0);
    return fault;
}

static void renumbered_meshes_are_the_same(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 62);
    int compared = 0;
    for (int i = 0; i < CORPUS_GENERATED + 60; i++) {
        struct mesh mesh = corpus_mesh(i);
        int32_t origin[400];
        struct mesh copy = renumbered(&mesh, origin, &rng);
        struct surface_mesh answer = surface_of(&copy), right = surface_of(&mesh);
        struct surface_fault fault;
        assert_int_equal(surface_compare_mapped(&answer, origin, &right, &fault, NULL), 0);
        assert_null(surface_fault_cause(&fault));
        surface_fault_release(&fault);
        surface_fault_release(&fault);
        if (!has_coincident_vertices(&mesh)) {
            compared++;
            for (int32_t c = 0; c < 3 * copy.vertex_count; c++)
                copy.positions[c] += random_float(&rng, -5e-5F, 5e-5F);
            fault = compare_places(&copy, &mesh);
            assert_null(surface_fault_cause(&fault));
            for (int32_t v = 0; v < copy.vertex_count; v++)
                assert_int_equal(fault.right_of[v], origin[v]);
            surface_fault_release(&fault);
        }
        mesh_release(&copy);
        mesh_release(&mesh);
    }
    assert_true(compared > 20);
}

static void each_damage_is_named(void **state)
{
    (void)state;
    struct mesh right, answer;
    assert_int_equal(generate_icosphere(&right, 1, NULL), 0);
    assert_int_equal(mesh_copy(&answer, &right, NULL), 0);
    int32_t *t = answer.triangles + 3 * 7;
    int32_t kept[3] = {t[0], t[1], t[2]};
    t[0] = kept[1];
    t[1] = kept[0];
    struct surface_fault fault = compare_places(&answer, &right);
    assert_ptr_equal(surface_fault_cause(&fault), &surface_flipped);
    assert_int_equal(fault.triangles.reversed, 7);
    surface_fault_release(&fault);
    memcpy(t, answer.triangles, sizeof kept);
    fault = compare_places(&answer, &right);
    assert_ptr_equal(surface_fault_cause(&fault), &surface_repeated);
    assert_int_equal(fault.triangles.missing, 7);
    surface_fault_release(&fault);
    memcpy(t, kept, sizeof kept);
    t[2] = INT32_MIN;
    fault = compare_places(&answer, &right);
    assert_ptr_equal(surface_fault_cause(&fault), &surface_bad_index);
    assert_int_equal(fault.bad_corner, 23);
    surface_fault_release(&fault);
    memcpy(t, kept, sizeof kept);
    answer.positions[3 * 9] += 2e-3F;
    fault = compare_places(&answer, &right);
    assert_ptr_equal(surface_fault_cause(&fault), &surface_stray);
    assert_int_equal(fault.stray, 9);
    assert_true(fabs(fault.stray_distance - 2e-3) < 1e-6);
    assert_int_equal(fault.right_of[9], 9);
    surface_fault_release(&fault);
    answer.positions[3 * 9] = NAN;
    fault = compare_places(&answer, &right);
    assert_true(isinf(fault.stray_distance));
    assert_int_equal(fault.lost, 9);
    surface_fault_release(&fault);
    memcpy(answer.positions + 3 * 9, answer.positions + 3 * 4, 3 * sizeof(float));
    fault = compare_places(&answer, &right);
    assert_ptr_equal(surface_fault_cause(&fault), &surface_doubled);
    assert_int_equal(fault.doubled, 9);
    assert_int_equal(fault.doubled_of, 4);
    surface_fault_release(&fault);
    mesh_release(&answer);
    mesh_release(&right);
}

/* -- against a slow comparison ---------------------------------------------------------------- */

enum { VERTICES = 5, MOST_TRIANGLES = 8 };

static bool same_triangle(const int32_t *a, const int32_t *b, bool backwards)
{
    for (int shift = 0; shift < 3; shift++)
        if (a[0] == b[shift] && a[1] == b[(shift + (backwards ? 2 : 1)) % 3] &&
            a[2] == b[(shift + (backwards ? 1 : 2)) % 3])
            return true;
    return false;
}

/* How many right triangles a corner table has, as often as they are there. */
static int64_t matched_slowly(const int32_t *answer, int answer_count, const int32_t *right,
                              int right_count)
{
    bool used[MOST_TRIANGLES] = {0};
    int64_t matched = 0;
    for (int i = 0; i < answer_count; i++)
        for (int j = 0; j < right_count; j++)
            if (!used[j] && same_triangle(answer + 3 * i, right + 3 * j, false)) {
                used[j] = true;
                matched++;
                break;
            }
    return matched;
}

static void random_maps_are_told_as_slowly(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 63);
    for (int trial = 0; trial < 20000; trial++) {
        int32_t answer[3 * MOST_TRIANGLES], right[3 * MOST_TRIANGLES], mapped[3 * MOST_TRIANGLES];
        int32_t origin[VERTICES], bad = 0, stray = 0, lost = 0, doubled = 0;
        int answer_count = (int)random_below(&rng, MOST_TRIANGLES + 1);
        int right_count = (int)random_below(&rng, MOST_TRIANGLES + 1);
        int seen[VERTICES] = {0};
        for (int v = 0; v < VERTICES; v++) {
            origin[v] = random_below(&rng, 8) ? (int32_t)random_below(&rng, VERTICES)
                                              : (int32_t)random_next(&rng);
            bool is_right = origin[v] >= 0 && origin[v] < VERTICES;
            stray += !is_right;
            if (is_right)
                doubled += seen[origin[v]]++ > 0;
        }
        for (int v = 0; v < VERTICES; v++)
            lost += !seen[v];
        for (int c = 0; c < 3 * right_count; c++)
            right[c] = (int32_t)random_below(&rng, 4);
        for (int c = 0; c < 3 * answer_count; c++) {
            answer[c] = random_below(&rng, 20) ? (int32_t)random_below(&rng, VERTICES)
                                               : (int32_t)random_next(&rng);
            bool is_vertex = answer[c] >= 0 && answer[c] < VERTICES;
            mapped[c] = is_vertex ? origin[answer[c]] : -1;
            bad += !is_vertex;
        }
        struct surface_mesh a = {NULL, answer, VERTICES, answer_count};
        struct surface_mesh b = {NULL, right, VERTICES, right_count};
        struct surface_fault fault;
        assert_int_equal(surface_compare_mapped(&a, origin, &b, &fault, NULL), 0);
        assert_int_equal(fault.bad_corner_count, bad);
        assert_int_equal(fault.stray_count, stray);
        assert_int_equal(fault.lost_count, lost);
        assert_int_equal(fault.doubled_count, doubled);
        int64_t matched = matched_slowly(mapped, answer_count, right, right_count);
        const struct set_fault *t = &fault.triangles;
        assert_int_equal(t->missing_count + t->reversed_count, right_count - matched);
        assert_int_equal(t->extra_count + t->repeated_count + t->reversed_count,
                         answer_count - matched);
        if (t->reversed >= 0)
            assert_true(
                same_triangle(mapped + 3 * t->reversed, right + 3 * t->reversed_right, true));
        surface_fault_release(&fault);
    }
}

static void impossible_counts_are_our_error(void **state)
{
    (void)state;
    struct surface_mesh bad = {NULL, NULL, 0, -1}, none = {NULL, NULL, 0, 0};
    struct surface_fault fault;
    struct error err = {0};
    assert_int_equal(surface_compare_places(&bad, &none, 0, 0, &fault, &err), -1);
    assert_true(err.text[0]);
    assert_int_equal(surface_compare_places(&none, &none, 0, 0, &fault, NULL), 0);
    assert_null(surface_fault_cause(&fault));
    surface_fault_release(&fault);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_nearest_point_is_found),
        cmocka_unit_test(renumbered_meshes_are_the_same),
        cmocka_unit_test(each_damage_is_named),
        cmocka_unit_test(random_maps_are_told_as_slowly),
        cmocka_unit_test(impossible_counts_are_our_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
