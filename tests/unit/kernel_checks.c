#include "tests/unit/kernel_checks.h"

#include "reference/mesh/generate.h"
#include "tests/unit/mesh_measures.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { GUARD_BYTES = 64, GUARD = 0xA5, RUBBISH = 0x5A };

static char *make_guarded(size_t bytes)
{
    char *block = aligned_alloc(64, (bytes + 2 * GUARD_BYTES + 63) / 64 * 64);
    assert_non_null(block);
    memset(block, GUARD, GUARD_BYTES);
    memset(block + GUARD_BYTES, RUBBISH, bytes);
    memset(block + GUARD_BYTES + bytes, GUARD, GUARD_BYTES);
    return block + GUARD_BYTES;
}

static void assert_guarded(const char *inside, size_t bytes)
{
    for (size_t k = 0; k < GUARD_BYTES; k++)
        if ((unsigned char)inside[-1 - (ptrdiff_t)k] != GUARD ||
            (unsigned char)inside[bytes + k] != GUARD)
            fail_msg("written outside of %zu bytes, at a distance of %zu", bytes, k);
}

void free_guarded(void *output)
{
    free((char *)output - GUARD_BYTES);
}

/* With thread_count 0, as kernel->run does it. */
static void *run_between_guards(const struct kernel *kernel, const struct mesh *mesh,
                                int thread_count, int64_t *record_count)
{
    size_t scratch_bytes = kernel->scratch_bytes(mesh->vertex_count, mesh->triangle_count);
    size_t output_bytes = kernel->output_bytes(mesh->vertex_count, mesh->triangle_count);
    char *scratch = make_guarded(scratch_bytes), *output = make_guarded(output_bytes);
    *record_count = thread_count > 0 ? kernel->run_on_threads(mesh, scratch, output, thread_count)
                                     : kernel->run(mesh, scratch, output);
    assert_guarded(scratch, scratch_bytes);
    assert_guarded(output, output_bytes);
    free_guarded(scratch);
    return output;
}

void *run_guarded(const struct kernel *kernel, const struct mesh *mesh, int64_t *record_count)
{
    return run_between_guards(kernel, mesh, 0, record_count);
}

void *run_guarded_on_threads(const struct kernel *kernel, const struct mesh *mesh, int thread_count,
                             int64_t *record_count)
{
    return run_between_guards(kernel, mesh, thread_count, record_count);
}

struct answer {
    void *records;
    int64_t count;
    size_t record_bytes;
};

static void check_equals(const struct kernel *kernel, const struct mesh *mesh, int thread_count,
                         const struct answer *right)
{
    int64_t count;
    void *output = run_between_guards(kernel, mesh, thread_count, &count);
    if (count != right->count ||
        memcmp(output, right->records, (size_t)count * right->record_bytes) != 0)
        fail_msg("%s %s (%d) differs from plain: %d vertices, %d triangles, %lld records for %lld",
                 kernel->name, kernel->variant, thread_count, mesh->vertex_count,
                 mesh->triangle_count, (long long)count, (long long)right->count);
    free_guarded(output);
}

void check_variants_equal(const char *name, const struct mesh *mesh, size_t record_bytes)
{
    static const int thread_counts[] = {1, 2, 3, 7};
    struct answer right = {.record_bytes = record_bytes};
    right.records = run_guarded(kernel_find(name, "plain"), mesh, &right.count);
    for (const struct kernel *k = kernel_table; k->name; k++) {
        if (strcmp(k->name, name) != 0 || !k->available())
            continue;
        check_equals(k, mesh, 0, &right);
        for (size_t i = 0; k->run_on_threads && i < 4; i++)
            check_equals(k, mesh, thread_counts[i], &right);
    }
    free_guarded(right.records);
}

/* The mesh as it is and in worse and worse states; takes the mesh. */
static void with_changes(struct mesh *mesh, void (*check)(const struct mesh *mesh))
{
    uint64_t seed = (uint64_t)mesh->triangle_count;
    check(mesh);
    assert_int_equal(change_scramble(mesh, seed, NULL), 0);
    check(mesh);
    assert_int_equal(change_adversarial_numbering(mesh, seed + 1, NULL), 0);
    check(mesh);
    assert_int_equal(change_flip(mesh, 0.5, seed + 2, NULL), 0);
    check(mesh);
    if (mesh->triangle_count > 0) {
        int64_t some = mesh->triangle_count / 8 + 1;
        assert_int_equal(change_add_isolated_vertices(mesh, some, seed + 3, NULL), 0);
        assert_int_equal(change_add_duplicate_triangles(mesh, some, seed + 4, NULL), 0);
        check(mesh);
        assert_int_equal(change_add_degenerate_triangles(mesh, some, seed + 5, NULL), 0);
        check(mesh);
    }
    mesh_release(mesh);
}

static void with_generated(void (*check)(const struct mesh *mesh))
{
    struct mesh m;
    int (*const fixed[])(struct mesh *, struct error *) = {generate_empty, generate_one_triangle,
                                                           generate_tetrahedron, generate_cube,
                                                           generate_two_cubes};
    for (size_t k = 0; k < sizeof fixed / sizeof *fixed; k++) {
        assert_int_equal(fixed[k](&m, NULL), 0);
        with_changes(&m, check);
    }
    int (*const sized[])(struct mesh *, int64_t, struct error *) = {
        generate_fan, generate_bipyramid, generate_moebius, generate_two_cones, generate_book};
    for (size_t k = 0; k < sizeof sized / sizeof *sized; k++)
        for (int64_t size = 3; size < 40; size += 1 + size / 12) {
            assert_int_equal(sized[k](&m, size, NULL), 0);
            with_changes(&m, check);
        }
    assert_int_equal(generate_grid(&m, 13, 17, NULL), 0);
    with_changes(&m, check);
    assert_int_equal(generate_uv_sphere(&m, 33, 7, NULL), 0);
    with_changes(&m, check);
    assert_int_equal(generate_icosphere(&m, 3, NULL), 0);
    with_changes(&m, check);
    assert_int_equal(generate_torus(&m, 2, 1000, NULL), 0);
    with_changes(&m, check);
    assert_int_equal(generate_needles(&m, 100, 1e-6, 1, NULL), 0);
    with_changes(&m, check);
}

/* Every number of triangles up to some vectors, none sharing anything. */
static void with_small_soups(void (*check)(const struct mesh *mesh))
{
    for (int64_t triangles = 1; triangles <= 70; triangles++) {
        struct mesh m;
        assert_int_equal(generate_soup(&m, triangles, (uint64_t)triangles, NULL), 0);
        check(&m);
        mesh_release(&m);
    }
}

/* So large that tables count as scattered, and one vertex of a valence of 10^5. */
static void with_large(void (*check)(const struct mesh *mesh))
{
    struct mesh m;
    assert_int_equal(generate_torus(&m, 1, 50000, NULL), 0);
    with_changes(&m, check);
    assert_int_equal(generate_grid(&m, 150, 150, NULL), 0);
    with_changes(&m, check);
    assert_int_equal(generate_fan(&m, 100000, NULL), 0);
    with_changes(&m, check);
    assert_int_equal(generate_bipyramid(&m, 20000, NULL), 0);
    with_changes(&m, check);
    assert_int_equal(generate_book(&m, 20000, NULL), 0);
    with_changes(&m, check);
}

/* Scattered over so many vertices that kernels sort by parts of them first; with vertices of a high
 * valence, boundaries, and a few triangles of every bad kind. */
static void with_parts(void (*check)(const struct mesh *mesh))
{
    struct mesh m, other;
    assert_int_equal(generate_torus(&m, 1, 270000, NULL), 0);
    assert_int_equal(generate_bipyramid(&other, 10000, NULL), 0);
    assert_int_equal(change_append(&m, &other, 1, 0, 0, NULL), 0);
    mesh_release(&other);
    assert_int_equal(change_scramble(&m, 5, NULL), 0);
    check(&m);
    assert_int_equal(change_flip(&m, 0.25, 6, NULL), 0);
    assert_int_equal(change_remove_triangles(&m, 1000, 7, NULL), 0);
    assert_int_equal(change_add_duplicate_triangles(&m, 1000, 8, NULL), 0);
    assert_int_equal(change_add_degenerate_triangles(&m, 1000, 9, NULL), 0);
    check(&m);
    mesh_release(&m);
}

/* Few vertices and many triangles: every row overflows. */
static void with_crowded(void (*check)(const struct mesh *mesh))
{
    for (int32_t vertices = 3; vertices <= 60; vertices += 19) {
        struct mesh m;
        assert_int_equal(mesh_init(&m, vertices, 5000, NULL), 0);
        for (int32_t k = 0; k < 15000; k++)
            m.triangles[k] = (int32_t)((uint32_t)k * UINT32_C(2654435761) >> 7) % vertices;
        check(&m);
        mesh_release(&m);
    }
}

void with_every_mesh(void (*check)(const struct mesh *mesh))
{
    with_generated(check);
    with_small_soups(check);
    with_crowded(check);
    for (uint64_t seed = 0; seed < 200; seed++) {
        struct mesh m = random_mesh(seed);
        check(&m);
        mesh_release(&m);
    }
    with_large(check);
    with_parts(check);
}
