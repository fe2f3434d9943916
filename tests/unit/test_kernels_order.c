/* Strips and orders for the vertex cache: every triangle once, with its winding, and short. */
#include "reference/formats/mesh_file.h"
#include "reference/kernels/stripify.h"
#include "reference/kernels/vertex_cache.h"
#include "reference/mesh/edges.h"
#include "reference/mesh/generate.h"
#include "tests/unit/kernel_checks.h"
#include "tests/unit/mesh_measures.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void *table(size_t count, size_t size)
{
    void *made = calloc(count + 1, size);
    assert_non_null(made);
    return made;
}

/* -- strips ----------------------------------------------------------------------------------- */

static int by_corners(const void *a, const void *b)
{
    return memcmp(a, b, 3 * sizeof(int32_t));
}

/* The triangles that are not degenerate, each from its least corner on, in one order. */
static int32_t *sorted_triangles(const int32_t *triangles, int64_t count, int64_t *kept)
{
    int32_t *sorted = table((size_t)count, 12);
    *kept = 0;
    for (int64_t t = 0; t < count; t++) {
        const int32_t *c = triangles + 3 * t;
        if (triangle_is_degenerate(c))
            continue;
        int least = c[0] < c[1] && c[0] < c[2] ? 0 : c[1] < c[2] ? 1 : 2;
        for (int corner = 0; corner < 3; corner++)
            sorted[3 * *kept + corner] = c[(least + corner) % 3];
        ++*kept;
    }
    qsort(sorted, (size_t)*kept, 12, by_corners);
    return sorted;
}

static void assert_same_triangles(const struct mesh *mesh, const int32_t *triangles, int64_t count)
{
    int64_t expected_count, found_count;
    int32_t *expected = sorted_triangles(mesh->triangles, mesh->triangle_count, &expected_count);
    int32_t *found = sorted_triangles(triangles, count, &found_count);
    assert_int_equal(found_count, expected_count);
    assert_memory_equal(found, expected, 12 * (size_t)expected_count);
    free(expected);
    free(found);
}

static void kernel_holds_each_triangle_once(const char *kernel, const struct mesh *mesh)
{
    int64_t count;
    int32_t *indices = run_guarded(kernel_find(kernel, "plain"), mesh, &count);
    assert_true(count <= 4 * (int64_t)mesh->triangle_count);
    int32_t *triangles = table(3 * (size_t)count, sizeof *triangles);
    int64_t triangle_count = strips_triangles(indices, count, triangles);
    assert_same_triangles(mesh, triangles, triangle_count);

    int32_t *joined = table(2 * (size_t)count, sizeof *joined);
    int64_t joined_count = strips_join(indices, count, joined);
    assert_true(joined_count <= 2 * count);
    int32_t *again = table(3 * (size_t)joined_count, sizeof *again);
    for (int64_t i = 0; i < joined_count; i++)
        assert_true(joined[i] >= 0 && joined[i] < mesh->vertex_count);
    assert_int_equal(strips_triangles(joined, joined_count, again), triangle_count);
    assert_memory_equal(again, triangles, 12 * (size_t)triangle_count);
    free(again);
    free(joined);
    free(triangles);
    free_guarded(indices);
    check_variants_equal(kernel, mesh, sizeof(int32_t));
}

static void strips_hold_each_triangle_once(const struct mesh *mesh)
{
    kernel_holds_each_triangle_once("stripify", mesh);
    kernel_holds_each_triangle_once("strips-in-order", mesh);
}

static void every_triangle_is_in_one_strip(void **state)
{
    (void)state;
    with_every_mesh(strips_hold_each_triangle_once);
    for (uint64_t seed = 0; seed < 200; seed++) {
        struct mesh mesh = random_mesh(seed);
        strips_hold_each_triangle_once(&mesh);
        mesh_release(&mesh);
    }
}

static double indices_per_triangle(const struct mesh *mesh)
{
    int64_t count;
    free_guarded(run_guarded(kernel_find("stripify", "plain"), mesh, &count));
    return (double)count / (double)mesh->triangle_count;
}

static void small_strips_are_those_of_the_picture(void **state)
{
    (void)state;
    struct mesh row;
    assert_int_equal(generate_grid(&row, 1, 4, NULL), 0);
    assert_true(indices_per_triangle(&row) == 10.0 / 8.0); /* one strip, no turn aside */
    mesh_release(&row);
    const int32_t strip[5] = {0, 1, 2, 3, 4}, triangles[9] = {0, 1, 2, 2, 1, 3, 2, 3, 4};
    int32_t found[15];
    assert_int_equal(strips_triangles(strip, 5, found), 3);
    assert_same_triangles(&(struct mesh){.triangles = found, .triangle_count = 3}, triangles, 3);
    const int32_t two[8] = {0, 1, 2, 3, STRIP_RESTART, 4, 5, 6};
    const int32_t even[9] = {0, 1, 2, 3, 3, 4, 4, 5, 6};
    int32_t joined[16];
    assert_int_equal(strips_join(two, 8, joined), 9);
    assert_memory_equal(joined, even, sizeof even);
    const int32_t odd[9] = {0, 1, 2, 2, 4, 4, 4, 5, 6};
    const int32_t three[7] = {0, 1, 2, STRIP_RESTART, 4, 5, 6};
    assert_int_equal(strips_join(three, 7, joined), 9);
    assert_memory_equal(joined, odd, sizeof odd);
}

static struct mesh model(const char *name)
{
    char path[100];
    struct mesh mesh;
    snprintf(path, sizeof path, "exercises/models/%s.ply", name);
    assert_int_equal(mesh_file_read(path, &mesh, NULL), 0);
    return mesh;
}

/* The bounds are a little above what was measured; meshoptimizer 0.18, after its own ordering for
 * strips: 1.022 (torus of 100,000 triangles), 1.555 (bunny), 1.542 (spider). */
static void strips_are_long_in_any_order(void **state)
{
    (void)state;
    struct mesh torus, bunny = model("bunny"), spider = model("spider");
    assert_int_equal(generate_torus(&torus, 1, 20000, NULL), 0);
    for (int pass = 0; pass < 2; pass++) {
        assert_true(indices_per_triangle(&torus) < 1.02);
        assert_true(indices_per_triangle(&bunny) < 1.45);
        assert_true(indices_per_triangle(&spider) < 1.54);
        assert_int_equal(change_scramble(&torus, 1, NULL), 0);
        assert_int_equal(change_scramble(&bunny, 2, NULL), 0);
        assert_int_equal(change_scramble(&spider, 3, NULL), 0);
    }
    mesh_release(&torus);
    mesh_release(&bunny);
    mesh_release(&spider);
}

/* -- the vertex cache ------------------------------------------------------------------------- */

static int64_t misses(const struct mesh *mesh, int64_t cache_size)
{
    int64_t *scratch = table((size_t)mesh->vertex_count, sizeof *scratch);
    int64_t count = vertex_cache_misses(mesh, cache_size, scratch);
    free(scratch);
    return count;
}

/* A queue, looked through from end to end. */
static int64_t plain_misses(const struct mesh *mesh, int64_t cache_size)
{
    int32_t *queue = table((size_t)cache_size, sizeof *queue);
    memset(queue, -1, (size_t)cache_size * sizeof *queue);
    int64_t count = 0;
    for (int64_t i = 0; i < 3 * (int64_t)mesh->triangle_count; i++) {
        bool is_held = false;
        for (int64_t place = 0; place < cache_size; place++)
            is_held |= queue[place] == mesh->triangles[i];
        if (!is_held)
            queue[count++ % cache_size] = mesh->triangles[i];
    }
    free(queue);
    return count;
}

static int by_row(const void *a, const void *b)
{
    const int32_t *x = a, *y = b;
    for (int corner = 0; corner < 2; corner++)
        if (x[corner] != y[corner])
            return x[corner] < y[corner] ? -1 : 1;
    return (x[2] > y[2]) - (x[2] < y[2]);
}

static void order_is_a_permutation(const struct mesh *mesh)
{
    int64_t count;
    size_t bytes = 12 * (size_t)mesh->triangle_count;
    int32_t *triangles = run_guarded(kernel_find("vertex-cache", "plain"), mesh, &count);
    int32_t *expected = table((size_t)mesh->triangle_count, 12);
    assert_int_equal(count, mesh->triangle_count);
    if (bytes > 0)
        memcpy(expected, mesh->triangles, bytes);
    qsort(expected, (size_t)count, 12, by_row);
    qsort(triangles, (size_t)count, 12, by_row);
    assert_memory_equal(triangles, expected, bytes);
    free(expected);
    free_guarded(triangles);

    int32_t *number = run_guarded(kernel_find("vertex-fetch", "plain"), mesh, &count);
    uint8_t *is_taken = table((size_t)mesh->vertex_count, 1);
    assert_int_equal(count, mesh->vertex_count);
    for (int64_t v = 0; v < count; v++) {
        assert_true(number[v] >= 0 && number[v] < count && !is_taken[number[v]]);
        is_taken[number[v]] = 1;
    }
    int32_t used = 0; /* numbers below it have come up */
    for (int64_t i = 0; i < 3 * (int64_t)mesh->triangle_count; i++) {
        assert_true(number[mesh->triangles[i]] <= used);
        used += number[mesh->triangles[i]] == used;
    }
    free(is_taken);
    free_guarded(number);
}

static void every_triangle_and_vertex_comes_once(void **state)
{
    (void)state;
    with_every_mesh(order_is_a_permutation);
}

static void misses_are_those_of_a_queue(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 60; seed++) {
        struct mesh mesh = random_mesh(seed);
        for (int64_t size = 1; size < 40; size += 6)
            assert_int_equal(misses(&mesh, size), plain_misses(&mesh, size));
        mesh_release(&mesh);
    }
}

static double ratio(const struct mesh *mesh)
{
    return (double)misses(mesh, VERTEX_CACHE_SIZE) / (double)mesh->triangle_count;
}

static void ordered_meshes_miss_little(void **state)
{
    (void)state;
    struct mesh torus, bunny = model("bunny");
    assert_int_equal(generate_torus(&torus, 1, 20000, NULL), 0);
    for (int pass = 0; pass < 2; pass++) {
        uint64_t hash = surface_hash(&bunny);
        assert_int_equal(vertex_cache_order(&torus, NULL), 0);
        assert_int_equal(vertex_cache_order(&bunny, NULL), 0);
        assert_int_equal(mesh_check(&bunny, NULL), 0);
        assert_true(surface_hash(&bunny) == hash);
        assert_true(ratio(&torus) < 0.63); /* the paper: 0.6 to 0.7 */
        assert_true(ratio(&bunny) < 0.72);
        assert_int_equal(change_scramble(&torus, 1, NULL), 0);
        assert_int_equal(change_scramble(&bunny, 2, NULL), 0);
        assert_true(ratio(&torus) > 2.9);
    }
    mesh_release(&torus);
    mesh_release(&bunny);
    struct mesh empty = {0};
    assert_int_equal(vertex_cache_order(&empty, NULL), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_triangle_is_in_one_strip),
        cmocka_unit_test(small_strips_are_those_of_the_picture),
        cmocka_unit_test(strips_are_long_in_any_order),
        cmocka_unit_test(every_triangle_and_vertex_comes_once),
        cmocka_unit_test(misses_are_those_of_a_queue),
        cmocka_unit_test(ordered_meshes_miss_little),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
