/* Rows and documents out of a made-up journal: every number known beforehand. */
#include "bench/compare/document.h"
#include "bench/compare/rows.h"
#include "bench/compare/table.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* Two variants and a peer on a mesh of 1000 triangles; the j-th of 6 blocks takes 10 + j us plain,
 * half of that as avx2, ten times as the peer. */
static struct job job;
static struct plan plan = {.jobs = &job, .job_count = 1};
static struct journal journal;
static const struct copy_bandwidth copy = {1000000, "memcpy", 10};

static json_t *measure(const char *operation, double ns, const char *hash, const char *facts)
{
    return json_pack("{s:s, s:i, s:i, s:f, s:b, s:f, s:b, s:s, s:f, s:f, s:f, s:s}", "operation",
                     operation, "samples", 4, "dropped", 1, "warm_ns", ns, "warm_noisy", 0,
                     "cold_ns", 3 * ns, "cold_noisy", 0, "hash", hash, "value", 1500.0, "scale",
                     1.0, "tolerance", 0.0, "facts", facts);
}

static json_t *block(int number)
{
    double ns = 10000 + 1000.0 * number;
    const char *facts = " records=1500 limit_bytes=24000";
    json_t *mesh =
        json_pack("{s:s, s:s, s:s, s:i, s:i, s:i, s:i, s:i}", "name", "torus-1k-generated", "kind",
                  "torus", "order", "generated", "triangles", 1000, "vertices", 500, "edges", 1500,
                  "boundary_edges", 0, "highest_valence", 6);
    return json_pack("{s:s, s:i, s:f, s:o, s:{s:{s:[o, o]}, s:{s:[o]}, s:{s:[o]}, s:{s:s, s:[]}}}",
                     "job", job.name, "block", number, "seconds", 1.0, "mesh", mesh, "contenders",
                     "plain", "measures", measure("edges-any", ns, "0000000000000011", facts),
                     measure("edges-closed", ns / 4, "0000000000000011", facts), "avx2", "measures",
                     measure("edges-any", ns / 2, "0000000000000011", facts), "openmesh",
                     "measures", measure("edges-any", 10 * ns, "0000000000000013", ""), "vtk",
                     "refused", "it \"died\", they say", "measures");
}

static void add_contender(enum contender_kind kind, const char *name)
{
    struct contender *contender = &job.contenders[job.contender_count++];
    *contender = (struct contender){.kind = kind, .thread_count = 1};
    strcpy(contender->name, name);
    strcpy(contender->title, name);
}

static int make(void **state)
{
    (void)state;
    job = (struct job){.what = BENCH_KERNELS, .name = "kernels torus-1k-generated", .blocks = 6};
    job.mesh = (struct bench_mesh){.kind = MESH_TORUS, .triangles = 1000};
    add_contender(CONTENDER_KERNEL, "plain");
    add_contender(CONTENDER_KERNEL, "avx2");
    add_contender(CONTENDER_PEER, "openmesh");
    add_contender(CONTENDER_PEER, "vtk");
    journal.entries = json_array();
    for (int i = 0; i < 6; i++)
        json_array_append_new(journal.entries, block(i));
    return 0;
}

static int release(void **state)
{
    (void)state;
    json_decref(journal.entries);
    return 0;
}

static json_t *row_of(json_t *rows, const char *subject, const char *variant, const char *operation)
{
    size_t i;
    json_t *row;
    json_array_foreach(rows, i, row)
    {
        if (!strcmp(json_string_value(json_object_get(row, "subject")), subject) &&
            !strcmp(json_string_value(json_object_get(row, "variant")), variant) &&
            !strcmp(json_string_value(json_object_get(row, "operation")), operation))
            return row;
    }
    fail_msg("no row %s %s %s", subject, variant, operation);
    return NULL;
}

static void has(const json_t *row, const char *key, const char *inner, double expected)
{
    double value = json_number_value(json_object_get(json_object_get(row, key), inner));
    if (!(fabs(value - expected) < 1e-9 * expected))
        fail_msg("%s.%s is %.12g, expected %.12g", key, inner, value, expected);
}

static void rows_have_times_and_ratios(void **state)
{
    (void)state;
    json_t *rows = rows_of(&plan, &journal, &copy, 1);
    json_t *plain = row_of(rows, "edges-any", "plain", "edges-any");
    json_t *avx2 = row_of(rows, "edges-any", "avx2", "edges-any");
    json_t *peer = row_of(rows, "openmesh", "", "edges-any");
    has(plain, "ns_per_triangle", "median", sqrt(12.0 * 13.0));
    has(plain, "ns_per_triangle", "least", 10);
    has(plain, "ns_per_triangle", "high", 15);
    has(plain, "cold_ns_per_triangle", "least", 30);
    has(plain, "limit", "fraction", 24000.0 / 10 / 10000); /* 2.4 us at 10 GB/s of 10 us */
    has(avx2, "ratio", "median", 0.5);
    has(avx2, "ratio", "confidence", 0.96875);
    has(peer, "ratio", "median", 20); /* against our fastest */
    assert_string_equal(json_string_value(json_object_get(json_object_get(peer, "ratio"), "to")),
                        "avx2");
    assert_true(json_is_null(json_object_get(plain, "ratio")));
    assert_string_equal(json_string_value(json_object_get(avx2, "answer")), "equal");
    assert_string_equal(json_string_value(json_object_get(peer, "answer")), "different");
    assert_int_equal(json_integer_value(json_object_get(plain, "samples")), 24);
    json_decref(rows);
}

static void a_peers_edge_table_stands_beside_both_of_ours(void **state)
{
    (void)state;
    json_t *rows = rows_of(&plan, &journal, &copy, 1);
    json_t *peer = row_of(rows, "openmesh", "", "edges-closed");
    has(peer, "ratio", "median", 40); /* 10 ns over ns / 4: only plain has edges-closed */
    assert_string_equal(json_string_value(json_object_get(json_object_get(peer, "ratio"), "to")),
                        "plain");
    json_decref(rows);
}

static json_t *make_document(void)
{
    static const struct machine machine = {.cpu = "A CPU", .core_count = 2};
    struct document_facts facts = {.version = "meshgrade test",
                                   .mode = "quick",
                                   .machine = &machine,
                                   .copy = &copy,
                                   .copy_count = 1};
    json_t *document = bench_document_make(&plan, &journal, &facts, NULL);
    assert_non_null(document);
    return document;
}

static void document_keeps_its_contract(void **state)
{
    static const char *const keys[] = {"schema", "version", "date", "mode",   "complete", "machine",
                                       "noise",  "meshes",  "rows", "claims", "accesses"};
    static const char *const row_keys[] = {
        "what",      "kind",       "subject",         "title",
        "variant",   "threads",    "operation",       "mesh",
        "mesh_kind", "order",      "triangles",       "vertices",
        "ratio",     "cold_ratio", "ns_per_triangle", "cold_ns_per_triangle",
        "blocks",    "samples",    "dropped",         "noisy",
        "counts",    "limit",      "facts",           "bytes_per_triangle",
        "answer",    "error",      "block_ns",        "ns_per_query"};
    size_t i;
    json_t *row;
    (void)state;
    json_t *document = make_document();
    for (size_t k = 0; k < sizeof keys / sizeof *keys; k++)
        assert_non_null(json_object_get(document, keys[k]));
    assert_string_equal(json_string_value(json_object_get(document, "schema")),
                        "meshgrade-bench-1");
    assert_true(json_is_true(json_object_get(document, "complete")));
    assert_int_equal(json_array_size(json_object_get(document, "meshes")), 1);
    json_array_foreach(json_object_get(document, "rows"), i, row)
    {
        for (size_t k = 0; k < sizeof row_keys / sizeof *row_keys; k++)
            if (!json_object_get(row, row_keys[k]))
                fail_msg("a row lacks \"%s\"", row_keys[k]);
    }
    json_decref(document);
}

static void google_has_a_row_a_block_and_no_zeros(void **state)
{
    size_t i;
    json_t *row;
    (void)state;
    json_t *document = make_document(), *google = bench_document_google(document);
    json_t *benchmarks = json_object_get(google, "benchmarks");
    assert_int_equal(json_integer_value(json_object_get(json_object_get(google, "context"),
                                                        "json_schema_version")),
                     1);
    assert_int_equal(json_array_size(benchmarks), 5 * 6); /* the refusal has none */
    json_array_foreach(benchmarks, i, row)
    {
        assert_true(json_number_value(json_object_get(row, "real_time")) > 0);
        assert_string_equal(json_string_value(json_object_get(row, "time_unit")), "ns");
        assert_string_equal(json_string_value(json_object_get(row, "run_type")), "iteration");
    }
    assert_string_equal(json_string_value(json_object_get(json_array_get(benchmarks, 0), "name")),
                        "kernels/edges-any/plain/torus-1k-generated");
    json_decref(google);
    json_decref(document);
}

/* Counts the fields of the line and whether quotes are closed. */
static int fields_of(const char *line, const char *end)
{
    int fields = 1, quotes = 0;
    for (; line < end; line++) {
        quotes += *line == '"';
        fields += *line == ',' && quotes % 2 == 0;
    }
    assert_int_equal(quotes % 2, 0);
    return fields;
}

static void csv_has_as_many_fields_everywhere(void **state)
{
    char *text = NULL;
    size_t length;
    int lines = 0;
    (void)state;
    json_t *document = make_document();
    FILE *file = open_memstream(&text, &length);
    bench_document_csv(document, file);
    fclose(file);
    int expected = fields_of(text, strchr(text, '\r'));
    for (const char *line = text; *line; lines++) {
        const char *end = strstr(line, "\r\n");
        assert_non_null(end);
        assert_int_equal(fields_of(line, end), expected);
        line = end + 2;
    }
    assert_int_equal(lines, 1 + 6);
    assert_non_null(strstr(text, "\"it \"\"died\"\", they say\""));
    free(text);
    json_decref(document);
}

static void table_fits_on_100_columns(void **state)
{
    char *text = NULL;
    size_t length;
    (void)state;
    json_t *document = make_document();
    FILE *file = open_memstream(&text, &length);
    table_write(document, false, file);
    fclose(file);
    for (const char *line = text; *line; line = strchr(line, '\n') + 1)
        assert_true(strchr(line, '\n') - line <= 100);
    assert_non_null(strstr(text, "0.50 [0.50, 0.50] plain   ="));
    assert_non_null(strstr(text, "it \"died\", they say"));
    free(text);
    json_decref(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_have_times_and_ratios),
        cmocka_unit_test(a_peers_edge_table_stands_beside_both_of_ours),
        cmocka_unit_test(document_keeps_its_contract),
        cmocka_unit_test(google_has_a_row_a_block_and_no_zeros),
        cmocka_unit_test(csv_has_as_many_fields_everywhere),
        cmocka_unit_test(table_fits_on_100_columns),
    };
    return cmocka_run_group_tests(tests, make, release);
}
