/* The page of a benchmark run: what it says of a made-up run is what the run says, what is missing
 * is left out, and no text of the run becomes markup. */
#include "graders/report/bench/bench_report.h"
#include "graders/report/bench/page.h"
#include "graders/report/documents.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

/* A row with its times; the caller adds what else it needs. */
static json_t *row(const char *what, const char *kind, const char *subject, const char *operation,
                   const char *mesh, double ns)
{
    char mesh_kind[32], order[32] = "generated";
    double triangles = strstr(mesh, "-1M-") ? 1e6 : strstr(mesh, "-10k-") ? 1e4 : 1e5;
    snprintf(mesh_kind, sizeof mesh_kind, "%.*s", (int)strcspn(mesh, "-"), mesh);
    if (strstr(mesh, "scrambled"))
        snprintf(order, sizeof order, "scrambled");
    json_t *object =
        json_pack("{s:s, s:s, s:s, s:s, s:s, s:i, s:s, s:s, s:s, s:s, s:f, s:f, s:i}", "what", what,
                  "kind", kind, "subject", subject, "title", subject, "variant",
                  strcmp(kind, "kernel") == 0 ? "plain" : "", "threads", 1, "operation", operation,
                  "mesh", mesh, "mesh_kind", mesh_kind, "order", order, "triangles", triangles,
                  "vertices", triangles / 2, "blocks", 8);
    json_object_set_new(
        object, "ns_per_triangle",
        ns > 0 ? json_pack("{s:f, s:f, s:f}", "median", ns, "low", .9 * ns, "high", 1.1 * ns)
               : json_null());
    return object;
}

static json_t *with_bytes(json_t *object, double formula, double measured)
{
    json_object_set_new(object, "bytes_per_triangle",
                        json_pack("{s:f, s:f}", "formula", formula, "measured", measured));
    return object;
}

static json_t *with_ratio(json_t *object, double median, double low, double high, int too_noisy)
{
    json_object_set_new(object, "ratio",
                        json_pack("{s:s, s:f, s:f, s:f, s:f, s:b}", "to", "plain", "median", median,
                                  "low", low, "high", high, "confidence", .97, "too_noisy",
                                  too_noisy));
    return object;
}

static json_t *document_of(json_t *rows)
{
    return json_pack("{s:s, s:s, s:s, s:s, s:b, s:{s:s, s:i, s:[{s:i, s:s, s:i}]}, s:{s:i, s:i}, "
                     "s:[], s:o, s:[]}",
                     "schema", "meshgrade-bench-1", "version", "0.3", "date",
                     "2026-11-22T12:00:00+0000", "mode", "full", "complete", 1, "machine", "cpu",
                     "Some CPU", "cores", 2, "caches", "level", 2, "type", "Unified", "bytes",
                     1048576, "noise", "samples", 1000, "dropped", 25, "meshes", "rows", rows,
                     "claims");
}

static struct study study_of(json_t *rows)
{
    struct study study;
    struct error err = {""};
    assert_int_equal(study_take(&study, document_of(rows), &err), 0);
    return study;
}

static void assert_says(const struct figure *figure, const struct study *study, const char *words)
{
    char *text = figure_words(figure, study);
    assert_non_null(text);
    if (!strstr(text, words))
        fail_msg("%s says \"%s\" and not \"%s\"", figure->name, text, words);
    free(text);
}

/* ---------------------------------------------------------------- findings */

static json_t *two_representations(void)
{
    const char *mesh = "bunny-100k-generated";
    json_t *rows = json_array();
    json_array_append_new(
        rows,
        with_bytes(row("representations", "representation", "Large", "bytes", mesh, 0), 66, 60));
    json_array_append_new(
        rows,
        with_bytes(row("representations", "representation", "Small", "bytes", mesh, 0), 12, 12));
    json_array_append_new(rows, row("representations", "representation", "Large", "area", mesh, 8));
    json_array_append_new(rows, row("representations", "representation", "Small", "area", mesh, 2));
    json_array_append_new(rows,
                          row("representations", "representation", "Large", "edges", mesh, 1));
    json_array_append_new(rows,
                          row("representations", "representation", "Small", "edges", mesh, 3));
    json_array_append_new(rows,
                          row("representations", "representation", "Small", "build", mesh, 3));
    return rows;
}

static void test_bytes_are_compared(void **state)
{
    (void)state;
    struct study study = study_of(two_representations());
    assert_says(&figure_bytes, &study, "from 12.0 bytes (Small) to 60.0 (Large): 5.0 times");
    assert_says(&figure_bytes, &study, "differ most for Large, by 9.1 %");
    json_t *scene = figure_bytes.scene(&study);
    json_t *bars = json_object_get(json_array_get(json_object_get(scene, "groups"), 0), "bars");
    assert_int_equal(json_array_size(bars), 2);
    assert_string_equal(study_text(json_array_get(bars, 0), "name"), "Small");
    assert_true(study_number(json_array_get(bars, 1), "tick") > 65.9);
    json_decref(scene);
    study_release(&study);
}

static void test_heat_map_is_relative_to_the_fastest(void **state)
{
    (void)state;
    struct study study = study_of(two_representations());
    assert_says(&figure_heat, &study, "Most often the fastest: Small, in 2 of 3 operations; none");
    assert_says(&figure_heat, &study, "dearest choice is Large for \"area\": 4.00 times");
    json_t *scene = figure_heat.scene(&study);
    const json_t *large = json_array_get(json_object_get(scene, "cells"), 0);
    assert_true(!json_object_get(json_array_get(large, 0), "value")); /* never built */
    assert_true(study_number(json_array_get(large, 1), "value") > 3.99);
    json_decref(scene);
    study_release(&study);
}

static void test_growth_needs_two_sizes(void **state)
{
    (void)state;
    json_t *rows = two_representations();
    struct study study = study_of(json_incref(rows));
    assert_null(figure_costs.scene(&study));
    assert_null(figure_doubling.scene(&study));
    study_release(&study);
    json_array_append_new(
        rows, row("representations", "representation", "Small", "build", "bunny-1M-generated", 6));
    study = study_of(rows);
    assert_says(&figure_costs, &study, "On a mesh 10 times as large, building costs 2.0 (Small)");
    study_release(&study);
}

static void test_doubling_tells_scrambled_from_ordered(void **state)
{
    (void)state;
    json_t *rows = json_array();
    json_array_append_new(rows,
                          row("kernels", "kernel", "twins", "twins", "torus-10k-generated", 4));
    json_array_append_new(rows,
                          row("kernels", "kernel", "twins", "twins", "torus-1M-generated", 6));
    json_array_append_new(rows,
                          row("kernels", "kernel", "twins", "twins", "torus-1M-scrambled", 18));
    json_object_set_new(json_array_get(rows, 0), "limit",
                        json_pack("{s:f, s:f}", "bytes_per_triangle", 32.0, "fraction", .4));
    struct study study = study_of(rows);
    assert_says(&figure_doubling, &study, "100 times as large a triangle costs at most 1.5 times");
    assert_says(&figure_doubling, &study, "a scrambled mesh costs 3.0 (twins of half edges)");
    json_t *scene = figure_doubling.scene(&study);
    const json_t *panel = json_array_get(json_object_get(scene, "panels"), 0);
    const json_t *cache = json_array_get(json_object_get(panel, "guides"), 0);
    assert_true(study_number(cache, "value") > 32767 && study_number(cache, "value") < 32769);
    assert_string_equal(study_text(cache, "label"), "L2 1 MB");
    json_decref(scene);
    study_release(&study);
}

static void test_peers_are_counted_by_their_intervals(void **state)
{
    (void)state;
    const char *mesh = "torus-100k-generated";
    json_t *rows = json_array();
    json_array_append_new(
        rows, with_ratio(row("kernels", "peer", "Slow", "area", mesh, 9), 30, 28, 33, 0));
    json_array_append_new(
        rows, with_ratio(row("kernels", "peer", "Quick", "area", mesh, 9), .5, .45, .6, 0));
    json_array_append_new(
        rows, with_ratio(row("kernels", "peer", "Even", "area", mesh, 9), 1.02, .95, 1.1, 0));
    json_array_append_new(
        rows, with_ratio(row("kernels", "peer", "Noisy", "area", mesh, 9), 5, 1.1, 40, 1));
    json_t *once = with_ratio(row("kernels", "peer", "Once", "area", mesh, 9), 8, 8, 8, 0);
    json_object_set_new(json_object_get(once, "ratio"), "confidence", json_real(0));
    json_array_append_new(rows, once);
    struct study study = study_of(rows);
    assert_says(&figure_peers, &study, "In 2 of 5 comparisons");
    assert_says(&figure_peers, &study, "in 1 it is faster, and 2 are undecided");
    assert_says(&figure_peers, &study, "from 0.50 (Quick, area, on torus-100k-generated) to 30");
    study_release(&study);
}

static void test_voxels_cross_at_288(void **state)
{
    (void)state;
    struct study study = study_of(json_array());
    assert_says(&figure_voxels, &study, "the mesh from k = 288 on");
    study_release(&study);
}

static void test_strips_reach_their_limits(void **state)
{
    (void)state;
    struct study study = study_of(json_array());
    assert_says(&figure_strips, &study, "strips process 1.992 times the vertices");
    study_release(&study);
}

/* ---------------------------------------------------------------- the whole page */

static char *page_of(struct study *study)
{
    struct html page;
    struct error err = {""};
    struct bench_page context = {.study = study, .folder = "/nonexistent", .pictures_reason = ""};
    assert_int_equal(html_start(&page, &err), 0);
    bench_page_write(&page, &context);
    assert_int_equal(html_finish(&page, &err), 0);
    char *text = strdup(page.text);
    html_release(&page);
    return text;
}

static void test_an_empty_run_leaves_things_out(void **state)
{
    (void)state;
    struct study study = study_of(json_array());
    char *text = page_of(&study);
    assert_non_null(strstr(text, "Left out: Peer libraries against our kernels, for no peer"));
    assert_non_null(strstr(text, "Left out: Bytes per triangle by representation"));
    assert_non_null(strstr(text, "Figure 1. "));
    assert_null(strstr(text, "nan"));
    assert_null(strstr(text, "inf "));
    free(text);
    study_release(&study);
}

static void test_goals_are_told_with_their_verdicts(void **state)
{
    (void)state;
    struct study study = study_of(json_array());
    json_object_set_new(
        study.document, "goals",
        json_pack("[{s:s, s:s, s:s, s:s, s:s, s:{s:f, s:b, s:f, s:f, s:f, s:s, s:s}, "
                  "s:{s:f, s:b, s:n, s:s, s:s}, s:n}]",
                  "operation", "twins", "mesh", "torus-1M-generated", "orders", "", "reason",
                  "sides are matched", "verdict", "missed", "warm", "goal", 4.0, "at_least", 1,
                  "median", 3.0, "low", 2.5, "high", 3.5, "verdict", "missed", "peer", "A <peer>",
                  "cold", "goal", 3.0, "at_least", 1, "median", "verdict", "undecided", "why",
                  "no peer", "indices"));
    char *text = page_of(&study);
    assert_non_null(strstr(text, "Of 1 goals 0 are met, 1 missed and 0 undecided"));
    assert_non_null(strstr(text, "3 (2.5 – 3.5)"));
    assert_non_null(strstr(text, "≥ 4, A &lt;peer&gt;"));
    assert_non_null(strstr(text, "≥ 3; no peer"));
    assert_non_null(strstr(text, "✗ missed"));
    assert_non_null(strstr(text, ": sides are matched."));
    free(text);
    study_release(&study);
}

static void test_hostile_texts_are_inert_and_short(void **state)
{
    (void)state;
    char longest[5001] = "<script>alert(1)</script>\x1b[2J";
    memset(longest + strlen(longest), 'x', 5000 - strlen(longest));
    json_t *rows = two_representations();
    json_object_set_new(json_array_get(rows, 0), "title", json_string(longest));
    json_object_set_new(json_array_get(rows, 2), "error", json_string("\"><img src=x onerror=a>"));
    json_object_set_new(json_array_get(rows, 3), "answer", json_integer(7));
    json_array_append_new(rows, json_string("no row"));
    json_array_append_new(rows, json_object());
    struct study study = study_of(rows);
    assert_true(strlen(study_text(json_array_get(study.rows, 0), "title")) < 400);
    char *text = page_of(&study);
    assert_null(strstr(text, "<script"));
    assert_null(strstr(text, "<img src=x"));
    assert_null(strstr(text, "\x1b"));
    assert_non_null(strstr(text, "&lt;script&gt;"));
    free(text);
    study_release(&study);
}

static void test_only_bench_results_are_taken(void **state)
{
    (void)state;
    struct study study;
    struct error err = {""};
    assert_int_equal(study_take(&study, json_pack("{s:s}", "schema", "other"), &err), -1);
    study_release(&study);
    assert_int_equal(study_take(&study, json_array(), &err), -1);
    study_release(&study);
    assert_int_equal(study_take(&study, NULL, &err), -1);
    study_release(&study);
}

static void test_lessons_show_the_structures(void **state)
{
    (void)state;
    struct study study = study_of(json_array());
    json_t *half = lesson_half_edge.scene(&study), *winged = lesson_winged_edge.scene(&study);
    /* 6 + 12 triangles have 54 half edges, and 6 stand around the dome. */
    assert_int_equal(json_array_size(json_object_get(half, "arrows")), 60);
    /* 7 edges and 7 steps around the vertex. */
    assert_int_equal(json_array_size(json_object_get(winged, "arrows")), 14);
    assert_int_equal(json_array_size(json_object_get(winged, "faces")), 7);
    json_decref(half);
    json_decref(winged);
    study_release(&study);
}

static void test_a_folder_gets_its_page(void **state)
{
    (void)state;
    char folder[] = "/tmp/meshgrade-bench-page-XXXXXX", path[200], reason[200], command[200];
    struct error err = {""};
    assert_non_null(mkdtemp(folder));
    assert_int_equal(bench_report(folder, NULL, ".", reason, sizeof reason, &err), -1);
    snprintf(path, sizeof path, "%s/bench.json", folder);
    json_t *document = document_of(two_representations());
    assert_int_equal(document_write_json(path, document, &err), 0);
    json_decref(document);
    assert_int_equal(bench_report(folder, NULL, ".", reason, sizeof reason, &err), 0);
    assert_non_null(strstr(reason, "meshgrade-render is not there"));
    snprintf(path, sizeof path, "%s/index.html", folder);
    char *text = document_read(path, 1 << 20, NULL, &err);
    assert_non_null(text);
    assert_non_null(strstr(text, "Pictures were not drawn"));
    free(text);
    snprintf(path, sizeof path, "%s/pictures/heat.json", folder);
    assert_int_equal(access(path, R_OK), 0);
    snprintf(path, sizeof path, "%s/pictures/peers.json", folder);
    assert_int_equal(access(path, R_OK), -1);
    snprintf(command, sizeof command, "rm -r %s", folder);
    assert_int_equal(system(command), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bytes_are_compared),
        cmocka_unit_test(test_heat_map_is_relative_to_the_fastest),
        cmocka_unit_test(test_growth_needs_two_sizes),
        cmocka_unit_test(test_doubling_tells_scrambled_from_ordered),
        cmocka_unit_test(test_peers_are_counted_by_their_intervals),
        cmocka_unit_test(test_voxels_cross_at_288),
        cmocka_unit_test(test_strips_reach_their_limits),
        cmocka_unit_test(test_an_empty_run_leaves_things_out),
        cmocka_unit_test(test_goals_are_told_with_their_verdicts),
        cmocka_unit_test(test_hostile_texts_are_inert_and_short),
        cmocka_unit_test(test_only_bench_results_are_taken),
        cmocka_unit_test(test_lessons_show_the_structures),
        cmocka_unit_test(test_a_folder_gets_its_page),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
