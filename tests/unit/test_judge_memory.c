/* The judges of the memory exercises: known submissions, what they must accept in any order, what
 * they must never accept, and what they say of it. */
#include "graders/library/judge.h"
#include "reference/base/random.h"
#include "tests/unit/answers.h"
#include "tests/unit/submissions.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

extern const struct judge judge_memory_indexed_grid, judge_memory_strips,
    judge_memory_voxels_vs_mesh;

/* ----------------------------------------------------------------- answers */

/* One case with the reference's answer, which the tests change. */
struct sample {
    const struct judge *judge;
    struct writer input;
    struct submission_answer answer;
};

static void sample_take(struct sample *sample, const struct judge *judge, const char *case_name)
{
    char source[128];
    struct submission reference;
    struct error err = {0};
    *sample = (struct sample){.judge = judge, .input = writer_growing()};
    size_t i = 0;
    while (i < judge->case_count && strcmp(judge->cases[i].name, case_name) != 0)
        i++;
    assert_true(i < judge->case_count);
    assert_int_equal(judge_make(judge, &judge->cases[i], "exercises/models", &sample->input, &err),
                     0);
    snprintf(source, sizeof source, "reference/answers/memory/%s.c", judge->exercise);
    submission_build(&reference, "memory", judge->exercise, source);
    struct span input = {sample->input.bytes, sample->input.count};
    submission_run(&reference, input, judge_answer_bound(judge, input), 0, &sample->answer);
    submission_release(&reference);
    assert_int_equal(sample->answer.end, SUBMISSION_ANSWERED);
}

static void sample_release(struct sample *sample)
{
    submission_answer_release(&sample->answer);
    writer_release(&sample->input);
}

/* Judges the answer as it stands now. Release the judgement's scene. */
static void judge_sample(const struct sample *sample, struct judgement *judgement)
{
    struct span input = {sample->input.bytes, sample->input.count};
    struct span said = {sample->answer.bytes, sample->answer.count};
    struct error err = {0};
    memset(judgement, 0, sizeof *judgement);
    assert_int_equal(
        judge_answer(sample->judge, input, said, &sample->answer.usage, judgement, &err), 0);
}

/* Returns the cause of a rejection, "" when it was accepted. */
static const char *verdict_on(const struct sample *sample)
{
    static struct judgement judgement;
    judge_sample(sample, &judgement);
    scene_release(&judgement.scene);
    return judgement.accepted ? "" : judgement.cause;
}

/* The tables of a built mesh in an answer: status, vertices, triangles, own formula. */
struct tables {
    float *vertices;
    int32_t *triangles;
    int64_t vertex_count, triangle_count;
};

static struct tables tables_of(const struct sample *sample)
{
    unsigned char *bytes = sample->answer.bytes;
    struct reader reader = reader_of(bytes, sample->answer.count);
    struct tables tables;
    assert_int_equal(read_int(&reader), 0);
    assert_non_null(read_table(&reader, &tables.vertex_count, 12));
    size_t after_vertices = reader.at;
    assert_non_null(read_table(&reader, &tables.triangle_count, 12));
    assert_false(reader.failed);
    tables.vertices = (float *)(void *)(bytes + 24);
    tables.triangles = (int32_t *)(void *)(bytes + after_vertices + 16);
    return tables;
}

/* Renumbers the vertices, permutes the triangles and rotates their corners. */
static void scramble(struct tables *tables, uint64_t seed)
{
    struct random rng;
    random_init(&rng, seed);
    struct mesh copy;
    struct error err = {0};
    int32_t vertex_count = (int32_t)tables->vertex_count;
    int32_t triangle_count = (int32_t)tables->triangle_count;
    int32_t *order = malloc(sizeof *order * (size_t)(vertex_count + triangle_count));
    assert_non_null(order);
    assert_int_equal(mesh_init(&copy, vertex_count, triangle_count, &err), 0);
    memcpy(copy.positions, tables->vertices, 12 * (size_t)vertex_count);
    memcpy(copy.triangles, tables->triangles, 12 * (size_t)triangle_count);
    random_permutation(&rng, order, vertex_count);
    for (int32_t v = 0; v < vertex_count; v++)
        memcpy(tables->vertices + 3 * order[v], copy.positions + 3 * v, 12);
    for (int64_t i = 0; i < 3 * tables->triangle_count; i++)
        copy.triangles[i] = order[copy.triangles[i]];
    random_permutation(&rng, order, triangle_count);
    for (int32_t t = 0; t < triangle_count; t++) {
        int32_t turn = (int32_t)random_below(&rng, 3);
        for (int32_t i = 0; i < 3; i++)
            tables->triangles[3 * order[t] + i] = copy.triangles[3 * t + (i + turn) % 3];
    }
    mesh_release(&copy);
    free(order);
}

struct built_case {
    const struct judge *judge;
    const char *name;
};
static const struct built_case built_cases[] = {{&judge_memory_indexed_grid, "wide-grid"},
                                                {&judge_memory_indexed_grid, "two-cells-a-side"},
                                                {&judge_memory_indexed_grid, "tall-grid-triangles"},
                                                {&judge_memory_indexed_grid, "one-row"},
                                                {&judge_memory_voxels_vs_mesh, "vertices-16"},
                                                {&judge_memory_voxels_vs_mesh, "triangles-3"},
                                                {&judge_memory_voxels_vs_mesh, "triangles-6"},
                                                {&judge_memory_voxels_vs_mesh, "triangles-16"}};
enum { BUILT_CASES = sizeof built_cases / sizeof *built_cases };

static void test_any_numbering_is_right(void **state)
{
    (void)state;
    for (int i = 0; i < BUILT_CASES; i++) {
        struct sample sample;
        sample_take(&sample, built_cases[i].judge, built_cases[i].name);
        for (uint64_t seed = 1; seed <= 20; seed++) {
            struct tables tables = tables_of(&sample);
            scramble(&tables, seed);
            assert_string_equal(verdict_on(&sample), "");
        }
        sample_release(&sample);
    }
}

/* Whether a triangle has two corners at the same place, as the flat ones at the poles. */
static bool is_flat(const struct tables *tables, int64_t t)
{
    const int32_t *corner = tables->triangles + 3 * t;
    for (int i = 0; i < 3; i++) {
        const float *a = tables->vertices + 3 * (int64_t)corner[i];
        const float *b = tables->vertices + 3 * (int64_t)corner[(i + 1) % 3];
        if (fabsf(a[0] - b[0]) + fabsf(a[1] - b[1]) + fabsf(a[2] - b[2]) < 1e-6F)
            return true;
    }
    return false;
}

/* Every single triangle matters: turned over, listed for another, or with one corner moved on. */
static void test_every_triangle_is_looked_at(void **state)
{
    (void)state;
    for (int i = 0; i < BUILT_CASES; i++) {
        struct sample sample;
        sample_take(&sample, built_cases[i].judge, built_cases[i].name);
        struct tables tables = tables_of(&sample);
        bool vertices_only = strcmp(built_cases[i].name, "wide-grid") == 0 ||
                             strncmp(built_cases[i].name, "vertices", 8) == 0;
        for (int64_t t = 0; t < tables.triangle_count && !vertices_only; t++) {
            int32_t *corner = tables.triangles + 3 * t, old[3];
            memcpy(old, corner, sizeof old);
            corner[1] = old[2];
            corner[2] = old[1];
            assert_string_equal(verdict_on(&sample), is_flat(&tables, t) ? "" : "triangle-flipped");
            memcpy(corner, tables.triangles + 3 * ((t + 1) % tables.triangle_count), sizeof old);
            assert_string_not_equal(verdict_on(&sample), "");
            memcpy(corner, old, sizeof old);
            corner[0] = (int32_t)((old[0] + 1) % tables.vertex_count);
            assert_string_not_equal(verdict_on(&sample), "");
            corner[0] = (int32_t)tables.vertex_count;
            assert_string_equal(verdict_on(&sample), "index-out-of-range");
            memcpy(corner, old, sizeof old);
        }
        assert_string_equal(verdict_on(&sample), "");
        sample_release(&sample);
    }
}

/* Every single coordinate matters, and NaN is never accepted. */
static void test_every_coordinate_is_looked_at(void **state)
{
    (void)state;
    static const struct built_case vertex_cases[] = {{&judge_memory_indexed_grid, "wide-grid"},
                                                     {&judge_memory_voxels_vs_mesh, "vertices-6"}};
    for (int c = 0; c < 2; c++) {
        struct sample sample;
        sample_take(&sample, vertex_cases[c].judge, vertex_cases[c].name);
        struct tables tables = tables_of(&sample);
        for (int64_t i = 0; i < 3 * tables.vertex_count; i++) {
            float old = tables.vertices[i];
            const float wrong[] = {NAN, INFINITY, -INFINITY, old + 2e-5F, old - 2e-5F, 1e30F};
            for (size_t w = 0; w < sizeof wrong / sizeof *wrong; w++) {
                tables.vertices[i] = wrong[w];
                assert_string_not_equal(verdict_on(&sample), "");
            }
            tables.vertices[i] = old + 5e-6F;
            assert_string_equal(verdict_on(&sample), "");
            tables.vertices[i] = old;
        }
        sample_release(&sample);
    }
}

/* Every single bit of the voxels matters, the unused ones too. */
static void test_every_bit_is_looked_at(void **state)
{
    (void)state;
    static const char *const names[] = {"voxels-1", "voxels-3", "voxels-4", "voxels-16"};
    for (int c = 0; c < 4; c++) {
        struct sample sample;
        sample_take(&sample, &judge_memory_voxels_vs_mesh, names[c]);
        struct reader reader = reader_of(sample.answer.bytes, sample.answer.count);
        int64_t byte_count;
        assert_int_equal(read_int(&reader), 0);
        assert_non_null(read_table(&reader, &byte_count, 1));
        uint8_t *bits = sample.answer.bytes + 24;
        for (int64_t bit = 0; bit < 8 * byte_count; bit++) {
            bits[bit / 8] ^= (uint8_t)(1 << bit % 8);
            assert_string_not_equal(verdict_on(&sample), "");
            bits[bit / 8] ^= (uint8_t)(1 << bit % 8);
        }
        assert_string_equal(verdict_on(&sample), "");
        sample_release(&sample);
    }
}

/* Every coordinate of every strip matters, and strips may stand in any order. */
static void test_every_strip_is_looked_at(void **state)
{
    (void)state;
    enum { STRIPS = 3, VERTICES = 36, STRIP_BYTES = 16 + 12 * VERTICES };
    struct sample sample;
    sample_take(&sample, &judge_memory_strips, "wide-grid");
    unsigned char *first = sample.answer.bytes + sample.answer.count - STRIPS * STRIP_BYTES;
    for (int i = 0; i < STRIPS * 3 * VERTICES; i++) {
        float *at =
            (float *)(void *)(first + i / (3 * VERTICES) * STRIP_BYTES + 16) + i % (3 * VERTICES);
        float old = *at;
        const float wrong[] = {NAN, INFINITY, old + 2e-5F, old - 2e-5F};
        for (size_t w = 0; w < sizeof wrong / sizeof *wrong; w++) {
            *at = wrong[w];
            assert_string_equal(verdict_on(&sample), "vertex-off-grid");
        }
        *at = old;
    }
    unsigned char held[STRIP_BYTES];
    memcpy(held, first, sizeof held);
    memmove(first, first + STRIP_BYTES, (STRIPS - 1) * STRIP_BYTES);
    memcpy(first + (STRIPS - 1) * STRIP_BYTES, held, sizeof held);
    assert_string_equal(verdict_on(&sample), "");
    memcpy(first, held, sizeof held); /* one strip twice, another not at all */
    assert_string_equal(verdict_on(&sample), "triangle-repeated");
    sample_release(&sample);
}

/* ------------------------------------------------------------------- words */

/* What is named stays the first fault, whatever comes after it. */
static void test_the_first_fault_is_named(void **state)
{
    (void)state;
    struct sample sample;
    struct judgement judgement;
    sample_take(&sample, &judge_memory_indexed_grid, "tall-grid-triangles");
    struct tables tables = tables_of(&sample);
    int32_t *flipped = tables.triangles + 9, held = flipped[0];
    flipped[0] = flipped[1];
    flipped[1] = held;
    tables.triangles[15] = -7;
    judge_sample(&sample, &judgement);
    char en[64], es[64];
    snprintf(en, sizeof en, "triangle 3 (%d, %d, %d)", flipped[0], flipped[1], flipped[2]);
    snprintf(es, sizeof es, "triángulo 3 (%d, %d, %d)", flipped[0], flipped[1], flipped[2]);
    assert_string_equal(judgement.cause, "triangle-flipped");
    assert_string_equal(judgement.cause_name.es, "triángulo invertido");
    assert_string_equal(judgement.element.en, en);
    assert_string_equal(judgement.element.es, es);
    assert_non_null(strstr(judgement.message.en, "counter-clockwise, seen from above."));
    assert_non_null(strstr(judgement.message.es, "antihorario, vistos desde arriba."));
    assert_int_equal(judgement.scene.mark_count[MARK_FLIPPED], 1);
    scene_release(&judgement.scene);
    sample_release(&sample);
}

/* Counts without tables: what a wrong one would be right for is told. */
static void test_wrong_counts_are_explained(void **state)
{
    (void)state;
    static const struct {
        const struct judge *judge;
        const char *name;
        int64_t vertices, triangles;
        const char *cause, *en, *es;
    } answers[] = {
        {&judge_memory_indexed_grid, "course-figure", 40, 64, "vertex-count",
         "vertex_count is 40; it must be 45. There are m + 1 rows of n + 1 vertices.",
         "vertex_count es 40; tiene que ser 45. Hay m + 1 filas de n + 1 vértices."},
        {&judge_memory_indexed_grid, "course-figure", 45, INT64_MIN, "triangle-count", NULL, NULL},
        {&judge_memory_indexed_grid, "course-figure", 45, 64, "table-missing", "vertices is NULL.",
         "vertices es NULL."},
        {&judge_memory_voxels_vs_mesh, "vertices-6", 26, 60, "shared-poles", NULL, NULL},
        {&judge_memory_voxels_vs_mesh, "vertices-6", 42, 60, "meridian-stored-twice", NULL, NULL},
        {&judge_memory_voxels_vs_mesh, "vertices-6", 49, 60, "meridian-stored-twice", NULL, NULL},
        {&judge_memory_voxels_vs_mesh, "vertices-6", -1, -1, "vertex-count", NULL, NULL}};
    for (size_t i = 0; i < sizeof answers / sizeof *answers; i++) {
        struct sample sample;
        struct judgement judgement;
        sample_take(&sample, answers[i].judge, answers[i].name);
        struct writer writer = writer_into(sample.answer.bytes, sample.answer.count);
        write_int(&writer, 0);
        write_table(&writer, NULL, answers[i].vertices, 12);
        write_table(&writer, NULL, answers[i].triangles, 12);
        write_int(&writer, 0);
        judge_sample(&sample, &judgement);
        assert_false(judgement.accepted);
        assert_string_equal(judgement.cause, answers[i].cause);
        if (answers[i].en) {
            assert_string_equal(judgement.message.en, answers[i].en);
            assert_string_equal(judgement.message.es, answers[i].es);
        }
        scene_release(&judgement.scene);
        sample_release(&sample);
    }
}

/* ----------------------------------------------------------------- numbers */

static void test_numbers_are_exact_to_two_decimals(void **state)
{
    (void)state;
    static const struct {
        const struct judge *judge;
        const char *name;
        double right, rounded;
    } cases[] = {{&judge_memory_indexed_grid, "kilobytes-of-128", 592908.0 / 1024, 579.01},
                 {&judge_memory_indexed_grid, "limit-of-faces", 2, 2.0001},
                 {&judge_memory_strips, "kilobytes-of-128", 397316.0 / 1024, 388.00},
                 {&judge_memory_strips, "limit-of-memory", 1.5, 1.4999},
                 {&judge_memory_strips, "limit-of-time", 2, 1.9999},
                 {&judge_memory_voxels_vs_mesh, "voxel-kilobytes-of-16", 0.5, 0.50},
                 {&judge_memory_voxels_vs_mesh, "mesh-kilobytes-of-16", 8.625, 8.63},
                 {&judge_memory_voxels_vs_mesh, "voxel-megabytes-of-1024", 128, 128},
                 {&judge_memory_voxels_vs_mesh, "mesh-megabytes-of-1024", 35.9765625, 35.98},
                 {&judge_memory_voxels_vs_mesh, "smallest-k", 288, 288}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct sample sample;
        sample_take(&sample, cases[i].judge, cases[i].name);
        double said;
        memcpy(&said, sample.answer.bytes, sizeof said);
        assert_true(said == cases[i].right);
        memcpy(sample.answer.bytes, &cases[i].rounded, sizeof said);
        assert_string_equal(verdict_on(&sample), "");
        const double wrong[] = {(double)NAN,           (double)INFINITY,      0,
                                cases[i].right * 1.02, cases[i].right * 0.98, -cases[i].right};
        for (size_t w = 0; w < sizeof wrong / sizeof *wrong; w++) {
            memcpy(sample.answer.bytes, &wrong[w], sizeof said);
            assert_string_not_equal(verdict_on(&sample), "");
        }
        sample_release(&sample);
    }
}

/* The measured heap decides even when tables and formula are right. */
static void test_measured_memory(void **state)
{
    (void)state;
    static const struct built_case memory_cases[] = {
        {&judge_memory_indexed_grid, "memory-of-23"},
        {&judge_memory_strips, "memory-of-23"},
        {&judge_memory_voxels_vs_mesh, "voxel-memory-16"},
        {&judge_memory_voxels_vs_mesh, "mesh-memory-16"}};
    for (int c = 0; c < 4; c++) {
        struct sample sample;
        sample_take(&sample, memory_cases[c].judge, memory_cases[c].name);
        struct usage *usage = &sample.answer.usage;
        assert_string_equal(verdict_on(&sample), "");
        usage->heap_held_bytes += 1;
        assert_string_equal(verdict_on(&sample), "measured-size");
        usage->heap_left_bytes = 1; /* what leaked is no part of the structure */
        assert_string_equal(verdict_on(&sample), "");
        usage->heap_held_bytes = INT64_MIN;
        assert_string_equal(verdict_on(&sample), "measured-size");
        usage->known = false;
        assert_string_equal(verdict_on(&sample), "");
        sample_release(&sample);
    }
}

static void test_any_bytes(void **state)
{
    (void)state;
    answers_fuzz(&judge_memory_indexed_grid, "memory", 4000);
    answers_fuzz(&judge_memory_strips, "memory", 4000);
    answers_fuzz(&judge_memory_voxels_vs_mesh, "memory", 4000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_any_numbering_is_right),
                                       cmocka_unit_test(test_every_triangle_is_looked_at),
                                       cmocka_unit_test(test_every_coordinate_is_looked_at),
                                       cmocka_unit_test(test_every_bit_is_looked_at),
                                       cmocka_unit_test(test_numbers_are_exact_to_two_decimals),
                                       cmocka_unit_test(test_measured_memory),
                                       cmocka_unit_test(test_every_strip_is_looked_at),
                                       cmocka_unit_test(test_the_first_fault_is_named),
                                       cmocka_unit_test(test_wrong_counts_are_explained),
                                       cmocka_unit_test(test_any_bytes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
