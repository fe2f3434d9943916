/* Exact predicates, triangles that cross, and boxes in a tree, each against the plainest way. */
#include "reference/base/random.h"
#include "reference/survey/box_tree.h"
#include "reference/survey/crossing.h"
#include "reference/survey/exact.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

__extension__ typedef __int128 wide;

static int sign_of(wide value)
{
    return (value > 0) - (value < 0);
}

static int64_t below(struct random *rng, int64_t most)
{
    return (int64_t)random_below(rng, (uint64_t)(2 * most + 1)) - most;
}

/* -- predicates ------------------------------------------------------------------------------- */

/* Integers below 2^24, so that a float holds them; scaled by a power of two nothing changes. */
struct whole_points {
    int64_t x[4][3];
    float p[4][3];
};

static void set_points(struct whole_points *points, int exponent)
{
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            points->p[i][k] = ldexpf((float)points->x[i][k], exponent);
}

/* Half of them lie in a plane, or nearly. */
static void draw_points(struct whole_points *points, struct random *rng)
{
    int64_t size = INT64_C(1) << (1 + random_below(rng, 20));
    bool is_flat = random_below(rng, 2) == 0;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            points->x[i][k] = below(rng, size);
    int64_t u = below(rng, 2), v = below(rng, 2);
    for (int k = 0; k < 3; k++) {
        int64_t a = points->x[0][k], b = points->x[1][k], c = points->x[2][k];
        points->x[3][k] = is_flat ? a + u * (b - a) + v * (c - a) : below(rng, size);
    }
    if (is_flat && random_below(rng, 2) == 0)
        points->x[3][random_below(rng, 3)] += below(rng, 1);
}

static int whole_plane_side(const struct whole_points *points)
{
    wide u[3], v[3], w[3];
    for (int k = 0; k < 3; k++) {
        u[k] = points->x[1][k] - points->x[0][k];
        v[k] = points->x[2][k] - points->x[0][k];
        w[k] = points->x[3][k] - points->x[0][k];
    }
    return sign_of((u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
                   (u[0] * v[1] - u[1] * v[0]) * w[2]);
}

static int whole_line_side(const struct whole_points *points, int axis)
{
    int x = (axis + 1) % 3, y = (axis + 2) % 3;
    wide ux = points->x[1][x] - points->x[0][x], uy = points->x[1][y] - points->x[0][y];
    wide vx = points->x[2][x] - points->x[0][x], vy = points->x[2][y] - points->x[0][y];
    return sign_of(ux * vy - uy * vx);
}

static void sides_are_exact_at_every_scale(void **state)
{
    (void)state;
    static const int exponents[] = {0, -149, 100, -40};
    struct random rng;
    int zeros = 0;
    random_init(&rng, 7);
    for (int round = 0; round < 40000; round++) {
        struct whole_points points;
        draw_points(&points, &rng);
        set_points(&points, exponents[round % 4]);
        int expected = whole_plane_side(&points);
        zeros += expected == 0;
        assert_int_equal(exact_plane_side(points.p[0], points.p[1], points.p[2], points.p[3]),
                         expected);
        assert_int_equal(exact_plane_side(points.p[1], points.p[0], points.p[2], points.p[3]),
                         -expected);
        for (int axis = 0; axis < 3; axis++)
            assert_int_equal(exact_line_side(axis, points.p[0], points.p[1], points.p[2]),
                             whole_line_side(&points, axis));
    }
    assert_true(zeros > 5000);
}

static void sides_of_mixed_scales_are_exact(void **state)
{
    (void)state;
    /* 2^-149 beside 2^100: only the exact way sees it. */
    const float a[3] = {0, 0, 0}, b[3] = {0x1p100F, 0, 0}, c[3] = {0, 0x1p100F, 0};
    const float above[3] = {0x1p100F, 0x1p99F, 0x1p-149F}, on[3] = {0x1p100F, 0x1p99F, -0.0F};
    assert_int_equal(exact_plane_side(a, b, c, above), 1);
    assert_int_equal(exact_plane_side(a, b, c, on), 0);
    const float near_line[3] = {0x1p100F, 0x1p-149F, 0}, far[3] = {0x1.fffffep127F, 0, 0};
    assert_int_equal(exact_line_side(2, a, far, near_line), 1);
    assert_int_equal(exact_line_side(2, far, a, near_line), -1);
    assert_true(exact_on_line(a, b, far));
    assert_false(exact_on_line(a, far, near_line));
}

static void triangles_without_area_are_known(void **state)
{
    (void)state;
    const float a[3] = {0, 0, 0}, b[3] = {1, 2, 3}, c[3] = {3, 6, 9}, d[3] = {3, 6, 9.000001F};
    assert_true(exact_on_line(a, b, c));
    assert_true(exact_on_line(a, a, c));
    assert_true(exact_on_line(a, a, a));
    assert_false(exact_on_line(a, b, d));
    /* A tenth is no float: what looks like a line is none. */
    const float tenth[3] = {0.1F, 0.1F, 0.1F}, three[3] = {0.3F, 0.3F, 0.3F};
    const float other[3] = {0.1F, 0.2F, 0.3F};
    assert_true(exact_on_line(a, tenth, three));
    assert_false(exact_on_line(a, other, three));
}

/* -- crossings -------------------------------------------------------------------------------- */

struct whole_triangle {
    int64_t x[3][3];
    float p[3][3];
    const float *corner[3];
};

static void cross(const int64_t u[3], const int64_t v[3], int64_t product[3])
{
    for (int i = 0; i < 3; i++)
        product[i] = u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
}

static int64_t dot(const int64_t u[3], const int64_t v[3])
{
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

static void normal_of(const struct whole_triangle *t, int64_t normal[3])
{
    int64_t u[3] = {0}, v[3] = {0};
    for (int k = 0; k < 3; k++) {
        u[k] = t->x[1][k] - t->x[0][k];
        v[k] = t->x[2][k] - t->x[0][k];
    }
    cross(u, v, normal);
}

static bool draw_triangle(struct whole_triangle *t, struct random *rng, int64_t size)
{
    int64_t normal[3] = {0};
    for (int i = 0; i < 3; i++) {
        t->corner[i] = t->p[i];
        for (int k = 0; k < 3; k++) {
            t->x[i][k] = below(rng, size);
            t->p[i][k] = (float)t->x[i][k];
        }
    }
    normal_of(t, normal);
    return dot(normal, normal) != 0;
}

/* A place on the line in which two planes meet: over / under. */
struct fraction {
    int64_t over, under; /* under > 0 */
};

static bool is_less(struct fraction a, struct fraction b)
{
    return (wide)a.over * b.under < (wide)b.over * a.under;
}

/* The piece of the line that lies in t; false when t's inside does not reach it. */
static bool piece_of(const struct whole_triangle *t, const struct whole_triangle *plane,
                     const int64_t line[3], struct fraction ends[2])
{
    int64_t normal[3] = {0}, height[3] = {0};
    int count = 0;
    bool above = false, under = false;
    ends[0] = ends[1] = (struct fraction){0, 1};
    normal_of(plane, normal);
    for (int i = 0; i < 3; i++) {
        height[i] = dot(normal, t->x[i]) - dot(normal, plane->x[0]);
        above |= height[i] > 0;
        under |= height[i] < 0;
    }
    if (!above || !under)
        return false;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        int64_t here = dot(line, t->x[i]), there = dot(line, t->x[j]);
        if (height[i] == 0)
            ends[count++] = (struct fraction){here, 1};
        else if ((height[i] > 0) != (height[j] > 0) && height[j] != 0) {
            int64_t over = here * height[j] - there * height[i], below_it = height[j] - height[i];
            ends[count++] = below_it > 0 ? (struct fraction){over, below_it}
                                         : (struct fraction){-over, -below_it};
        }
    }
    assert_int_equal(count, 2);
    if (is_less(ends[1], ends[0])) {
        struct fraction first = ends[0];
        ends[0] = ends[1];
        ends[1] = first;
    }
    return true;
}

/* The area that two triangles of one plane share, by clipping one with the sides of the other. */
static double shared_area(const struct whole_triangle *s, const struct whole_triangle *t, int axis)
{
    enum { MOST = 16 };
    double polygon[MOST][2], next[MOST][2], area = 0;
    int x = (axis + 1) % 3, y = (axis + 2) % 3, count = 3;
    int64_t normal[3] = {0};
    normal_of(t, normal);
    double turn = normal[axis] > 0 ? 1 : -1;
    for (int i = 0; i < 3; i++) {
        polygon[i][0] = (double)s->x[i][x];
        polygon[i][1] = (double)s->x[i][y];
    }
    for (int side = 0; side < 3; side++) {
        const int64_t *a = t->x[side], *b = t->x[(side + 1) % 3];
        double ux = (double)(b[x] - a[x]) * turn, uy = (double)(b[y] - a[y]) * turn;
        int kept = 0;
        for (int i = 0; i < count; i++) {
            const double *p = polygon[i], *q = polygon[(i + 1) % count];
            double hp = ux * (p[1] - (double)a[y]) - uy * (p[0] - (double)a[x]);
            double hq = ux * (q[1] - (double)a[y]) - uy * (q[0] - (double)a[x]);
            if (hp >= 0)
                memcpy(next[kept++], p, sizeof next[0]);
            if ((hp > 0 && hq < 0) || (hp < 0 && hq > 0))
                for (int k = 0; k < 2 && kept < MOST; k++)
                    next[kept][k] = p[k] + (q[k] - p[k]) * (hp / (hp - hq));
            kept += (hp > 0 && hq < 0) || (hp < 0 && hq > 0);
        }
        count = kept;
        memcpy(polygon, next, sizeof polygon);
    }
    for (int i = 0; i < count; i++) {
        const double *p = polygon[i], *q = polygon[(i + 1) % count];
        area += p[0] * q[1] - p[1] * q[0];
    }
    return fabs(area) / 2;
}

static bool plainly_cross(const struct whole_triangle *s, const struct whole_triangle *t)
{
    int64_t n[3] = {0}, m[3] = {0}, line[3] = {0};
    struct fraction a[2] = {{0, 1}}, b[2] = {{0, 1}};
    normal_of(s, n);
    normal_of(t, m);
    cross(n, m, line);
    int axis = n[0] != 0 ? 0 : n[1] != 0 ? 1 : 2;
    if (dot(line, line) == 0)
        return dot(n, t->x[0]) == dot(n, s->x[0]) && shared_area(s, t, axis) > 1e-6;
    return piece_of(s, t, line, a) && piece_of(t, s, line, b) && is_less(a[0], b[1]) &&
           is_less(b[0], a[1]);
}

static void crossings_are_those_of_fractions(void **state)
{
    (void)state;
    struct random rng;
    int crossing = 0, flat_pairs = 0, rounds = 0;
    random_init(&rng, 11);
    while (rounds < 60000) {
        struct whole_triangle s = {.corner = {NULL}}, t = {.corner = {NULL}};
        int64_t size = 1 + (int64_t)random_below(&rng, 6);
        if (!draw_triangle(&s, &rng, size) || !draw_triangle(&t, &rng, size))
            continue;
        if (rounds % 4 == 0) /* in one plane */
            for (int i = 0; i < 3; i++)
                s.x[i][2] = t.x[i][2] = 0, s.p[i][2] = t.p[i][2] = 0;
        int64_t n[3] = {0}, m[3] = {0};
        normal_of(&s, n);
        normal_of(&t, m);
        if (dot(n, n) == 0 || dot(m, m) == 0)
            continue;
        rounds++;
        bool expected = plainly_cross(&s, &t);
        assert_int_equal(triangles_cross(s.corner, t.corner), expected);
        assert_int_equal(triangles_cross(t.corner, s.corner), expected);
        crossing += expected;
        flat_pairs += rounds % 4 == 0;
    }
    assert_true(crossing > 3000 && crossing < rounds - 3000 && flat_pairs > 3000);
}

/* -- boxes ------------------------------------------------------------------------------------ */

enum { BOXES = 700 };
struct found {
    uint8_t pairs[BOXES][BOXES];
    int64_t count, limit;
    const struct box_tree *tree;
};

static bool note_pair(void *context, int32_t one, int32_t other)
{
    struct found *found = context;
    assert_true(one < other);
    one = found->tree->items[one];
    other = found->tree->items[other];
    assert_int_equal(found->pairs[one < other ? one : other][one < other ? other : one]++, 0);
    return ++found->count < found->limit;
}

static bool note_item(void *context, int32_t item)
{
    struct found *found = context;
    assert_int_equal(found->pairs[0][item]++, 0);
    return ++found->count < found->limit;
}

static bool boxes_meet(const struct bounds *a, const struct bounds *b)
{
    for (int k = 0; k < 3; k++)
        if (a->low[k] > b->high[k] || b->low[k] > a->high[k])
            return false;
    return true;
}

static void draw_boxes(struct bounds *boxes, int count, struct random *rng)
{
    for (int i = 0; i < count; i++) {
        boxes[i] = bounds_empty();
        float from[3], to[3];
        for (int k = 0; k < 3; k++) {
            from[k] = (float)below(rng, 40);
            to[k] = from[k] + (float)random_below(rng, random_below(rng, 40) == 0 ? 60 : 8);
        }
        bounds_include(&boxes[i], from);
        bounds_include(&boxes[i], to);
    }
}

static void every_pair_of_boxes_that_meet_is_visited_once(void **state)
{
    (void)state;
    static struct found found;
    struct random rng;
    struct bounds boxes[BOXES];
    random_init(&rng, 3);
    for (int round = 0; round < 40; round++) {
        int count = round < 12 ? round : (int)random_below(&rng, BOXES);
        struct box_tree tree;
        draw_boxes(boxes, count, &rng);
        if (round % 5 == 4) /* all at one place */
            for (int i = 0; i < count; i++)
                boxes[i] = boxes[0];
        assert_int_equal(box_tree_build(&tree, boxes, count, NULL), 0);
        memset(&found, 0, sizeof found);
        found.limit = INT64_MAX;
        found.tree = &tree;
        box_tree_find_pairs(&tree, note_pair, &found);
        for (int i = 0; i < count; i++)
            for (int k = i + 1; k < count; k++)
                assert_int_equal(found.pairs[i][k], boxes_meet(&boxes[i], &boxes[k]));
        memset(&found, 0, sizeof found);
        found.limit = INT64_MAX;
        struct bounds query;
        draw_boxes(&query, 1, &rng);
        box_tree_find(&tree, &query, note_item, &found);
        for (int i = 0; i < count; i++)
            assert_int_equal(found.pairs[0][i], boxes_meet(&boxes[i], &query));
        box_tree_release(&tree);
        box_tree_release(&tree);
    }
}

static void a_search_ends_when_it_is_told_to(void **state)
{
    (void)state;
    static struct found found;
    struct bounds boxes[20];
    struct box_tree tree;
    for (int i = 0; i < 20; i++)
        boxes[i] = (struct bounds){{0, 0, 0}, {1, 1, 1}};
    assert_int_equal(box_tree_build(&tree, boxes, 20, NULL), 0);
    found.limit = 7;
    found.tree = &tree;
    box_tree_find_pairs(&tree, note_pair, &found);
    assert_int_equal(found.count, 7);
    memset(&found, 0, sizeof found);
    found.limit = 3;
    box_tree_find(&tree, &boxes[0], note_item, &found);
    assert_int_equal(found.count, 3);
    box_tree_release(&tree);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sides_are_exact_at_every_scale),
        cmocka_unit_test(sides_of_mixed_scales_are_exact),
        cmocka_unit_test(triangles_without_area_are_known),
        cmocka_unit_test(crossings_are_those_of_fractions),
        cmocka_unit_test(every_pair_of_boxes_that_meet_is_visited_once),
        cmocka_unit_test(a_search_ends_when_it_is_told_to),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
