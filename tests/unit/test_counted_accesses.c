/* Counted accesses behind the box: what a judge refuses to believe, what neighbours cost, and what is
 * stored and shown. */
#include "graders/library/accesses.h"
#include "graders/library/neighbours.h"
#include "graders/report/check.h"
#include "graders/report/report.h"
#include "tests/unit/report_sample.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void too_few_are_not_believed(void **state)
{
    static const struct usage honest = {.access_count = 12}, forged = {.access_count = 11},
                              negative = {.access_count = -5};
    struct judgement out = {0};
    (void)state;
    assert_false(accesses_reject(&honest, 12, &out));
    assert_int_equal(out.cause[0], '\0');
    assert_true(accesses_reject(&forged, 12, &out));
    assert_string_equal(out.cause, "impossible-accesses");
    assert_non_null(strstr(out.message.en, "11 accesses were counted"));
    assert_non_null(strstr(out.message.es, "menos de 12"));
    memset(&out, 0, sizeof out);
    assert_true(accesses_reject(&negative, 0, &out));
}

/* No program needs fewer than is said here: a row shows at most so much. */
static void the_least_is_never_above_what_a_walk_takes(void **state)
{
    const struct mesh_recipe prism = {SHAPE_PRISM, .count = 7};
    struct polygon_mesh mesh;
    struct winged_edge_mesh we;
    struct error err = {""};
    (void)state;
    assert_int_equal(polygon_mesh_make(&prism, 1, NULL, &mesh, &err), 0);
    const struct polygons polygons = {mesh.corners, mesh.first_corner, mesh.vertex_count,
                                      mesh.face_count};
    assert_int_equal(winged_edge_build(&we, &polygons, mesh.positions, &err), 0);
    for (int kind = 0; kind < NEIGHBOUR_KINDS; kind++)
        for (int32_t element = 0; element < mesh.face_count; element++) {
            int32_t count = neighbours_count(&we, kind, element);
            assert_in_range(count, 3, 7);
            assert_in_range(neighbours_least_accesses(&we, kind, element), 1, count + 1);
        }
    winged_edge_release(&we);
    polygon_mesh_release(&mesh);
}

static json_t *with_accesses(void)
{
    json_t *result = sample_result("ana-garcia", "edge-table-any");
    json_object_set_new(json_object_get(result, "measures"), "accesses",
                        json_pack("{s:f, s:f, s:[{s:s, s:[i,i], s:[i,i], s:[i,i]}]}", "ratio", 5.25,
                                  "band", 4.0, "families", "name", "one-apex", "sizes", 128, 256,
                                  "accesses", 525, 1050, "reference_accesses", 100, 200));
    return result;
}

static void the_check_knows_every_key(void **state)
{
    static const char *const needed[] = {"ratio", "band", "families"};
    struct error err = {""};
    (void)state;
    json_t *result = with_accesses();
    if (result_check(result, &err) != 0)
        fail_msg("%s", err.text);
    json_decref(result);
    for (size_t i = 0; i < sizeof needed / sizeof *needed; i++) {
        err.text[0] = '\0';
        result = with_accesses();
        json_object_del(json_object_get(json_object_get(result, "measures"), "accesses"),
                        needed[i]);
        assert_int_equal(result_check(result, &err), -1);
        if (!strstr(err.text, needed[i]))
            fail_msg("%s", err.text);
        json_decref(result);
    }
    err.text[0] = '\0';
    result = with_accesses();
    json_t *accesses = json_object_get(json_object_get(result, "measures"), "accesses");
    json_t *family = json_array_get(json_object_get(accesses, "families"), 0);
    json_array_append_new(json_object_get(family, "accesses"), json_integer(7));
    assert_int_equal(result_check(result, &err), -1);
    assert_non_null(strstr(err.text, "measures.accesses.families[0].accesses"));
    json_decref(result);
}

static void the_page_shows_them(void **state)
{
    char out[64];
    struct error err = {""};
    (void)state;
    json_t *result = with_accesses();
    sample_copy(out);
    sample_store(out, result);
    if (report_pages(out, ".", &err) != 0)
        fail_msg("%s", err.text);
    char *text = sample_read(out, "students/ana-garcia.html");
    assert_non_null(strstr(text, "Accesses to the structure"));
    assert_non_null(strstr(text, "Accesos a la estructura"));
    assert_non_null(strstr(text, "<code>one-apex</code>"));
    assert_non_null(strstr(text, ">525<"));
    free(text);
    sample_remove(out);
    json_decref(result);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(too_few_are_not_believed),
        cmocka_unit_test(the_least_is_never_above_what_a_walk_takes),
        cmocka_unit_test(the_check_knows_every_key),
        cmocka_unit_test(the_page_shows_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
