/* Twins: every variant equals plain, and plain equals sorting. */
#include "reference/kernels/twins.h"
#include "reference/mesh/generate.h"
#include "tests/unit/kernel_checks.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>

#include <cmocka.h>

struct half_edge {
    int32_t from, to;
    int32_t side;
};

static int by_ends(const void *a, const void *b)
{
    const struct half_edge *x = a, *y = b;
    if (x->from != y->from)
        return x->from < y->from ? -1 : 1;
    return (x->to > y->to) - (x->to < y->to);
}

static const struct half_edge *first_from_to(const struct half_edge *sorted, size_t count,
                                             int32_t from, int32_t to)
{
    size_t begin = 0, end = count;
    const struct half_edge wanted = {from, to, 0};
    while (begin < end) {
        size_t middle = (begin + end) / 2;
        if (by_ends(sorted + middle, &wanted) < 0)
            begin = middle + 1;
        else
            end = middle;
    }
    return sorted + begin;
}

static bool runs(const struct half_edge *h, const struct half_edge *stop, int32_t from, int32_t to)
{
    return h < stop && h->from == from && h->to == to;
}

static void equals_sorting(const struct mesh *mesh)
{
    size_t count = 3 * (size_t)mesh->triangle_count;
    struct half_edge *sorted = malloc((count + 1) * sizeof *sorted);
    assert_non_null(sorted);
    for (size_t s = 0; s < count; s++)
        sorted[s] = (struct half_edge){mesh->triangles[s],
                                       mesh->triangles[s % 3 == 2 ? s - 2 : s + 1], (int32_t)s};
    qsort(sorted, count, sizeof *sorted, by_ends);
    int64_t side_count;
    int32_t *twin = run_guarded(kernel_find("twins", "plain"), mesh, &side_count);
    assert_int_equal(side_count, count);
    for (size_t s = 0; s < count; s++) {
        int32_t i = mesh->triangles[s], j = mesh->triangles[s % 3 == 2 ? s - 2 : s + 1];
        const struct half_edge *stop = sorted + count;
        const struct half_edge *same = first_from_to(sorted, count, i, j);
        const struct half_edge *back = first_from_to(sorted, count, j, i);
        int32_t right = i == j || !runs(back, stop, j, i)                          ? TWIN_NONE
                        : runs(same + 1, stop, i, j) || runs(back + 1, stop, j, i) ? TWIN_MANY
                                                                                   : back->side;
        if (twin[s] != right)
            fail_msg("side %zu of a mesh of %d triangles has twin %d for %d", s,
                     mesh->triangle_count, twin[s], right);
    }
    free(sorted);
    free_guarded(twin);
}

static void variants_equal(const struct mesh *mesh)
{
    check_variants_equal("twins", mesh, sizeof(int32_t));
}

static void twins_equal_sorting(void **state)
{
    (void)state;
    with_every_mesh(equals_sorting);
}

static void variants_are_equal(void **state)
{
    (void)state;
    with_every_mesh(variants_equal);
}

/* The contract's three answers on the smallest meshes that show them. */
static void boundaries_and_books_are_told_apart(void **state)
{
    (void)state;
    struct mesh mesh;
    int64_t count;
    assert_int_equal(generate_one_triangle(&mesh, NULL), 0);
    int32_t *twin = run_guarded(kernel_find("twins", NULL), &mesh, &count);
    for (int64_t s = 0; s < count; s++)
        assert_int_equal(twin[s], TWIN_NONE);
    free_guarded(twin);
    mesh_release(&mesh);
    assert_int_equal(generate_two_cubes(&mesh, NULL), 0);
    twin = run_guarded(kernel_find("twins", NULL), &mesh, &count);
    int many = 0;
    for (int64_t s = 0; s < count; s++) {
        assert_int_not_equal(twin[s], TWIN_NONE);
        many += twin[s] == TWIN_MANY;
        if (twin[s] >= 0)
            assert_int_equal(twin[twin[s]], s);
    }
    assert_int_equal(many, 4);
    free_guarded(twin);
    mesh_release(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(twins_equal_sorting),
        cmocka_unit_test(variants_are_equal),
        cmocka_unit_test(boundaries_and_books_are_told_apart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
