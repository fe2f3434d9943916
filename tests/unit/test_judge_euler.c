/* The judge of euler-closed-mesh: against the counts of real meshes. */
#include "graders/library/judge.h"
#include "reference/mesh/generate.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>

#include <cmocka.h>

extern const struct judge judge_euler_closed_mesh;

static int compare_edges(const void *left, const void *right)
{
    const int64_t *a = left, *b = right;
    return *a < *b ? -1 : *a > *b;
}

/* Undirected edges of a mesh, counted by sorting, without any formula. */
static int64_t count_edges(const struct mesh *mesh)
{
    int64_t corner_count = 3 * (int64_t)mesh->triangle_count, edge_count = 0;
    int64_t *keys = malloc((size_t)corner_count * sizeof *keys);
    assert_non_null(keys);
    for (int64_t i = 0; i < corner_count; i++) {
        int64_t a = mesh->triangles[i];
        int64_t b = mesh->triangles[i % 3 == 2 ? i - 2 : i + 1];
        keys[i] = a < b ? a << 32 | b : b << 32 | a;
    }
    qsort(keys, (size_t)corner_count, sizeof *keys, compare_edges);
    for (int64_t i = 0; i < corner_count; i++)
        edge_count += i == 0 || keys[i] != keys[i - 1];
    free(keys);
    return edge_count;
}

/* Whether the judge takes the three counts of the mesh as the answer to one of them. */
static bool judge_takes(int given, const int64_t counts[3])
{
    struct writer input = writer_growing(), answer = writer_growing();
    struct judgement judgement = {0};
    struct error err = {0};
    const int64_t row[2] = {given, counts[given]};
    write_int(&input, 1);
    write_array(&input, row, 1, sizeof row);
    write_int(&answer, 0);
    write_array(&answer, counts, 3, sizeof *counts);
    struct usage usage = {0};
    assert_int_equal(judge_answer(&judge_euler_closed_mesh, (struct span){input.bytes, input.count},
                                  (struct span){answer.bytes, answer.count}, &usage, &judgement,
                                  &err),
                     0);
    writer_release(&input);
    writer_release(&answer);
    scene_release(&judgement.scene);
    return judgement.accepted;
}

/* The judge's numbers are those of meshes whose edges were counted one by one. */
static void test_counts_of_generated_meshes(void **state)
{
    (void)state;
    for (int kind = 0; kind < 6; kind++) {
        struct mesh mesh = {0};
        struct error err = {0};
        int failed = kind == 0   ? generate_tetrahedron(&mesh, &err)
                     : kind == 1 ? generate_cube(&mesh, &err)
                     : kind == 2 ? generate_bipyramid(&mesh, 5, &err)
                     : kind == 3 ? generate_icosphere(&mesh, 3, &err)
                     : kind == 4 ? generate_uv_sphere(&mesh, 16, 14, &err)
                                 : generate_torus(&mesh, 1, 400, &err);
        assert_int_equal(failed, 0);
        const int64_t counts[3] = {mesh.vertex_count, count_edges(&mesh), mesh.triangle_count};
        for (int given = 0; given < 3; given++)
            assert_int_equal(judge_takes(given, counts), kind != 5); /* a torus is no sphere */
        mesh_release(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_counts_of_generated_meshes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
