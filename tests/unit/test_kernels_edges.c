/* Edge tables: every variant equals plain, and plain equals sorting. */
#include "reference/mesh/check.h"
#include "tests/unit/kernel_checks.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* An edge of a triangle, its smaller vertex first. */
struct use {
    int32_t low, high;
    int32_t triangle;
};

static int by_edge(const void *a, const void *b)
{
    const struct use *x = a, *y = b;
    if (x->low != y->low)
        return x->low < y->low ? -1 : 1;
    if (x->high != y->high)
        return x->high < y->high ? -1 : 1;
    return (x->triangle > y->triangle) - (x->triangle < y->triangle);
}

static int by_first_use(const void *a, const void *b)
{
    const struct use *x = a, *y = b;
    if (x->low != y->low)
        return x->low < y->low ? -1 : 1;
    if (x->triangle != y->triangle)
        return x->triangle < y->triangle ? -1 : 1;
    return (x->high > y->high) - (x->high < y->high);
}

/* The edges in the order that edges_any.h promises. */
static struct use *edges_by_sorting(const struct mesh *mesh, int64_t *count)
{
    size_t side_count = 3 * (size_t)mesh->triangle_count, use_count = 0;
    struct use *uses = malloc((side_count + 1) * sizeof *uses);
    assert_non_null(uses);
    for (size_t s = 0; s < side_count; s++) {
        int32_t i = mesh->triangles[s], j = mesh->triangles[s % 3 == 2 ? s - 2 : s + 1];
        if (i != j)
            uses[use_count++] = (struct use){i < j ? i : j, i < j ? j : i, (int32_t)(s / 3)};
    }
    qsort(uses, use_count, sizeof *uses, by_edge);
    size_t kept = 0;
    for (size_t k = 0; k < use_count; k++)
        if (kept == 0 || uses[k].low != uses[kept - 1].low || uses[k].high != uses[kept - 1].high)
            uses[kept++] = uses[k];
    qsort(uses, kept, sizeof *uses, by_first_use);
    *count = (int64_t)kept;
    return uses;
}

static void any_equals_sorting(const struct mesh *mesh)
{
    int64_t right_count, count;
    struct use *right = edges_by_sorting(mesh, &right_count);
    int32_t *edges = run_guarded(kernel_find("edges-any", "plain"), mesh, &count);
    assert_int_equal(count, right_count);
    for (int64_t e = 0; e < count; e++)
        if (edges[2 * e] != right[e].low || edges[2 * e + 1] != right[e].high)
            fail_msg("edge %lld of a mesh of %d triangles is %d %d for %d %d", (long long)e,
                     mesh->triangle_count, edges[2 * e], edges[2 * e + 1], right[e].low,
                     right[e].high);
    free(right);
    free_guarded(edges);
}

static int compare_pairs(const void *a, const void *b)
{
    return memcmp(a, b, 2 * sizeof(int32_t));
}

/* As sets: the two kernels list the same edges of a closed coherent mesh. */
static void closed_equals_any(const struct mesh *mesh)
{
    struct topology topology;
    assert_int_equal(mesh_topology(mesh, &topology, NULL), 0);
    if (topology.boundary.count + topology.incoherent.count + topology.nonmanifold_edge.count +
            topology.degenerate.count + topology.duplicate.count >
        0)
        return;
    int64_t count, any_count;
    int32_t *edges = run_guarded(kernel_find("edges-closed", "plain"), mesh, &count);
    int32_t *any = run_guarded(kernel_find("edges-any", "plain"), mesh, &any_count);
    assert_int_equal(count, any_count);
    assert_int_equal(2 * count, 3 * (int64_t)mesh->triangle_count);
    qsort(edges, (size_t)count, 2 * sizeof *edges, compare_pairs);
    qsort(any, (size_t)count, 2 * sizeof *any, compare_pairs);
    assert_memory_equal(edges, any, 2 * (size_t)count * sizeof *edges);
    free_guarded(edges);
    free_guarded(any);
}

static void closed_variants_equal(const struct mesh *mesh)
{
    check_variants_equal("edges-closed", mesh, 2 * sizeof(int32_t));
}

static void any_variants_equal(const struct mesh *mesh)
{
    check_variants_equal("edges-any", mesh, 2 * sizeof(int32_t));
}

static void edges_of_any_mesh_equal_sorting(void **state)
{
    (void)state;
    with_every_mesh(any_equals_sorting);
}

static void edges_of_closed_meshes_are_the_same_set(void **state)
{
    (void)state;
    with_every_mesh(closed_equals_any);
}

static void variants_for_closed_meshes_are_equal(void **state)
{
    (void)state;
    with_every_mesh(closed_variants_equal);
}

static void variants_for_any_mesh_are_equal(void **state)
{
    (void)state;
    with_every_mesh(any_variants_equal);
}

/* The two answers of reference/mesh/edges.h, where they differ. The meshes are those of bug
 * reports: a degenerate triangle apart and a triangle twice; a triangle that is a point. */
static void edges_of_degenerate_triangles(void **state)
{
    static const struct {
        int32_t triangles[9];
        int64_t of_surface, of_table;
    } cases[] = {{{3, 4, 4, 0, 1, 2, 0, 1, 2}, 3, 4}, {{0, 1, 2, 2, 2, 2, 1, 3, 2}, 5, 5}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct mesh mesh;
        struct edge_list list;
        int64_t count;
        assert_int_equal(mesh_init(&mesh, 6, 3, NULL), 0);
        memcpy(mesh.triangles, cases[i].triangles, sizeof cases[i].triangles);
        assert_int_equal(edge_list_init(&list, &mesh, NULL), 0);
        assert_int_equal(list.edge_count, cases[i].of_surface);
        edge_list_release(&list);
        free_guarded(run_guarded(kernel_find("edges-any", "plain"), &mesh, &count));
        assert_int_equal(count, cases[i].of_table);
        mesh_release(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edges_of_any_mesh_equal_sorting),
        cmocka_unit_test(edges_of_closed_meshes_are_the_same_set),
        cmocka_unit_test(variants_for_closed_meshes_are_equal),
        cmocka_unit_test(variants_for_any_mesh_are_equal),
        cmocka_unit_test(edges_of_degenerate_triangles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
