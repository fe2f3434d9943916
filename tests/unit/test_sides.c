/* Twins and fans: what they are, what is refused and how it is named, and long buckets. */
#include "reference/mesh/generate.h"
#include "reference/representation/sides.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static int refusal(const int32_t *corners, const int32_t *starts, int32_t vertex_count,
                   int32_t face_count, struct error *err)
{
    const struct polygons polygons = {corners, starts, vertex_count, face_count};
    int32_t twin[64], fan[64];
    *err = (struct error){0};
    return sides_match(&polygons, twin, err) || sides_fans(&polygons, twin, fan, err) ? -1 : 0;
}

static void what_is_refused_is_named(void **state)
{
    (void)state;
    struct error err;
    const int32_t degenerate[6] = {0, 1, 2, 3, 4, 3};
    assert_int_equal(refusal(degenerate, NULL, 5, 2, &err), -1);
    assert_string_equal(err.text, "face 1 is degenerate: it names vertex 3 twice");
    const int32_t book[9] = {0, 1, 2, 1, 0, 3, 0, 1, 4};
    assert_int_equal(refusal(book, NULL, 5, 3, &err), -1);
    assert_string_equal(err.text, "edge {0, 1} is non-manifold: it has 3 faces");
    const int32_t alike[6] = {0, 1, 2, 3, 1, 2};
    assert_int_equal(refusal(alike, NULL, 4, 2, &err), -1);
    assert_string_equal(err.text,
                        "edge {1, 2}: faces 0 and 1 run through it in the same direction");
    const int32_t bow_tie[6] = {0, 1, 2, 2, 3, 4};
    assert_int_equal(refusal(bow_tie, NULL, 5, 2, &err), -1);
    assert_string_equal(err.text, "vertex 2 is non-manifold: its 2 faces are not one fan");
    const int32_t eight[8] = {0, 1, 2, 3, 4, 2, 5, 6}, starts[2] = {0, 8};
    assert_int_equal(refusal(eight, starts, 7, 1, &err), -1);
    assert_string_equal(err.text, "face 0 is degenerate: it names vertex 2 twice");
}

static void two_umbrellas_are_refused(void **state)
{
    (void)state;
    struct mesh mesh;
    struct error err = {0};
    assert_int_equal(generate_two_cones(&mesh, 5, NULL), 0);
    struct polygons polygons = polygons_of_mesh(&mesh);
    int32_t twin[64], fan[64];
    assert_true(polygons_side_count(&polygons) <= 64);
    assert_int_equal(sides_match(&polygons, twin, &err), 0);
    assert_int_equal(sides_fans(&polygons, twin, fan, &err), -1);
    assert_non_null(strstr(err.text, "is non-manifold: its 10 faces are not one fan"));
    mesh_release(&mesh);
}

/* The apexes of a bipyramid have the numbers that make their buckets long. */
static void vertices_of_any_valence_are_matched(void **state)
{
    (void)state;
    enum { VALENCE = 5000 };
    int32_t *corners = malloc(3 * 2 * VALENCE * sizeof *corners);
    int32_t *twin = malloc(3 * 2 * VALENCE * sizeof *twin);
    assert_true(corners && twin);
    for (int32_t i = 0; i < VALENCE; i++) {
        const int32_t here = 2 + i, next = 2 + (i + 1) % VALENCE;
        const int32_t two[6] = {0, here, next, 1, next, here};
        for (int c = 0; c < 6; c++)
            corners[6 * i + c] = two[c];
    }
    const struct polygons polygons = {corners, NULL, VALENCE + 4, 2 * VALENCE};
    assert_int_equal(sides_match(&polygons, twin, NULL), 0);
    for (int32_t s = 0; s < 6 * VALENCE; s++) {
        assert_int_equal(twin[twin[s]], s);
        assert_int_equal(corners[twin[s]], corners[s % 3 == 2 ? s - 2 : s + 1]);
    }
    struct error err = {0};
    corners[3 * 100] = corners[3 * 102] = 1; /* and now edge {1, 53} has four faces */
    corners[3 * 100 + 1] = VALENCE + 2, corners[3 * 100 + 2] = 53;
    corners[3 * 102 + 1] = 53, corners[3 * 102 + 2] = VALENCE + 3;
    assert_int_equal(sides_match(&polygons, twin, &err), -1);
    assert_non_null(strstr(err.text, "edge {1, 53} is non-manifold"));
    free(corners);
    free(twin);
}

static void fans_start_on_the_boundary(void **state)
{
    (void)state;
    const int32_t corners[7] = {0, 1, 2, 3, 0, 3, 4}, starts[3] = {0, 4, 7};
    const struct polygons polygons = {corners, starts, 6, 2};
    int32_t twin[7], fan[6];
    assert_int_equal(sides_match(&polygons, twin, NULL), 0);
    const int32_t want[7] = {-1, -1, -1, 4, 3, -1, -1};
    assert_memory_equal(twin, want, sizeof want);
    assert_int_equal(sides_fans(&polygons, twin, fan, NULL), 0);
    const int32_t first[6] = {0, 1, 2, 5, 6, -1};
    assert_memory_equal(fan, first, sizeof first);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_refused_is_named),
        cmocka_unit_test(two_umbrellas_are_refused),
        cmocka_unit_test(vertices_of_any_valence_are_matched),
        cmocka_unit_test(fans_start_on_the_boundary),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
