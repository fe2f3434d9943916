/* The check of a result: tables that mirror graders/report/README.md, then what no table can say.
 */
#include "graders/report/check.h"

#include "graders/report/clean.h"
#include "graders/report/documents.h"
#include "graders/report/words.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum kind {
    STRING,
    NAME,   /* a string that is safe in paths, URLs and ids */
    SCALAR, /* a string or an integer */
    WORDS,  /* {en, es} */
    WORDS_OR_STRING,
    POINTS, /* a number from 0 on, at most two decimals */
    POINTS_OR_NULL,
    NUMBER,
    COUNT, /* an integer from 0 on */
    TRUTH,
    VERDICT,     /* a verdict of a submission */
    ANY_VERDICT, /* also not-measured and not-reached */
    STRINGS,     /* a list of strings */
    NUMBERS,     /* a list of numbers from 0 on */
    REASONS,     /* an object of words, or of strings */
    RECORD,      /* an object with the fields of `record` */
    RECORDS      /* a list of them */
};

enum need { REQUIRED, OPTIONAL };

struct field {
    const char *key; /* NULL ends a record */
    enum kind kind;
    enum need need;
    const struct field *record; /* of RECORD and RECORDS */
};

static const struct field words_fields[] = {
    {"en", STRING, REQUIRED, NULL}, {"es", STRING, REQUIRED, NULL}, {0}};

static const struct field class_fields[] = {{"name", NAME, REQUIRED, NULL},
                                            {"title", WORDS, REQUIRED, NULL},
                                            {"points", POINTS, REQUIRED, NULL},
                                            {"max_points", POINTS, REQUIRED, NULL},
                                            {"passed", COUNT, REQUIRED, NULL},
                                            {"cases", COUNT, REQUIRED, NULL},
                                            {0}};

static const struct field check_fields[] = {{"name", NAME, REQUIRED, NULL},
                                            {"title", WORDS, REQUIRED, NULL},
                                            {"points", POINTS, REQUIRED, NULL},
                                            {"max_points", POINTS, REQUIRED, NULL},
                                            {"verdict", ANY_VERDICT, REQUIRED, NULL},
                                            {"cause", STRING, OPTIONAL, NULL},
                                            {"cause_name", WORDS, OPTIONAL, NULL},
                                            {"message", WORDS, REQUIRED, NULL},
                                            {0}};

static const struct field case_fields[] = {
    {"name", NAME, REQUIRED, NULL},           {"class", NAME, REQUIRED, NULL},
    {"verdict", ANY_VERDICT, REQUIRED, NULL}, {"cause", STRING, REQUIRED, NULL},
    {"cause_name", WORDS, OPTIONAL, NULL},    {"message", WORDS, REQUIRED, NULL},
    {"seed", STRING, REQUIRED, NULL},         {"public", TRUTH, REQUIRED, NULL},
    {"reproduce", STRING, REQUIRED, NULL},    {"element", WORDS_OR_STRING, OPTIONAL, NULL},
    {"scene", TRUTH, OPTIONAL, NULL},         {"picture", STRING, OPTIONAL, NULL},
    {"quality", NUMBER, OPTIONAL, NULL},      {0}};

static const struct field fit_fields[] = {{"class", STRING, REQUIRED, NULL},
                                          {"exponent", NUMBER, REQUIRED, NULL},
                                          {"excess_percent", NUMBER, OPTIONAL, NULL},
                                          {0}};

static const struct field growth_family_fields[] = {
    {"name", NAME, REQUIRED, NULL},
    {"sizes", NUMBERS, REQUIRED, NULL},
    {"instructions", NUMBERS, REQUIRED, NULL},
    {"reference_instructions", NUMBERS, REQUIRED, NULL},
    {"fit", RECORD, OPTIONAL, fit_fields},
    {"allowed", STRING, OPTIONAL, NULL},
    {0}};

static const struct field growth_fields[] = {
    {"allowed", STRING, REQUIRED, NULL},
    {"element", WORDS, OPTIONAL, NULL}, /* of earlier versions */
    {"elements", WORDS, OPTIONAL, NULL},
    {"families", RECORDS, REQUIRED, growth_family_fields},
    {0}};

static const struct field work_fields[] = {{"ratio", NUMBER, REQUIRED, NULL},
                                           {"band", NUMBER, REQUIRED, NULL},
                                           {"instruction_ratio", NUMBER, OPTIONAL, NULL},
                                           {"miss_ratio", NUMBER, OPTIONAL, NULL},
                                           {0}};

static const struct field access_family_fields[] = {{"name", NAME, REQUIRED, NULL},
                                                    {"sizes", NUMBERS, REQUIRED, NULL},
                                                    {"accesses", NUMBERS, REQUIRED, NULL},
                                                    {"reference_accesses", NUMBERS, REQUIRED, NULL},
                                                    {0}};

static const struct field access_fields[] = {{"ratio", NUMBER, REQUIRED, NULL},
                                             {"band", NUMBER, REQUIRED, NULL},
                                             {"families", RECORDS, REQUIRED, access_family_fields},
                                             {0}};

static const struct field memory_family_fields[] = {
    {"name", NAME, REQUIRED, NULL},
    {"sizes", NUMBERS, REQUIRED, NULL},
    {"peak_bytes", NUMBERS, REQUIRED, NULL},
    {"reference_peak_bytes", NUMBERS, REQUIRED, NULL},
    {0}};

static const struct field memory_fields[] = {{"size", COUNT, REQUIRED, NULL},
                                             {"peak_bytes", COUNT, REQUIRED, NULL},
                                             {"reference_peak_bytes", COUNT, REQUIRED, NULL},
                                             {"ratio", NUMBER, REQUIRED, NULL},
                                             {"band", NUMBER, REQUIRED, NULL},
                                             {"allocations", COUNT, OPTIONAL, NULL},
                                             {"stack_bytes", COUNT, OPTIONAL, NULL},
                                             {"static_bytes", COUNT, OPTIONAL, NULL},
                                             {"families", RECORDS, OPTIONAL, memory_family_fields},
                                             {0}};

static const struct field band_fields[] = {{"class", NAME, REQUIRED, NULL},
                                           {"name", WORDS, REQUIRED, NULL},
                                           {"limit", NUMBER, REQUIRED, NULL},
                                           {0}};

static const struct field quality_fields[] = {
    {"name", WORDS, REQUIRED, NULL},           {"unit", WORDS, OPTIONAL, NULL},
    {"less_is_better", TRUTH, REQUIRED, NULL}, {"worst", NUMBER, REQUIRED, NULL},
    {"bands", RECORDS, REQUIRED, band_fields}, {0}};

static const struct field measures_fields[] = {{"growth", RECORD, OPTIONAL, growth_fields},
                                               {"work", RECORD, OPTIONAL, work_fields},
                                               {"accesses", RECORD, OPTIONAL, access_fields},
                                               {"memory", RECORD, OPTIONAL, memory_fields},
                                               {"query_work", RECORD, OPTIONAL, work_fields},
                                               {"query_memory", RECORD, OPTIONAL, memory_fields},
                                               {"quality", RECORD, OPTIONAL, quality_fields},
                                               {0}};

static const struct field build_fields[] = {{"ok", TRUTH, REQUIRED, NULL},
                                            {"cause", STRING, REQUIRED, NULL},
                                            {"diagnostics", STRING, REQUIRED, NULL},
                                            {0}};

static const struct field protections_fields[] = {
    {"active", STRINGS, REQUIRED, NULL}, {"inactive", REASONS, REQUIRED, NULL}, {0}};

static const struct field not_measured_fields[] = {
    {"name", WORDS_OR_STRING, REQUIRED, NULL}, {"reason", WORDS_OR_STRING, REQUIRED, NULL}, {0}};

static const struct field uploaded_fields[] = {{"name", STRING, REQUIRED, NULL},
                                               {"bytes", COUNT, REQUIRED, NULL},
                                               {"sha256", STRING, REQUIRED, NULL},
                                               {0}};

static const struct field submission_fields[] = {{"files", RECORDS, REQUIRED, uploaded_fields},
                                                 {0}};

static const struct field engine_fields[] = {{"version", STRING, REQUIRED, NULL},
                                             {"compiler", STRING, REQUIRED, NULL},
                                             {"libc", STRING, OPTIONAL, NULL},
                                             {"valgrind", STRING, OPTIONAL, NULL},
                                             {"layers", STRING, OPTIONAL, NULL},
                                             {"seed", SCALAR, REQUIRED, NULL},
                                             {0}};

static const struct field result_fields[] = {
    {"schema", STRING, REQUIRED, NULL},
    {"student", STRING, REQUIRED, NULL},
    {"student_folder", NAME, REQUIRED, NULL},
    {"exercise", NAME, REQUIRED, NULL},
    {"group", STRING, REQUIRED, NULL},
    {"course", WORDS, OPTIONAL, NULL},
    {"title", WORDS, REQUIRED, NULL},
    {"problem", STRING, REQUIRED, NULL},
    {"verdict", VERDICT, REQUIRED, NULL},
    {"cause", STRING, REQUIRED, NULL},
    {"cause_name", WORDS, OPTIONAL, NULL},
    {"score", POINTS_OR_NULL, REQUIRED, NULL},
    {"max_score", POINTS, REQUIRED, NULL},
    {"summary", WORDS, REQUIRED, NULL},
    {"classes", RECORDS, REQUIRED, class_fields},
    {"checks", RECORDS, REQUIRED, check_fields},
    {"cases", RECORDS, REQUIRED, case_fields},
    {"measures", RECORD, REQUIRED, measures_fields},
    {"build", RECORD, REQUIRED, build_fields},
    {"output", STRING, REQUIRED, NULL},
    {"protections", RECORD, REQUIRED, protections_fields},
    {"not_measured", RECORDS, REQUIRED, not_measured_fields},
    {"submission", RECORD, REQUIRED, submission_fields},
    {"engine", RECORD, REQUIRED, engine_fields},
    {0}};

/* ---------------------------------------------------------------- the tables */

enum { PLACE_BYTES = 160 };

static int expected(const char *place, const char *what, const json_t *value, struct error *err)
{
    static const char *const types[] = {"an object", "a list", "a string", "an integer",
                                        "a number",  "true",   "false",    "null"};
    if (!json_is_string(value))
        return error_set(err, "%s: expected %s, got %s", place, what,
                         value ? types[json_typeof(value)] : "nothing");
    char *shown = clean_text(json_string_value(value), json_string_length(value), CLEAN_LINE, 40);
    error_set(err, "%s: expected %s, got \"%s\"", place, what, shown ? shown : "");
    free(shown);
    return -1;
}

static bool is_points(const json_t *value)
{
    double points = json_number_value(value);
    return json_is_number(value) && points >= 0 && points <= 1e6 &&
           fabs(points * 100 - round(points * 100)) < 1e-6;
}

static bool is_name(const json_t *value)
{
    return json_is_string(value) && strlen(json_string_value(value)) == json_string_length(value) &&
           document_is_safe_name(json_string_value(value));
}

static bool is_verdict(const json_t *value, bool any)
{
    const char *text = json_string_value(value);
    return text && words_know_verdict(text) && (any || words_standing(text) != STANDING_ABSENT);
}

static int check_leaf(const json_t *value, enum kind kind, const char *place, struct error *err)
{
    switch (kind) {
    case NAME:
        return is_name(value)
                   ? 0
                   : expected(place, "a name of letters, digits, '.', '_', '-'", value, err);
    case SCALAR:
        return json_is_string(value) || json_is_integer(value)
                   ? 0
                   : expected(place, "a string or an integer", value, err);
    case POINTS_OR_NULL:
        return json_is_null(value) || is_points(value)
                   ? 0
                   : expected(place, "points (two decimals) or null", value, err);
    case POINTS:
        return is_points(value) ? 0 : expected(place, "points (from 0, two decimals)", value, err);
    case NUMBER:
        return json_is_number(value) ? 0 : expected(place, "a number", value, err);
    case COUNT:
        return json_is_integer(value) && json_integer_value(value) >= 0
                   ? 0
                   : expected(place, "an integer from 0 on", value, err);
    case TRUTH:
        return json_is_boolean(value) ? 0 : expected(place, "true or false", value, err);
    case VERDICT:
    case ANY_VERDICT:
        return is_verdict(value, kind == ANY_VERDICT) ? 0
                                                      : expected(place, "a verdict", value, err);
    default:
        return json_is_string(value) ? 0 : expected(place, "a string", value, err);
    }
}

static int check_list(const json_t *list, enum kind kind, const char *place, struct error *err)
{
    if (!json_is_array(list))
        return expected(place, "a list", list, err);
    size_t i;
    json_t *value;
    json_array_foreach(list, i, value)
    {
        if (kind == STRINGS && !json_is_string(value))
            return expected(place, "a list of strings", value, err);
        if (kind == NUMBERS && !(json_is_number(value) && json_number_value(value) >= 0))
            return expected(place, "a list of numbers from 0 on", value, err);
    }
    return 0;
}

static int check_record_at(const json_t *object, const struct field *record, const char *place,
                           struct error *err);

static int check_words(const json_t *value, const char *place, struct error *err)
{
    return json_is_string(value) ? 0 : check_record_at(value, words_fields, place, err);
}

static int check_reasons(const json_t *object, const char *place, struct error *err)
{
    if (!json_is_object(object))
        return expected(place, "an object", object, err);
    json_t *changeable = (json_t *)(uintptr_t)object; /* jansson's iterators only read it */
    for (void *at = json_object_iter(changeable); at; at = json_object_iter_next(changeable, at)) {
        char inner[PLACE_BYTES];
        snprintf(inner, sizeof inner, "%.80s.%.60s", place, json_object_iter_key(at));
        if (check_words(json_object_iter_value(at), inner, err) != 0)
            return -1;
    }
    return 0;
}

static int check_field(const json_t *value, const struct field *field, const char *place,
                       struct error *err)
{
    switch (field->kind) {
    case WORDS_OR_STRING:
        return check_words(value, place, err);
    case WORDS:
        return check_record_at(value, words_fields, place, err);
    case STRINGS:
    case NUMBERS:
        return check_list(value, field->kind, place, err);
    case REASONS:
        return check_reasons(value, place, err);
    case RECORD:
        return check_record_at(value, field->record, place, err);
    case RECORDS:
        break;
    default:
        return check_leaf(value, field->kind, place, err);
    }
    if (!json_is_array(value))
        return expected(place, "a list", value, err);
    size_t i;
    json_t *element;
    json_array_foreach(value, i, element)
    {
        char inner[PLACE_BYTES];
        snprintf(inner, sizeof inner, "%.120s[%zu]", place, i);
        if (check_record_at(element, field->record, inner, err) != 0)
            return -1;
    }
    return 0;
}

static int check_no_other_key(const json_t *object, const struct field *record, const char *place,
                              struct error *err)
{
    json_t *changeable = (json_t *)(uintptr_t)object; /* jansson's iterators only read it */
    for (void *at = json_object_iter(changeable); at; at = json_object_iter_next(changeable, at)) {
        const char *key = json_object_iter_key(at);
        const struct field *field = record;
        while (field->key && strcmp(field->key, key) != 0)
            field++;
        if (!field->key) {
            char *shown = clean_text(key, strlen(key), CLEAN_LINE, 40);
            error_set(err, "%s%sunknown key \"%s\"", place, *place ? ": " : "", shown ? shown : "");
            free(shown);
            return -1;
        }
    }
    return 0;
}

static int check_record_at(const json_t *object, const struct field *record, const char *place,
                           struct error *err)
{
    if (!json_is_object(object))
        return expected(*place ? place : "the file", "an object", object, err);
    for (const struct field *field = record; field->key; field++) {
        char inner[PLACE_BYTES];
        snprintf(inner, sizeof inner, "%.120s%s%s", place, *place ? "." : "", field->key);
        const json_t *value = json_object_get(object, field->key);
        if (!value && field->need == REQUIRED)
            return error_set(err, "%s is missing", inner);
        if (value && check_field(value, field, inner, err) != 0)
            return -1;
    }
    return check_no_other_key(object, record, place, err);
}

/* ---------------------------------------------------------------- what the parts say together */

static bool has_text(const json_t *object, const char *key)
{
    return json_string_length(json_object_get(object, key)) > 0;
}

static int check_verdict_and_score(const json_t *result, struct error *err)
{
    const char *verdict = json_string_value(json_object_get(result, "verdict"));
    const json_t *score = json_object_get(result, "score");
    bool is_unscored = words_standing(verdict) == STANDING_UNSCORED;
    if (is_unscored != json_is_null(score))
        return error_set(err, "score: the verdict is %s, so it must %sbe null", verdict,
                         is_unscored ? "" : "not ");
    if (json_number_value(score) > json_number_value(json_object_get(result, "max_score")) + 1e-9)
        return error_set(err, "score: is above max_score");
    enum standing standing = words_standing(verdict);
    if (standing != STANDING_UNSCORED && has_text(result, "cause") == (standing == STANDING_PASSED))
        return error_set(err, "cause: must be empty when passed, and only then");
    return 0;
}

static int check_points_of(const json_t *result, const char *key, struct error *err)
{
    size_t i;
    json_t *part;
    json_array_foreach(json_object_get(result, key), i, part)
    {
        if (json_number_value(json_object_get(part, "points")) >
            json_number_value(json_object_get(part, "max_points")) + 1e-9)
            return error_set(err, "%s[%zu].points: are above max_points", key, i);
        if (json_integer_value(json_object_get(part, "passed")) >
            json_integer_value(json_object_get(part, "cases")))
            return error_set(err, "%s[%zu].passed: is above cases", key, i);
    }
    return 0;
}

static bool has_named(const json_t *list, size_t count, const char *name)
{
    for (size_t i = 0; i < count; i++)
        if (strcmp(json_string_value(json_object_get(json_array_get(list, i), "name")), name) == 0)
            return true;
    return false;
}

static bool measures_quality(const json_t *result)
{
    return json_object_get(json_object_get(result, "measures"), "quality") != NULL;
}

static int check_cases(const json_t *result, struct error *err)
{
    const json_t *cases = json_object_get(result, "cases");
    const json_t *classes = json_object_get(result, "classes");
    size_t i;
    json_t *one;
    json_array_foreach(cases, i, one)
    {
        if (has_named(cases, i, json_string_value(json_object_get(one, "name"))))
            return error_set(err, "cases[%zu].name: stands twice", i);
        if (!has_named(classes, json_array_size(classes),
                       json_string_value(json_object_get(one, "class"))))
            return error_set(err, "cases[%zu].class: is none of classes[]", i);
        enum standing standing = words_standing(json_string_value(json_object_get(one, "verdict")));
        if (standing == STANDING_FAILED && !json_object_get(one, "element"))
            return error_set(err, "cases[%zu].element: is missing though rejected", i);
        if (json_object_get(one, "quality") && !measures_quality(result))
            return error_set(err,
                             "cases[%zu].quality: measures.quality, which names it, is missing", i);
        if (standing == STANDING_FAILED && !has_text(one, "cause"))
            return error_set(err, "cases[%zu].cause: is empty though rejected", i);
    }
    return 0;
}

static int check_families(const json_t *measure, const char *const *keys, const char *place,
                          struct error *err)
{
    size_t i;
    json_t *family;
    json_array_foreach(json_object_get(measure, "families"), i, family)
    {
        size_t count = json_array_size(json_object_get(family, "sizes"));
        for (const char *const *key = keys; *key; key++) {
            size_t length = json_array_size(json_object_get(family, *key));
            bool may_lack = strncmp(*key, "reference", strlen("reference")) == 0;
            if (length != count && !(may_lack && length == 0))
                return error_set(err, "%s.families[%zu].%s: is not as long as sizes", place, i,
                                 *key);
        }
    }
    return 0;
}

int result_check(const json_t *result, struct error *err)
{
    static const char *const growth_keys[] = {"instructions", "reference_instructions", NULL};
    static const char *const access_keys[] = {"accesses", "reference_accesses", NULL};
    static const char *const memory_keys[] = {"peak_bytes", "reference_peak_bytes", NULL};
    const char *schema = json_string_value(json_object_get(result, "schema"));
    if (schema && strcmp(schema, "meshgrade-result-1") != 0)
        return error_set(err, "schema: this program reads meshgrade-result-1 only");
    if (check_record_at(result, result_fields, "", err) != 0)
        return -1;
    const json_t *measures = json_object_get(result, "measures");
    if (check_verdict_and_score(result, err) != 0 || check_points_of(result, "classes", err) != 0 ||
        check_points_of(result, "checks", err) != 0 || check_cases(result, err) != 0 ||
        check_families(json_object_get(measures, "growth"), growth_keys, "measures.growth", err) !=
            0 ||
        check_families(json_object_get(measures, "accesses"), access_keys, "measures.accesses",
                       err) != 0 ||
        check_families(json_object_get(measures, "query_memory"), memory_keys,
                       "measures.query_memory", err) != 0 ||
        check_families(json_object_get(measures, "memory"), memory_keys, "measures.memory", err) !=
            0)
        return -1;
    return 0;
}
