/* Checks exercises against their judges; see soundness.h. */
#include "graders/engine/run/soundness.h"

#include "graders/judges/table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* An exercise and its judge; `file` is the judge's, for errors. */
struct pair {
    const struct exercise *exercise;
    const struct judge *judge;
    char file[3 * EXERCISE_NAME];
};

static bool has_class(const struct exercise *exercise, const char *name)
{
    for (int i = 0; i < exercise->class_count; i++)
        if (strcmp(exercise->classes[i].name, name) == 0)
            return true;
    return false;
}

static bool has_case(const struct judge *judge, const char *class)
{
    for (size_t i = 0; i < judge->case_count; i++)
        if (strcmp(judge->cases[i].class_name, class) == 0)
            return true;
    return false;
}

static int check_classes(const struct pair *pair, struct error *err)
{
    const struct exercise *exercise = pair->exercise;
    for (size_t i = 0; i < pair->judge->case_count; i++) {
        const struct judge_case *c = &pair->judge->cases[i];
        if (!has_class(exercise, c->class_name))
            return error_set(err,
                             "%s: case %s is of class %s, which exercise.json does not name; "
                             "correct one of them",
                             pair->file, c->name, c->class_name);
    }
    for (int i = 0; i < exercise->class_count; i++)
        if (!has_case(pair->judge, exercise->classes[i].name))
            return error_set(err,
                             "%s/exercise.json: class %s has no case; add one to %s or take the "
                             "class out",
                             exercise->folder, exercise->classes[i].name, pair->file);
    return 0;
}

static int check_cases(const struct pair *pair, struct error *err)
{
    bool any_public = false, any_quick = false;
    for (size_t i = 0; i < pair->judge->case_count; i++) {
        const struct judge_case *c = &pair->judge->cases[i];
        any_public |= judge_case_is_public(c);
        any_quick |= judge_case_is_quick(c);
        for (size_t k = 0; k < i; k++) {
            if (strcmp(pair->judge->cases[k].name, c->name) == 0)
                return error_set(err, "%s: two cases are called %s; rename one", pair->file,
                                 c->name);
            if (pair->judge->cases[k].seed == c->seed)
                return error_set(err, "%s: cases %s and %s have the same seed; change one",
                                 pair->file, pair->judge->cases[k].name, c->name);
        }
    }
    if (!any_public || !any_quick)
        return error_set(err, "%s: no case is %s; make one so", pair->file,
                         any_public ? "quick" : "public");
    return 0;
}

static int check_families(const struct pair *pair, struct error *err)
{
    int family_count = judge_family_count(pair->judge);
    bool judged = pair->exercise->checked[CHECK_GROWTH];
    if (judged != (family_count > 0))
        return error_set(err, "%s: %s families, and exercise.json %s growth; correct one of them",
                         pair->file, judged ? "has no" : "has",
                         judged ? "judges" : "does not judge");
    bool asked = false;
    for (int i = 0; i < family_count; i++)
        asked |= pair->judge->families[i].is_query;
    if (asked != pair->exercise->checked[CHECK_QUERY_GROWTH])
        return error_set(err,
                         "%s: has %sfamily of queries, and exercise.json %s query-growth; correct "
                         "one of them",
                         pair->file, asked ? "a " : "no ", asked ? "does not judge" : "judges");
    for (int i = 0; judged && i < family_count; i++) {
        if (i == FAMILIES_MAX)
            return error_set(err, "%s: has more than %d families; take some out", pair->file,
                             FAMILIES_MAX);
        for (int k = 0; k < i; k++)
            if (strcmp(judge_family_name(pair->judge, k), judge_family_name(pair->judge, i)) == 0)
                return error_set(err, "%s: two families are called %s; rename one", pair->file,
                                 judge_family_name(pair->judge, i));
    }
    return 0;
}

/* The first class decides whether checks count: it is one of correctness. */
static int check_band(const struct pair *pair, const struct quality_band *band, struct error *err)
{
    const struct quality_rule *rule = &pair->judge->quality;
    const char *class = band->class_name;
    if (!has_class(pair->exercise, class))
        return error_set(err,
                         "%s: a band of quality is of class %s, which exercise.json does not "
                         "name; correct one of them",
                         pair->file, class);
    if (strcmp(pair->exercise->classes[0].name, class) == 0)
        return error_set(err,
                         "%s: a band of quality is of class %s, the first, which right answers "
                         "pass; set it for another class",
                         pair->file, class);
    if (quality_band_of(rule, class) != band)
        return error_set(err, "%s: two bands of quality are of class %s; take one out", pair->file,
                         class);
    if (!isfinite(band->limit))
        return error_set(err, "%s: the band of quality of class %s is %g; use a finite number",
                         pair->file, class, band->limit);
    return 0;
}

static int check_quality(const struct pair *pair, struct error *err)
{
    const struct quality_rule *rule = &pair->judge->quality;
    int band_count = quality_band_count(rule);
    if (band_count > 0 && !quality_is_measured(rule))
        return error_set(err, "%s: has bands of quality without its name; write .quality.name",
                         pair->file);
    if (!rule->name.en != !rule->name.es || !rule->unit.en != !rule->unit.es)
        return error_set(err, "%s: name and unit of quality are in one language; write both",
                         pair->file);
    for (int i = 0; i < band_count; i++)
        if (check_band(pair, &rule->bands[i], err) != 0)
            return -1;
    return 0;
}

int soundness_check(const struct exercise *exercise, const struct judge *judge, struct error *err)
{
    struct pair pair = {exercise, judge, ""};
    snprintf(pair.file, sizeof pair.file, "graders/judges/%s/%s.c", exercise->group,
             exercise->name);
    if (!judge)
        return error_set(err,
                         "%s/exercise.json: this program has no judge %s; write it, and build anew",
                         exercise->folder, pair.file);
    if (judge->case_count == 0)
        return error_set(err, "%s: has no cases; add some", pair.file);
    if (check_classes(&pair, err) != 0 || check_cases(&pair, err) != 0 ||
        check_quality(&pair, err) != 0)
        return -1;
    return check_families(&pair, err);
}

int soundness_read(const char *root, struct exercise **exercises, int *count, struct error *err)
{
    if (exercises_read(root, exercises, count, err) != 0)
        return -1;
    for (int i = 0; i < *count; i++) {
        const struct judge *judge = judge_find((*exercises)[i].name);
        if (judge && soundness_check(&(*exercises)[i], judge, err) != 0) {
            free(*exercises);
            *exercises = NULL;
            *count = 0;
            return -1;
        }
    }
    return 0;
}
