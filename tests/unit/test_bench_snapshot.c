/* Mesh snapshots: what was written is read; every damage is refused. The meshes by name. */
#include "bench/compare/meshes.h"
#include "bench/compare/snapshot.h"
#include "reference/base/random.h"
#include "reference/formats/mesh_file.h"
#include "reference/mesh/generate.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

static char path[64];

static int make_path(void **state)
{
    (void)state;
    strcpy(path, "/tmp/meshgrade-snapshot.XXXXXX");
    int file = mkstemp(path);
    return file < 0 ? -1 : close(file);
}

static int remove_path(void **state)
{
    (void)state;
    return unlink(path);
}

static void write_grid(void)
{
    struct mesh mesh;
    assert_int_equal(generate_grid(&mesh, 7, 9, NULL), 0);
    assert_int_equal(snapshot_write(path, &mesh, NULL), 0);
    mesh_release(&mesh);
}

static void comes_back_with_its_counts(void **state)
{
    struct mesh mesh;
    struct snapshot snapshot;
    (void)state;
    assert_int_equal(generate_grid(&mesh, 7, 9, NULL), 0);
    assert_int_equal(snapshot_write(path, &mesh, NULL), 0);
    assert_int_equal(snapshot_read(path, &snapshot, NULL), 0);
    assert_int_equal(snapshot.mesh.vertex_count, 80);
    assert_int_equal(snapshot.mesh.triangle_count, 126);
    assert_memory_equal(snapshot.mesh.positions, mesh.positions, 12 * 80);
    assert_memory_equal(snapshot.mesh.triangles, mesh.triangles, 12 * 126);
    assert_int_equal(snapshot.edge_count, 80 + 126 - 1); /* V - E + F = 1: a disc */
    assert_int_equal(snapshot.boundary_edge_count, 2 * (7 + 9));
    assert_int_equal(snapshot.highest_valence, 6);
    mesh_release(&mesh);
    snapshot_release(&snapshot);
    snapshot_release(&snapshot);
    assert_int_equal(snapshot_read_counts(path, &snapshot, NULL), 0);
    assert_null(snapshot.mesh.positions);
    assert_int_equal(snapshot.mesh.triangle_count, 126);
}

static void empty_mesh_comes_back(void **state)
{
    struct mesh mesh = {0};
    struct snapshot snapshot;
    (void)state;
    assert_int_equal(snapshot_write(path, &mesh, NULL), 0);
    assert_int_equal(snapshot_read(path, &snapshot, NULL), 0);
    assert_int_equal(snapshot.mesh.triangle_count, 0);
    snapshot_release(&snapshot);
}

static void refuse(const char *bytes, size_t count)
{
    struct snapshot snapshot;
    struct error err = {""};
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, count, file), count);
    fclose(file);
    assert_int_equal(snapshot_read(path, &snapshot, &err), -1);
    assert_true(err.text[0]);
    assert_null(snapshot.memory);
}

/* Cut at every length, and every byte changed once: 64 + 12 * 80 + 12 * 126 of them. Only the
 * reserved bytes mean nothing. */
static void every_damage_is_refused(void **state)
{
    static char bytes[4096];
    struct random rng;
    (void)state;
    write_grid();
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    size_t count = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    assert_int_equal(count, 64 + 12 * 80 + 12 * 126);
    random_init(&rng, 1);
    for (size_t length = 0; length < count; length += 1 + length / 20)
        refuse(bytes, length);
    for (size_t at = 0; at < count; at++) {
        char was = bytes[at];
        if (at >= 56 && at < 64)
            continue;
        bytes[at] = (char)(was ^ (int)(1 + random_below(&rng, 255)));
        refuse(bytes, count);
        bytes[at] = was;
    }
    bytes[count] = 0;
    refuse(bytes, count + 1);
}

static void what_is_no_file_is_refused(void **state)
{
    struct snapshot snapshot;
    (void)state;
    assert_int_equal(snapshot_read("/tmp", &snapshot, NULL), -1);
    assert_int_equal(snapshot_read("/nonexistent", &snapshot, NULL), -1);
    assert_int_equal(snapshot_read("/dev/zero", &snapshot, NULL), -1);
}

static void names_say_what_is_made(void **state)
{
    static const char *const good[] = {"torus-100k-scrambled", "uv-sphere-2M-generated",
                                       "grid-1234-cache", "bunny-50k-generated"};
    static const char *const bad[] = {"",
                                      "torus",
                                      "torus-100k",
                                      "torus-0-generated",
                                      "torus--5-generated",
                                      "torus-100k-sorted",
                                      "cube-100k-generated",
                                      "torus-100k-generated-x",
                                      "torus-999999M-generated",
                                      "torus-99999999999999999999k-generated"};
    struct bench_mesh which;
    char name[48];
    (void)state;
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        assert_int_equal(bench_mesh_find(good[i], &which, NULL), 0);
        bench_mesh_name(&which, name, sizeof name);
        assert_string_equal(name, good[i]);
    }
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_int_equal(bench_mesh_find(bad[i], &which, NULL), -1);
}

/* A file is a mesh, too: named by what is in it. */
static void files_are_meshes(void **state)
{
    struct bench_mesh which, again;
    struct mesh mesh;
    struct error err = {""};
    char name[48];
    (void)state;
    if (bench_mesh_find("exercises/models/bunny.ply", &which, &err) != 0)
        fail_msg("%s", err.text);
    bench_mesh_name(&which, name, sizeof name);
    assert_int_equal(strncmp(name, "bunny-", 6), 0);
    assert_int_equal(strlen(name), strlen("bunny-01234567"));
    assert_int_equal(which.triangles, 3712);
    assert_false(which.is_irregular);
    assert_int_equal(bench_mesh_make(&which, "", &mesh, &err), 0);
    assert_int_equal(mesh.triangle_count, 3712);
    mesh_release(&mesh);
    assert_int_equal(bench_mesh_find("exercises/models/spider.ply", &again, NULL), 0);
    assert_true(again.is_irregular);
    /* The same name and another mesh in it are two meshes. */
    assert_int_equal(generate_cube(&mesh, NULL), 0);
    char file[sizeof path + 8];
    snprintf(file, sizeof file, "%s.off", path);
    char before[48];
    for (int round = 0; round < 2; round++) {
        assert_int_equal(mesh_file_write(file, &mesh, NULL), 0);
        assert_int_equal(bench_mesh_find(file, &again, NULL), 0);
        bench_mesh_name(&again, name, sizeof name);
        if (round == 1)
            assert_string_not_equal(name, before);
        memcpy(before, name, sizeof before);
        mesh.positions[0] = 0.25F;
    }
    mesh_release(&mesh);
    assert_int_equal(bench_mesh_make(&again, "", &mesh, NULL), 0);
    mesh_release(&mesh);
    FILE *empty = fopen(file, "w");
    assert_non_null(empty);
    fputs("OFF 0 0 0\n", empty);
    assert_int_equal(fclose(empty), 0);
    assert_int_equal(bench_mesh_find(file, &again, &err), -1);
    assert_non_null(strstr(err.text, "no triangle"));
    assert_int_equal(unlink(file), 0);
    assert_int_equal(bench_mesh_find("absent.ply", &again, NULL), -1);
}

/* Every kind in every order comes near to its size, and is closed or open as it says. */
static void kinds_come_near_their_size(void **state)
{
    (void)state;
    for (int kind = 0; kind < MESH_KIND_COUNT; kind++)
        for (int order = 0; order < MESH_ORDER_COUNT; order++) {
            struct bench_mesh which = {.kind = kind, .order = order, .triangles = 20000};
            struct snapshot snapshot;
            struct mesh mesh;
            struct error err = {""};
            if (bench_mesh_make(&which, "exercises/models", &mesh, &err) != 0)
                fail_msg("%s", err.text);
            assert_int_equal(mesh_check(&mesh, NULL), 0);
            assert_in_range(mesh.triangle_count, 10000, 40000);
            assert_int_equal(snapshot_write(path, &mesh, NULL), 0);
            assert_int_equal(snapshot_read_counts(path, &snapshot, NULL), 0);
            assert_int_equal(snapshot.boundary_edge_count == 0, mesh_kind_is_closed(kind));
            mesh_release(&mesh);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(comes_back_with_its_counts), cmocka_unit_test(empty_mesh_comes_back),
        cmocka_unit_test(every_damage_is_refused),    cmocka_unit_test(what_is_no_file_is_refused),
        cmocka_unit_test(names_say_what_is_made),     cmocka_unit_test(files_are_meshes),
        cmocka_unit_test(kinds_come_near_their_size),
    };
    return cmocka_run_group_tests(tests, make_path, remove_path);
}
