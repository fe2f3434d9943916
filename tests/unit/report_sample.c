/* The sample class for the tests of reports; see report_sample.h. */
#include "tests/unit/report_sample.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

json_t *sample_result(const char *student_folder, const char *exercise)
{
    char path[300];
    snprintf(path, sizeof path, "tests/unit/data/results/%s/%s.json", student_folder, exercise);
    json_t *result = json_load_file(path, JSON_ALLOW_NUL, NULL);
    assert_non_null(result);
    return result;
}

void sample_leave_out(json_t *result, const char *class_name, size_t count)
{
    json_t *cases = json_object_get(result, "cases");
    for (size_t i = json_array_size(cases); i-- > 0 && count > 0;) {
        json_t *one = json_array_get(cases, i);
        if (strcmp(json_string_value(json_object_get(one, "class")), class_name) != 0)
            continue;
        count--;
        json_object_set_new(one, "verdict", json_string("not-reached"));
        json_object_set_new(one, "message",
                            json_pack("{s:s, s:s}", "en", "Two cases did not end in time.", "es",
                                      "Dos casos no terminaron a tiempo."));
        json_object_del(one, "scene");
        json_object_del(one, "picture");
    }
    assert_int_equal(count, 0);
    size_t i;
    json_t *part;
    json_array_foreach(json_object_get(result, "classes"), i, part)
    {
        if (strcmp(json_string_value(json_object_get(part, "name")), class_name) != 0)
            continue;
        json_object_set_new(part, "points", json_integer(0));
        json_object_set_new(part, "passed", json_integer(0));
    }
}

void sample_copy(char *out)
{
    char command[300];
    strcpy(out, "/tmp/meshgrade-report-XXXXXX");
    assert_non_null(mkdtemp(out));
    snprintf(command, sizeof command, "cp -r tests/unit/data/results tests/unit/data/pictures %s",
             out);
    assert_int_equal(system(command), 0);
}

void sample_remove(const char *out)
{
    char command[100];
    assert_int_equal(strncmp(out, "/tmp/meshgrade-report-", strlen("/tmp/meshgrade-report-")), 0);
    snprintf(command, sizeof command, "rm -rf %s", out);
    assert_int_equal(system(command), 0);
}

void sample_store(const char *out, const json_t *result)
{
    char path[300];
    snprintf(path, sizeof path, "%s/results/%s/%s.json", out,
             json_string_value(json_object_get(result, "student_folder")),
             json_string_value(json_object_get(result, "exercise")));
    assert_int_equal(json_dump_file(result, path, 0), 0);
}

char *sample_read(const char *out, const char *name)
{
    char path[300];
    snprintf(path, sizeof path, "%s/%s", out, name);
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    char *text = NULL;
    size_t capacity = 0;
    ssize_t length = getdelim(&text, &capacity, '\0', file);
    fclose(file);
    assert_true(length >= 0);
    return text;
}
