/* Charts of a result: which curves they hold, and how they are drawn into a page. */
#include "graders/report/chart.h"

#include "bench/measure/growth.h"
#include "tests/unit/report_sample.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const json_t *curve_named(const json_t *scene, const char *name)
{
    size_t i;
    json_t *curve;
    json_array_foreach(json_object_get(scene, "curves"), i,
                       curve) if (strcmp(json_string_value(json_object_get(curve, "name")), name) ==
                                  0) return curve;
    return NULL;
}

static double value_at(const json_t *curve, const char *axis, size_t i)
{
    return json_number_value(json_array_get(json_object_get(curve, axis), i));
}

/* It begins where the submission begins, and each step is the allowed class's. */
static void test_allowed_growth(void **state)
{
    static const char *const classes[] = {"1", "n", "n lg n", "n^1.5", "n^2"};
    json_t *result = sample_result("ana-garcia", "edge-table-any");
    json_t *growth = json_object_get(json_object_get(result, "measures"), "growth");
    (void)state;
    for (size_t c = 0; c < sizeof classes / sizeof *classes; c++) {
        enum growth_class class;
        assert_int_equal(growth_class_find(classes[c], &class), 0);
        json_object_set_new(growth, "allowed", json_string(classes[c]));
        json_t *scene = chart_of_growth(result);
        const json_t *own = curve_named(scene, "submission");
        const json_t *allowed = curve_named(scene, "allowed");
        assert_non_null(allowed);
        assert_string_equal(json_string_value(json_object_get(allowed, "guide")), classes[c]);
        assert_true(value_at(allowed, "y", 0) == value_at(own, "y", 0));
        size_t count = json_array_size(json_object_get(allowed, "x"));
        assert_true(count >= 2);
        assert_int_equal(count, json_array_size(json_object_get(allowed, "y")));
        double steps = growth_term(class, value_at(own, "x", count - 1)) /
                       growth_term(class, value_at(own, "x", 0));
        double drawn = value_at(allowed, "y", count - 1) / value_at(allowed, "y", 0);
        assert_true(drawn > steps * 0.999 && drawn < steps * 1.001);
        json_decref(scene);
    }
    json_decref(result);
}

static void test_unknown_growth_has_no_guide(void **state)
{
    json_t *result = sample_result("ana-garcia", "edge-table-any");
    json_t *growth = json_object_get(json_object_get(result, "measures"), "growth");
    (void)state;
    json_object_set_new(growth, "allowed", json_string("n^7"));
    json_t *scene = chart_of_growth(result);
    assert_non_null(curve_named(scene, "submission"));
    assert_null(curve_named(scene, "allowed"));
    json_decref(scene);
    json_decref(result);
}

/* The guide has no points, and the reference lies below in a look of its own. */
static void test_drawing(void **state)
{
    json_t *result = sample_result("ana-garcia", "edge-table-any");
    json_t *scene = chart_of_growth(result);
    struct error err = {""};
    struct html page;
    (void)state;
    assert_int_equal(html_start(&page, &err), 0);
    chart_draw(&page, scene, (struct phrase){"a chart", "un gráfico"});
    assert_int_equal(html_finish(&page, &err), 0);
    const char *text = page.text, *guide = strstr(text, "curve guide");
    assert_non_null(guide);
    const char *end = strstr(guide, "</g>");
    assert_non_null(end);
    for (const char *at = guide; at < end; at++)
        assert_false(strncmp(at, "<circle", 7) == 0 || strncmp(at, "<rect", 5) == 0);
    assert_non_null(strstr(text, "curve-1 below"));
    assert_non_null(strstr(text, "crecimiento permitido: "));
    html_release(&page);
    json_decref(scene);
    json_decref(result);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_allowed_growth),
        cmocka_unit_test(test_unknown_growth_has_no_guide),
        cmocka_unit_test(test_drawing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
