/* The check of results refuses whatever is not the format (graders/report/check.h). */
#include "graders/report/check.h"

#include "tests/unit/report_sample.h"

#include <glob.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* Keys that may be absent. */
static bool is_optional(const char *key)
{
    static const char *const keys[] = {
        "course",         "element",     "scene",       "picture",      "fit",
        "excess_percent", "growth",      "work",        "memory",       "instruction_ratio",
        "miss_ratio",     "allocations", "stack_bytes", "static_bytes", "families",
        "cause",          "cause_name",  "elements"};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (strcmp(keys[i], key) == 0)
            return true;
    return false;
}

static void refuse(const json_t *result, const char *place)
{
    struct error err = {""};
    if (result_check(result, &err) == 0)
        fail_msg("accepted without or with a wrong %s", place);
    assert_true(err.text[0] != '\0');
}

static void test_the_sample_is_accepted(void **state)
{
    (void)state;
    glob_t found;
    assert_int_equal(glob("tests/unit/data/results/*/*.json", 0, NULL, &found), 0);
    assert_true(found.gl_pathc >= 18);
    for (size_t i = 0; i < found.gl_pathc; i++) {
        struct error err = {""};
        json_t *result = json_load_file(found.gl_pathv[i], JSON_ALLOW_NUL, NULL);
        if (result_check(result, &err) != 0)
            fail_msg("%s: %s", found.gl_pathv[i], err.text);
        json_decref(result);
    }
    globfree(&found);
}

/* Each key of each object below `at`: without it, with null for it, and one more beside it. */
static void spoil_below(const json_t *result, json_t *at, int depth)
{
    assert_true(depth < 12);
    size_t i;
    json_t *element;
    json_array_foreach(at, i, element)
    {
        spoil_below(result, element, depth + 1);
    }
    json_t *keys = json_array();
    const char *key;
    json_object_foreach(at, key, element)
    {
        json_array_append_new(keys, json_string(key));
    }
    bool is_reasons = json_object_get(at, "landlock") != NULL; /* its keys are free */
    json_array_foreach(keys, i, element)
    {
        key = json_string_value(element);
        json_t *kept = json_incref(json_object_get(at, key));
        if (!is_optional(key) && !is_reasons) {
            json_object_del(at, key);
            refuse(result, key);
        }
        if (strcmp(key, "score") != 0) {
            json_object_set_new(at, key, json_null());
            refuse(result, key);
        }
        json_object_set_new(at, key, kept);
        if (json_is_object(kept) || json_is_array(kept))
            spoil_below(result, kept, depth + 1);
    }
    if (json_is_object(at) && !is_reasons) {
        json_object_set_new(at, "no-such-key", json_string(""));
        refuse(result, "no-such-key");
        json_object_del(at, "no-such-key");
    }
    json_decref(keys);
}

static void test_every_key_is_looked_at(void **state)
{
    (void)state;
    struct error err = {""};
    json_t *result = sample_result("s3", "edge-table-any");
    spoil_below(result, result, 0);
    assert_int_equal(result_check(result, &err), 0); /* put back as it was */
    json_decref(result);
}

struct spoiled {
    const char *path, *value, *says;
};

/* What no table of keys can say, and ranges. The path leads through keys and indices. */
static const struct spoiled spoiled[] = {
    {"schema", "\"meshgrade-result-2\"", "schema"},
    {"student_folder", "\"../../etc\"", "student_folder"},
    {"student_folder", "\".hidden\"", "student_folder"},
    {"student_folder", "\"a\\u0000b\"", "student_folder"},
    {"exercise", "\"a/b\"", "exercise"},
    {"verdict", "\"not-reached\"", "verdict"},
    {"verdict", "\"great\"", "verdict"},
    {"verdict", "\"fault\"", "score"},
    {"verdict", "\"passed\"", "cause"},
    {"cause", "\"\"", "cause"},
    {"score", "10.5", "above max_score"},
    {"score", "1.234", "two decimals"},
    {"score", "-1", "points"},
    {"score", "null", "score"},
    {"classes/0/points", "3", "above max_points"},
    {"classes/0/passed", "9", "above cases"},
    {"cases/0/class", "\"unheard-of\"", "none of classes"},
    {"cases/1/name", "\"torus\"", "stands twice"},
    {"measures/growth/families/0/sizes", "[1, 2]", "as long as sizes"},
    {"measures/growth/families/0/instructions/0", "-5", "from 0 on"},
    {"measures/memory/peak_bytes", "1.5", "integer"},
    {"protections/active/0", "7", "strings"},
    {"protections/inactive/landlock", "7", "object"},
    {"submission/files/0/bytes", "-1", "integer from 0"},
    {"engine/seed", "true", "engine.seed"},
};

static void set_at(json_t *value, const char *path, json_t *fresh)
{
    char key[64];
    size_t length = strcspn(path, "/");
    snprintf(key, sizeof key, "%.*s", (int)length, path);
    bool is_last = path[length] == '\0';
    if (json_is_array(value) && is_last)
        assert_int_equal(json_array_set_new(value, (size_t)atoi(key), fresh), 0);
    else if (json_is_array(value))
        set_at(json_array_get(value, (size_t)atoi(key)), path + length + 1, fresh);
    else if (is_last)
        assert_int_equal(json_object_set_new(value, key, fresh), 0);
    else
        set_at(json_object_get(value, key), path + length + 1, fresh);
}

static void test_what_the_parts_say_together(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof spoiled / sizeof *spoiled; i++) {
        struct error err = {""};
        json_t *result = sample_result("s3", "edge-table-any");
        json_t *value = json_loads(spoiled[i].value, JSON_DECODE_ANY | JSON_ALLOW_NUL, NULL);
        assert_non_null(value);
        set_at(result, spoiled[i].path, value);
        if (result_check(result, &err) == 0)
            fail_msg("accepted %s = %s", spoiled[i].path, spoiled[i].value);
        if (!strstr(err.text, spoiled[i].says))
            fail_msg("%s = %s says: %s", spoiled[i].path, spoiled[i].value, err.text);
        json_decref(result);
    }
}

static void test_a_rejected_case_names_its_element(void **state)
{
    (void)state;
    struct error err = {""};
    json_t *result = sample_result("ana-garcia", "edge-table-any");
    size_t i;
    json_t *one;
    json_array_foreach(json_object_get(result, "cases"), i, one)
    {
        json_object_del(one, "element");
    }
    assert_int_equal(result_check(result, &err), -1);
    assert_non_null(strstr(err.text, "element: is missing though rejected"));
    json_decref(result);
}

static void test_hostile_text_in_errors_is_inert(void **state)
{
    (void)state;
    struct error err = {""};
    json_t *result = sample_result("ana-garcia", "edge-table-any");
    json_object_set_new(result, "verdict", json_string("\x1b[2J\n"));
    assert_int_equal(result_check(result, &err), -1);
    assert_null(strchr(err.text, 0x1b));
    assert_null(strchr(err.text, '\n'));
    json_decref(result);
    assert_int_equal(result_check(NULL, NULL), -1);
    json_t *list = json_array();
    assert_int_equal(result_check(list, NULL), -1);
    json_decref(list);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_sample_is_accepted),
        cmocka_unit_test(test_every_key_is_looked_at),
        cmocka_unit_test(test_what_the_parts_say_together),
        cmocka_unit_test(test_a_rejected_case_names_its_element),
        cmocka_unit_test(test_hostile_text_in_errors_is_inert),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
