/* The answers that the grader measures by, reference/edges and reference/processing, against the
 * plain kernels: the same edges, the same area to the bit. */
#include "tests/unit/kernel_checks.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* From the headers of the exercises, which cannot stand together: each names OUT_OF_MEMORY. */
int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges);
int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges);
double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count);

static int compare_pairs(const void *a, const void *b)
{
    return memcmp(a, b, 2 * sizeof(int32_t));
}

static void any_lists_the_same(const struct mesh *mesh)
{
    int64_t count;
    int32_t *answer = NULL;
    int32_t *edges = run_guarded(kernel_find("edges-any", "plain"), mesh, &count);
    assert_int_equal(
        edge_table_any(mesh->triangles, mesh->triangle_count, mesh->vertex_count, &answer), count);
    for (int64_t e = 0; e < count; e++)
        if (answer[2 * e] > answer[2 * e + 1]) {
            int32_t swapped = answer[2 * e];
            answer[2 * e] = answer[2 * e + 1];
            answer[2 * e + 1] = swapped;
        }
    if (count > 0) {
        qsort(edges, (size_t)count, 2 * sizeof *edges, compare_pairs);
        qsort(answer, (size_t)count, 2 * sizeof *answer, compare_pairs);
        assert_memory_equal(edges, answer, 2 * (size_t)count * sizeof *edges);
    }
    free(answer);
    free_guarded(edges);
}

/* The answer makes room for 3/2 of the triangles, so it is asked about closed meshes only. */
static void closed_lists_the_same(const struct mesh *mesh)
{
    int64_t count;
    int32_t *answer = NULL;
    int32_t *edges = run_guarded(kernel_find("edges-closed", "plain"), mesh, &count);
    if (2 * count == 3 * (int64_t)mesh->triangle_count) {
        assert_int_equal(
            edge_table_closed(mesh->triangles, mesh->triangle_count, mesh->vertex_count, &answer),
            count);
        if (count > 0)
            assert_memory_equal(answer, edges, 2 * (size_t)count * sizeof *edges);
    }
    free(answer);
    free_guarded(edges);
}

static void area_is_the_same(const struct mesh *mesh)
{
    int64_t count;
    double *area = run_guarded(kernel_find("area", "plain"), mesh, &count);
    double answer =
        mesh_area(mesh->positions, mesh->vertex_count, mesh->triangles, mesh->triangle_count);
    assert_true(*area == answer);
    free_guarded(area);
}

static void edge_tables_of_any_mesh_agree(void **state)
{
    (void)state;
    with_every_mesh(any_lists_the_same);
}

static void edge_tables_of_closed_meshes_agree(void **state)
{
    (void)state;
    with_every_mesh(closed_lists_the_same);
}

static void areas_agree(void **state)
{
    (void)state;
    with_every_mesh(area_is_the_same);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edge_tables_of_any_mesh_agree),
        cmocka_unit_test(edge_tables_of_closed_meshes_agree),
        cmocka_unit_test(areas_agree),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
