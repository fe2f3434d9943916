/* Exact predicates of the plane, and tilings: against all pairs of triangles and many points. */
#include "graders/library/tiling.h"
#include "reference/base/random.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* -- predicates ------------------------------------------------------------------------------- */

static struct plane_point random_point(struct random *rng, uint64_t bound)
{
    return (struct plane_point){(int32_t)random_below(rng, bound) - (int32_t)(bound / 2),
                                (int32_t)random_below(rng, bound) - (int32_t)(bound / 2)};
}

/* With coordinates up to 64 doubles are exact. */
static double circle_slowly(struct plane_point a, struct plane_point b, struct plane_point c,
                            struct plane_point d)
{
    const struct plane_point p[3] = {a, b, c};
    double m[3][3], sum = 0;
    for (int i = 0; i < 3; i++) {
        m[i][0] = p[i].x - d.x;
        m[i][1] = p[i].y - d.y;
        m[i][2] = m[i][0] * m[i][0] + m[i][1] * m[i][1];
    }
    for (int i = 0; i < 3; i++)
        sum += m[i][0] *
               (m[(i + 1) % 3][1] * m[(i + 2) % 3][2] - m[(i + 2) % 3][1] * m[(i + 1) % 3][2]);
    return sum;
}

static int sign(double x)
{
    return (x > 0) - (x < 0);
}

static struct plane_point large(struct plane_point p, int32_t scale, int32_t shift)
{
    return (struct plane_point){p.x * scale + shift, p.y * scale - shift};
}

static void predicates_are_exact(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 81);
    int on_circle = 0;
    for (int trial = 0; trial < 100000; trial++) {
        struct plane_point p[4], far[4];
        uint64_t bound = trial % 2 ? 128 : 8;
        for (int i = 0; i < 4; i++) {
            p[i] = random_point(&rng, bound);
            far[i] = large(p[i], 1 << 21, 1 << 27);
        }
        double area = (double)(p[1].x - p[0].x) * (p[2].y - p[0].y) -
                      (double)(p[1].y - p[0].y) * (p[2].x - p[0].x);
        int circle = sign(circle_slowly(p[0], p[1], p[2], p[3]));
        assert_int_equal(plane_twice_area(p[0], p[1], p[2]), (int64_t)area);
        assert_int_equal(plane_side(far[0], far[1], far[2]), sign(area));
        assert_int_equal(plane_in_circle(p[0], p[1], p[2], p[3]), circle);
        assert_int_equal(plane_in_circle(far[0], far[1], far[2], far[3]), circle);
        on_circle += circle == 0;
        bool is_between =
            area == 0 &&
            (p[0].x - p[2].x) * (p[1].x - p[2].x) + (p[0].y - p[2].y) * (p[1].y - p[2].y) < 0;
        assert_int_equal(plane_is_between(far[0], far[1], far[2]), is_between);
    }
    assert_true(on_circle > 100);
    /* One unit in 2^29 decides. */
    const int32_t m = PLANE_COORDINATE_MOST;
    struct plane_point a = {-m, -m}, b = {m, -m}, c = {m, m}, d = {-m, m}, e = {-m + 1, m};
    assert_int_equal(plane_in_circle(a, b, c, d), 0);
    assert_int_equal(plane_in_circle(a, b, c, e), 1);
    assert_int_equal(plane_side(a, c, (struct plane_point){0, 1}), 1);
    assert_int_equal(plane_side(a, c, (struct plane_point){0, 0}), 0);
}

static void floats_become_whole(void **state)
{
    (void)state;
    const float fine[] = {0.25F, -3, 9, 0, 1024, -0.125F};
    struct plane_point points[3];
    assert_true(plane_points_of_floats(fine, 2, 3, points));
    const struct plane_point right[] = {{2, -24}, {72, 0}, {8192, -1}};
    assert_memory_equal(points, right, sizeof right);
    const float small[] = {ldexpf(3, -140), ldexpf(1, -149)}, zero[] = {0, -0.0F};
    assert_true(plane_points_of_floats(small, 2, 1, points));
    assert_int_equal(points[0].x, 3 * 512);
    assert_int_equal(points[0].y, 1);
    assert_true(plane_points_of_floats(zero, 2, 1, points));
    const float bad[][2] = {{NAN, 0}, {0, INFINITY}, {1024, ldexpf(1, -19)}};
    for (int i = 0; i < 3; i++)
        assert_false(plane_points_of_floats(bad[i], 2, 1, points));
    const float most[] = {1023.5F, ldexpf(1, -19)};
    assert_true(plane_points_of_floats(most, 2, 1, points));
    const float spread[] = {1, 7, 2, 3, 7, 4};
    assert_true(plane_points_of_floats(spread, 3, 2, points));
    assert_int_equal(points[1].x, 3);
    assert_int_equal(points[1].y, 7);
    assert_true(plane_points_of_floats(NULL, 2, 0, NULL));
}

/* -- tilings ---------------------------------------------------------------------------------- */

static void faults_are_named(void **state)
{
    (void)state;
    const struct plane_point points[] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 0}};
    const int32_t first[] = {0, 5}, vertices[] = {0, 4, 1, 2, 3};
    struct tiling_outline outline = {first, vertices, 1};
    static const struct {
        int32_t triangles[9];
        const struct cause *cause;
        int64_t element;
    } trials[] = {{{0, 4, 3, 4, 2, 3, 4, 1, 2}, NULL, 0},
                  {{0, 4, 3, 4, 2, 3, 4, 1, 5}, &tiling_bad_index, 8},
                  {{0, 4, 3, 4, 2, 3, 0, 4, 1}, &tiling_no_area, 2},
                  {{0, 4, 3, 4, 3, 2, 4, 1, 2}, &tiling_flipped, 1},
                  {{0, 4, 3, 4, 2, 3, 4, 2, 3}, &tiling_gap, 1},
                  {{0, 4, 3, 4, 1, 2, 0, 2, 3}, &tiling_loose, 1}};
    for (size_t i = 0; i < sizeof trials / sizeof *trials; i++) {
        struct tiling_fault fault;
        assert_int_equal(tiling_check(points, 5, &outline, trials[i].triangles, 3, &fault, NULL),
                         0);
        assert_ptr_equal(tiling_fault_cause(&fault), trials[i].cause);
        const int64_t told[] = {fault.bad_corner, fault.no_area, fault.flipped, fault.gap,
                                fault.loose};
        const struct cause *causes[] = {&tiling_bad_index, &tiling_no_area, &tiling_flipped,
                                        &tiling_gap, &tiling_loose};
        for (int c = 0; c < 5; c++)
            if (trials[i].cause == causes[c])
                assert_int_equal(told[c], trials[i].element);
        assert_true(fault.right_area == 16);
        tiling_fault_release(&fault);
        tiling_fault_release(&fault);
    }
}

static void holes_and_no_polygon_at_all(void **state)
{
    (void)state;
    const struct plane_point points[] = {{0, 0}, {9, 0}, {0, 9}, {1, 1}, {3, 1}, {1, 3}};
    const int32_t first[] = {0, 3, 6}, vertices[] = {0, 1, 2, 3, 5, 4};
    struct tiling_outline outline = {first, vertices, 2}, none = {NULL, NULL, 0};
    const int32_t triangles[] = {0, 1, 4, 0, 4, 3, 1, 2, 4, 2, 5, 4, 2, 0, 5, 0, 3, 5};
    struct tiling_fault fault;
    assert_int_equal(tiling_check(points, 6, &outline, triangles, 6, &fault, NULL), 0);
    assert_null(tiling_fault_cause(&fault));
    assert_true(fault.area == fault.right_area);
    tiling_fault_release(&fault);
    assert_int_equal(tiling_check(points, 6, &none, NULL, 0, &fault, NULL), 0);
    assert_null(tiling_fault_cause(&fault));
    tiling_fault_release(&fault);
    assert_int_equal(tiling_check(points, 6, &none, triangles, -1, &fault, NULL), -1);
}

enum { MOST = 9, FACTOR = 12, MOST_TRIANGLES = 12 };

/* Points round a centre, no three on a line. */
static int random_polygon(struct random *rng, struct plane_point *points)
{
    int count = 3 + (int)random_below(rng, MOST - 2);
    for (;;) {
        for (int i = 0; i < count; i++) {
            double angle = 6.283185307179586 * (i + 0.8 * random_real(rng)) / count;
            double radius = 6 + 30 * random_real(rng);
            points[i] = (struct plane_point){FACTOR * (int32_t)lround(radius * cos(angle)),
                                             FACTOR * (int32_t)lround(radius * sin(angle))};
        }
        bool is_general = true;
        for (int i = 0; i < count; i++)
            for (int j = 0; j < i; j++)
                for (int k = 0; k < j; k++)
                    if (!plane_side(points[i], points[j], points[k]))
                        is_general = false;
        struct plane_point centre = {0, 0};
        for (int i = 0; i < count; i++)
            if (plane_side(centre, points[i], points[(i + 1) % count]) <= 0)
                is_general = false;
        if (is_general)
            return count;
    }
}

static bool holds(const struct plane_point *points, const int32_t *v, struct plane_point p)
{
    for (int c = 0; c < 3; c++)
        if (plane_side(points[v[c]], points[v[(c + 1) % 3]], p) <= 0)
            return false;
    return true;
}

/* Cuts ears off. Returns how many triangles. */
static int triangulate(const struct plane_point *points, int count, int32_t *triangles)
{
    int32_t left[MOST];
    int made = 0;
    for (int i = 0; i < count; i++)
        left[i] = i;
    while (count >= 3)
        for (int i = 0; i < count; i++) {
            const int32_t ear[3] = {left[(i + count - 1) % count], left[i], left[(i + 1) % count]};
            bool is_ear = plane_side(points[ear[0]], points[ear[1]], points[ear[2]]) > 0;
            for (int j = 0; j < count; j++)
                is_ear = is_ear && !holds(points, ear, points[left[j]]);
            if (!is_ear)
                continue;
            memcpy(triangles + 3 * made++, ear, sizeof ear);
            memmove(left + i, left + i + 1, (size_t)(count - i - 1) * sizeof *left);
            count--;
            break;
        }
    return made;
}

static bool are_apart(const struct plane_point *points, const int32_t *s, const int32_t *t)
{
    for (int c = 0; c < 3; c++) {
        bool is_apart = true;
        for (int d = 0; d < 3; d++)
            is_apart =
                is_apart && plane_side(points[s[c]], points[s[(c + 1) % 3]], points[t[d]]) <= 0;
        if (is_apart)
            return true;
    }
    return false;
}

/* Whether a point lies in the star-shaped polygon round (0,0): -1 on a side. */
static int is_inside(const struct plane_point *points, int count, struct plane_point p)
{
    struct plane_point centre = {0, 0};
    for (int i = 0; i < count; i++) {
        struct plane_point a = points[i], b = points[(i + 1) % count];
        if (plane_side(centre, a, p) >= 0 && plane_side(centre, b, p) < 0)
            return plane_side(a, b, p) == 0 ? -1 : plane_side(a, b, p) > 0;
    }
    return p.x == 0 && p.y == 0;
}

/* All positive, none overlaps another, middles inside, areas add up. */
static bool tiles_slowly(const struct plane_point *points, int count, const int32_t *triangles,
                         int triangle_count)
{
    int64_t area = 0, right = 0;
    struct plane_point centre = {0, 0};
    for (int i = 0; i < count; i++)
        right += plane_twice_area(centre, points[i], points[(i + 1) % count]);
    for (int t = 0; t < triangle_count; t++) {
        const int32_t *v = triangles + 3 * t;
        for (int c = 0; c < 3; c++)
            if (v[c] < 0 || v[c] >= count)
                return false;
        int64_t twice = plane_twice_area(points[v[0]], points[v[1]], points[v[2]]);
        if (twice <= 0)
            return false;
        area += twice;
        /* Whole, as coordinates are multiples of 12; and points near the corners. */
        for (int d = -1; d < 3; d++) {
            int32_t x = 0, y = 0;
            for (int c = 0; c < 3; c++) {
                x += points[v[c]].x / FACTOR * (d < 0 ? 4 : c == d ? 10 : 1);
                y += points[v[c]].y / FACTOR * (d < 0 ? 4 : c == d ? 10 : 1);
            }
            if (is_inside(points, count, (struct plane_point){x, y}) == 0)
                return false;
        }
        for (int s = 0; s < t; s++)
            if (!are_apart(points, triangles + 3 * s, v) &&
                !are_apart(points, v, triangles + 3 * s))
                return false;
    }
    return area == right;
}

static void damage(int32_t *triangles, int *count, int points, struct random *rng)
{
    int at = (int)random_below(rng, (uint64_t)(3 * *count));
    switch (random_below(rng, 6)) {
    case 0:
        triangles[at] = (int32_t)random_next(rng);
        break;
    case 1:
        memmove(triangles + at - at % 3, triangles + 3 * --*count, 3 * sizeof *triangles);
        break;
    case 2:
        memcpy(triangles + 3 * (*count)++, triangles + at - at % 3, 3 * sizeof *triangles);
        break;
    case 3:
        break;
    default:
        triangles[at] = (int32_t)random_below(rng, (uint64_t)points);
    }
}

static void random_tilings_are_judged_as_slowly(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 82);
    int tilings = 0;
    for (int trial = 0; trial < 20000; trial++) {
        struct plane_point points[MOST];
        int32_t triangles[3 * MOST_TRIANGLES], vertices[MOST];
        int count = random_polygon(&rng, points);
        int triangle_count = triangulate(points, count, triangles);
        for (int i = 0; i < count; i++)
            vertices[i] = i;
        if (random_below(&rng, 8))
            damage(triangles, &triangle_count, count, &rng);
        const int32_t first[] = {0, count};
        struct tiling_outline outline = {first, vertices, 1};
        struct tiling_fault fault;
        assert_int_equal(
            tiling_check(points, count, &outline, triangles, triangle_count, &fault, NULL), 0);
        bool is_tiling = tiles_slowly(points, count, triangles, triangle_count);
        assert_int_equal(tiling_fault_cause(&fault) == NULL, is_tiling);
        tilings += is_tiling;
        tiling_fault_release(&fault);
    }
    assert_true(tilings > 2000);
}

static void garbage_is_bounded(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 83);
    struct plane_point points[MOST];
    int count = random_polygon(&rng, points);
    const int32_t first[] = {0, 3}, vertices[] = {0, 1, 2};
    struct tiling_outline outline = {first, vertices, 1};
    for (int trial = 0; trial < 5000; trial++) {
        int32_t triangle_count = (int32_t)random_below(&rng, 20);
        int32_t *triangles = malloc(12 * (size_t)triangle_count + 1);
        assert_non_null(triangles);
        for (int32_t c = 0; c < 3 * triangle_count; c++)
            triangles[c] = random_below(&rng, 6) ? (int32_t)random_below(&rng, (uint64_t)count)
                                                 : (int32_t)random_next(&rng);
        struct tiling_fault fault;
        int64_t corner;
        int32_t inside;
        assert_int_equal(
            tiling_check(points, count, &outline, triangles, triangle_count, &fault, NULL), 0);
        assert_int_equal(tiling_find_not_delaunay(points, count, triangles, triangle_count, &corner,
                                                  &inside, NULL),
                         0);
        tiling_fault_release(&fault);
        free(triangles);
    }
}

static void what_is_not_delaunay_is_found(void **state)
{
    (void)state;
    const struct plane_point kite[] = {{0, -1}, {9, 0}, {0, 1}, {-9, 0}};
    const int32_t good[] = {0, 1, 2, 0, 2, 3}, bad[] = {0, 1, 3, 1, 2, 3};
    int64_t corner;
    int32_t inside;
    assert_int_equal(tiling_find_not_delaunay(kite, 4, good, 2, &corner, &inside, NULL), 0);
    assert_int_equal(corner, -1);
    assert_int_equal(tiling_find_not_delaunay(kite, 4, bad, 2, &corner, &inside, NULL), 0);
    assert_int_equal(corner, 1);
    assert_int_equal(inside, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(predicates_are_exact),
        cmocka_unit_test(floats_become_whole),
        cmocka_unit_test(faults_are_named),
        cmocka_unit_test(holes_and_no_polygon_at_all),
        cmocka_unit_test(random_tilings_are_judged_as_slowly),
        cmocka_unit_test(garbage_is_bounded),
        cmocka_unit_test(what_is_not_delaunay_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
