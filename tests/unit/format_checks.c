/* Checks that the tests of the file formats share; see format_checks.h. */
#include "tests/unit/format_checks.h"

#include "reference/base/random.h"
#include "tests/unit/mesh_measures.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* A copy on the heap, without a terminator, so that the sanitizers see reads behind its end. */
static void *exact_copy(const void *bytes, size_t byte_count)
{
    void *copy = malloc(byte_count > 0 ? byte_count : 1);
    assert_non_null(copy);
    if (byte_count > 0)
        memcpy(copy, bytes, byte_count);
    return copy;
}

struct mesh read_text(const struct format_under_test *format, const char *text)
{
    struct mesh mesh;
    struct error err = {0};
    void *bytes = exact_copy(text, strlen(text));
    if (format->read(bytes, strlen(text), "file", &mesh, NULL, &err))
        fail_msg("refused: %s", err.text);
    assert_int_equal(mesh_check(&mesh, &err), 0);
    free(bytes);
    return mesh;
}

void assert_bytes_refused(const struct format_under_test *format, const void *bytes,
                          size_t byte_count, const char *error)
{
    struct mesh mesh;
    struct error err = {0};
    void *copy = exact_copy(bytes, byte_count);
    assert_int_equal(format->read(copy, byte_count, "file", &mesh, NULL, &err), -1);
    assert_string_equal(err.text, error);
    assert_null(mesh.positions);
    assert_null(mesh.triangles);
    assert_int_equal(mesh.vertex_count, 0);
    assert_int_equal(mesh.triangle_count, 0);
    free(copy);
}

void assert_refused(const struct format_under_test *format, const char *text, const char *error)
{
    assert_bytes_refused(format, text, strlen(text), error);
}

char *written(const struct format_under_test *format, const struct mesh *mesh, size_t *byte_count)
{
    char *bytes = NULL;
    FILE *out = open_memstream(&bytes, byte_count);
    assert_non_null(out);
    assert_int_equal(format->write(out, mesh, NULL), 0);
    assert_int_equal(fclose(out), 0);
    return bytes;
}

/* Every finite float is as likely as any other: tiny, huge, subnormal and both zeros. */
static void set_any_positions(struct mesh *mesh, struct random *rng)
{
    for (int64_t i = 0; i < 3 * (int64_t)mesh->vertex_count; i++)
        do {
            uint32_t bits = (uint32_t)random_next(rng);
            memcpy(mesh->positions + i, &bits, sizeof bits);
        } while (!isfinite(mesh->positions[i]));
    if (mesh->vertex_count > 0)
        mesh->positions[0] = -0.0F;
}

void assert_round_trips(const struct format_under_test *format)
{
    for (uint64_t seed = 0; seed < 150; seed++) {
        struct mesh mesh = random_mesh(seed), back;
        struct random rng;
        random_init(&rng, seed);
        if (seed % 2 == 1)
            set_any_positions(&mesh, &rng);
        if (seed == 0) {
            mesh_release(&mesh);
            assert_int_equal(mesh_init(&mesh, 0, 0, NULL), 0);
        }
        size_t byte_count;
        char *bytes = written(format, &mesh, &byte_count);
        struct error err = {0};
        if (format->read(bytes, byte_count, "file", &back, NULL, &err))
            fail_msg("seed %d: %s", (int)seed, err.text);
        assert_true(same_mesh(&mesh, &back));
        free(bytes);
        mesh_release(&mesh);
        mesh_release(&back);
    }
}

struct mesh read_told(const struct format_under_test *format, const void *bytes, size_t byte_count,
                      const char *note)
{
    struct mesh mesh;
    struct error err = {0};
    struct reading reading = {0};
    struct message message = {"", ""};
    void *copy = exact_copy(bytes, byte_count);
    if (note)
        assert_int_equal(format->read(copy, byte_count, "file", &mesh, NULL, NULL), -1);
    if (format->read(copy, byte_count, "file", &mesh, &reading, &err))
        fail_msg("refused: %s", err.text);
    assert_int_equal(mesh_check(&mesh, &err), 0);
    for (int kind = 0; kind < READING_KINDS; kind++)
        if (reading.notes[kind].count > 0) {
            assert_string_equal(message.en, ""); /* one at a time */
            reading_say(&reading, (enum reading_kind)kind, &message);
        }
    assert_string_equal(message.en, note ? note : "");
    free(copy);
    return mesh;
}

static void assert_refused_or_valid(const struct format_under_test *format, const void *bytes,
                                    size_t byte_count)
{
    struct mesh mesh;
    struct error err = {0};
    void *copy = exact_copy(bytes, byte_count);
    struct reading reading = {0}, *readings[] = {NULL, &reading};
    for (int i = 0; i < 2; i++) {
        err = (struct error){0};
        if (format->read(copy, byte_count, "file", &mesh, readings[i], &err) == 0)
            assert_int_equal(mesh_check(&mesh, NULL), 0);
        else
            assert_true(strncmp(err.text, "file:", 5) == 0);
        mesh_release(&mesh);
    }
    free(copy);
}

static void damage(struct random *rng, unsigned char *bytes, size_t byte_count)
{
    static const char likely[] = "0123456789-./ \n\r\\#e";
    for (uint64_t hits = 1 + random_below(rng, 4); hits > 0; hits--) {
        size_t at = (size_t)random_below(rng, byte_count);
        bytes[at] = random_below(rng, 2) == 0
                        ? (unsigned char)random_next(rng)
                        : (unsigned char)likely[random_below(rng, sizeof likely - 1)];
    }
}

void assert_survives_damage(const struct format_under_test *format, const void *bytes,
                            size_t byte_count)
{
    for (size_t length = 0; length < byte_count; length++)
        assert_refused_or_valid(format, bytes, length);
    for (uint64_t seed = 0; seed < 3000; seed++) {
        struct random rng;
        random_init(&rng, seed);
        unsigned char *damaged = exact_copy(bytes, byte_count);
        damage(&rng, damaged, byte_count);
        assert_refused_or_valid(format, damaged, byte_count);
        free(damaged);
    }
}

void assert_plain_rows_are_as_others(const struct format_under_test *format, const char *text)
{
    size_t byte_count = strlen(text);
    for (uint64_t seed = 0; seed < 6000; seed++) {
        struct random rng;
        random_init(&rng, seed);
        unsigned char *plain = exact_copy(text, byte_count), *others;
        if (seed > 0)
            damage(&rng, plain, byte_count);
        /* A vertical tab is a blank too, but not one of a plain row. */
        others = exact_copy(plain, byte_count);
        for (size_t i = 0; i < byte_count; i++)
            others[i] = others[i] == ' ' ? '\v' : others[i];
        struct mesh mesh, expected;
        struct error err = {0}, expected_err = {0};
        int result = format->read(plain, byte_count, "file", &mesh, NULL, &err);
        assert_int_equal(format->read(others, byte_count, "file", &expected, NULL, &expected_err),
                         result);
        assert_string_equal(err.text, expected_err.text);
        assert_true(same_mesh(&mesh, &expected));
        mesh_release(&mesh);
        mesh_release(&expected);
        free(plain);
        free(others);
    }
}
