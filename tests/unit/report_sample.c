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
