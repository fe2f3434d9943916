/* Reads what a submission is expected to get; see expectation.h. */
#include "graders/known/expectation.h"

#include "graders/engine/base/exercise.h"
#include "graders/engine/base/verdict.h"
#include "graders/engine/run/trial.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double MARGIN = 1.25; /* right answers stay this factor inside every band */

static const struct {
    const char *folder, *verdict;
} kinds[] = {{"right", "passed"},           {"wrong", "wrong-answer"}, {"slow", "grows-too-fast"},
             {"greedy", "too-much-memory"}, {"crash", "crash"},        {"leak", "leak"},
             {"poor", "poor-quality"}};

static const char *verdict_of_kind(const char *kind)
{
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++)
        if (strcmp(kinds[i].folder, kind) == 0)
            return kinds[i].verdict;
    return "";
}

/* The rest of the line after `key` in the text's first comment, NULL when it is not there. */
static const char *find_line(const char *text, const char *key)
{
    const char *end = strstr(text, "*/"), *at = strstr(text, key);
    return end && at && at < end ? at + strlen(key) + strspn(at + strlen(key), " ") : NULL;
}

static void read_failures(const char *line, struct expectation *expectation)
{
    expectation->names_failures = true;
    while (*line && *line != '\n' && expectation->failure_count < EXPECTED_FAILURES) {
        size_t length = strcspn(line, ", \n*");
        if (length > 0 && length < sizeof expectation->failures[0])
            snprintf(expectation->failures[expectation->failure_count++],
                     sizeof expectation->failures[0], "%.*s", (int)length, line);
        line += length;
        if (*line == '*')
            return;
        line += strspn(line, ", ");
    }
}

int expectation_read(const char *kind, const char *name, const char *text,
                     struct expectation *expectation, struct error *err)
{
    memset(expectation, 0, sizeof *expectation);
    const char *expect = find_line(text, "expect:"), *fails = find_line(text, "fails:");
    if (expect)
        snprintf(expectation->verdict, sizeof expectation->verdict, "%.*s",
                 (int)strcspn(expect, " \n*,"), expect);
    else
        snprintf(expectation->verdict, sizeof expectation->verdict, "%s", verdict_of_kind(kind));
    if (fails)
        read_failures(fails, expectation);
    if (verdict_of_name(expectation->verdict) == VERDICT_COUNT)
        return error_set(err,
                         "%s: \"%s\" is no verdict; its first comment needs a line expect:", name,
                         expectation->verdict);
    return 0;
}

static bool is_expected(const struct expectation *expectation, const char *name)
{
    for (int i = 0; i < expectation->failure_count; i++)
        if (strcmp(expectation->failures[i], name) == 0)
            return true;
    return false;
}

static bool has_failed(const json_t *entry)
{
    const char *verdict = json_string_value(json_object_get(entry, "verdict"));
    if (!verdict) /* a class */
        return json_integer_value(json_object_get(entry, "passed")) <
               json_integer_value(json_object_get(entry, "cases"));
    return verdict_of_name(verdict) < VERDICT_PASSED;
}

static bool failures_match(const struct expectation *expectation, const json_t *result, char *why,
                           size_t capacity)
{
    static const char *const lists[] = {"classes", "checks"};
    int met = 0;
    if (!expectation->names_failures)
        return true;
    for (int list = 0; list < 2; list++) {
        size_t index;
        json_t *entry;
        json_array_foreach(json_object_get(result, lists[list]), index, entry)
        {
            const char *name = json_string_value(json_object_get(entry, "name"));
            bool expected = is_expected(expectation, name), failed = has_failed(entry);
            met += expected;
            if (expected == failed)
                continue;
            snprintf(why, capacity, "%s %s, which was %sexpected", name,
                     failed ? "failed" : "did not fail", failed ? "not " : "");
            return false;
        }
    }
    if (met == expectation->failure_count)
        return true;
    snprintf(why, capacity, "`fails:` names something that is neither a class nor a check");
    return false;
}

static bool has_margin(const json_t *result, char *why, size_t capacity)
{
    static const char *const bands[] = {"work", "memory"};
    for (int i = 0; i < 2; i++) {
        const json_t *band = json_object_get(json_object_get(result, "measures"), bands[i]);
        double ratio = json_number_value(json_object_get(band, "ratio"));
        double limit = json_number_value(json_object_get(band, "band"));
        if (!band || ratio * MARGIN <= limit)
            continue;
        snprintf(why, capacity, "%s is %.3g of at most %.3g: less than the margin of %.2f",
                 bands[i], ratio, limit, MARGIN);
        return false;
    }
    return true;
}

bool expectation_is_met(const struct expectation *expected, const json_t *result, char *why,
                        size_t capacity)
{
    const char *verdict = json_string_value(json_object_get(result, "verdict"));
    if (strcmp(verdict, expected->verdict) != 0) {
        const json_t *summary = json_object_get(result, "summary");
        snprintf(why, capacity, "is %s (%s: %s), expected %s", verdict,
                 json_string_value(json_object_get(result, "cause")),
                 json_string_value(json_object_get(summary, "en")), expected->verdict);
        return false;
    }
    if (!failures_match(expected, result, why, capacity))
        return false;
    return strcmp(verdict, verdict_name(VERDICT_PASSED)) != 0 || has_margin(result, why, capacity);
}

/* The step in which a verdict of a check arises; STAGE_CASES: in the cases themselves. */
static enum trial_stage stage_of_check(enum check_kind check)
{
    switch (check) {
    case CHECK_LEAK:
        return STAGE_CASES;
    case CHECK_UNDEFINED_BEHAVIOUR:
        return STAGE_UNDEFINED_BEHAVIOUR;
    case CHECK_ALLOCATION_FAILURE:
        return STAGE_ALLOCATION_FAILURE;
    case CHECK_MEMORY:
    case CHECK_QUERY_MEMORY:
        return STAGE_MEMORY;
    default:
        return STAGE_GROWTH;
    }
}

static unsigned stages_of_verdict(enum verdict verdict)
{
    switch (verdict) {
    case VERDICT_UNDEFINED_BEHAVIOUR:
        return 1u << STAGE_UNDEFINED_BEHAVIOUR;
    case VERDICT_GROWS_TOO_FAST:
    case VERDICT_TOO_MUCH_WORK:
        return 1u << STAGE_GROWTH;
    case VERDICT_TOO_MUCH_MEMORY:
        return 1u << STAGE_MEMORY;
    case VERDICT_PASSED:
    case VERDICT_FLAGGED:
    case VERDICT_FAULT:
        return ~0u;
    default:
        return 0;
    }
}

unsigned expectation_left_out(const struct expectation *expected)
{
    unsigned needed = stages_of_verdict(verdict_of_name(expected->verdict));
    for (enum check_kind check = 0; check < CHECK_COUNT; check++)
        if (is_expected(expected, check_name(check)))
            needed |= 1u << stage_of_check(check);
    return ~needed & TRIAL_CHECKS;
}

/* What is wrong cannot be good, and what is too poor for one band is so for every stricter one. */
static bool is_stricter(const struct quality_rule *rule, const char *class_name, const char *than)
{
    const struct quality_band *band = quality_band_of(rule, class_name);
    const struct quality_band *other = quality_band_of(rule, than);
    return band && (!other || quality_is_worse(rule, other->limit, band->limit));
}

bool expectation_fails_just(const char *failed, const char *class_name,
                            const struct quality_rule *rule)
{
    bool is_met = false;
    while (*failed) {
        char name[EXERCISE_NAME];
        size_t length = strcspn(failed, ",");
        snprintf(name, sizeof name, "%.*s", (int)length, failed);
        if (strcmp(name, class_name) == 0)
            is_met = true;
        else if (!is_stricter(rule, name, class_name))
            return false;
        failed += length + (failed[length] == ',');
    }
    return is_met;
}

void expectation_failed_classes(const json_t *result, char *names, size_t capacity)
{
    size_t index, at = 0;
    json_t *entry;
    *names = '\0';
    json_array_foreach(json_object_get(result, "classes"), index, entry)
    {
        if (has_failed(entry) && at < capacity)
            at += (size_t)snprintf(names + at, capacity - at, "%s%s", at > 0 ? "," : "",
                                   json_string_value(json_object_get(entry, "name")));
    }
}
