/* Measures as JSON; see measures.h. */
#include "graders/engine/result/measures.h"

#include <math.h>
#include <string.h>

static json_t *rounded(double value)
{
    return json_real(round(value * 1000) / 1000);
}

static json_t *fit_json(const struct growth_fit *fit)
{
    return json_pack("{s:s, s:o, s:o}", "class", growth_class_name(fit->class), "exponent",
                     rounded(fit->exponent), "excess_percent", rounded(100 * fit->excess));
}

static json_t *family_json(const struct trial *trial, int family)
{
    const struct yardstick *yardstick = trial->yardstick;
    const struct family_result *found = &trial->families[family];
    json_t *sizes = json_array(), *mine = json_array(), *theirs = json_array();
    for (int i = 0; i < found->size_count; i++) {
        if (!found->costs[i].counted)
            continue;
        json_array_append_new(sizes, json_integer(yardstick->inputs.told_sizes[i]));
        json_array_append_new(mine, json_integer(found->costs[i].counts.instructions));
        if (yardstick->costs[family][i].counted)
            json_array_append_new(theirs,
                                  json_integer(yardstick->costs[family][i].counts.instructions));
    }
    json_t *json = json_pack("{s:s, s:o, s:o, s:o}", "name",
                             judge_family_name(yardstick->inputs.judge, family), "sizes", sizes,
                             "instructions", mine, "reference_instructions", theirs);
    if (found->fitted)
        json_object_set_new(json, "fit", fit_json(&found->fit));
    if (yardstick->inputs.judge->families[family].is_query)
        json_object_set_new(json, "allowed",
                            json_string(yardstick->inputs.exercise->growth_allowed[PART_QUERY]));
    return json;
}

static json_t *growth_json(const struct trial *trial)
{
    const struct exercise *exercise = trial->yardstick->inputs.exercise;
    json_t *families = json_array();
    for (int family = 0; family < trial->yardstick->inputs.family_count; family++)
        if (trial->families[family].size_count > 0)
            json_array_append_new(families, family_json(trial, family));
    return json_pack("{s:s, s:{s:s, s:s}, s:o}", "allowed", exercise->growth_allowed[PART_BUILD],
                     "elements", "en", exercise->growth_elements.en, "es",
                     exercise->growth_elements.es, "families", families);
}

static json_t *family_memory_json(const struct trial *trial, int family)
{
    const struct yardstick *yardstick = trial->yardstick;
    json_t *sizes = json_array(), *mine = json_array(), *theirs = json_array();
    for (int i = 0; i <= inputs_beyond(&yardstick->inputs); i++) {
        const struct cost *cost = &trial->families[family].costs[i];
        json_array_append_new(sizes, json_integer(yardstick->inputs.told_sizes[i]));
        json_array_append_new(mine, json_integer(cost->heap_peak_bytes));
        json_array_append_new(theirs, json_integer(yardstick->costs[family][i].heap_peak_bytes));
    }
    return json_pack("{s:s, s:o, s:o, s:o}", "name",
                     judge_family_name(yardstick->inputs.judge, family), "sizes", sizes,
                     "peak_bytes", mine, "reference_peak_bytes", theirs);
}

static json_t *memory_json(const struct trial *trial, enum exercise_part part)
{
    const struct part_result *result = &trial->parts[part];
    const struct yardstick *yardstick = trial->yardstick;
    int at = result->memory_size, family = result->memory_family;
    json_t *families = json_array();
    json_array_append_new(families, family_memory_json(trial, family)); /* what decides is first */
    for (int i = 0; i < yardstick->inputs.family_count; i++)
        if (i != family && yardstick->inputs.judge->families[i].is_query == (part == PART_QUERY))
            json_array_append_new(families, family_memory_json(trial, i));
    const struct cost *mine = &trial->families[family].costs[at];
    const struct cost *theirs = &yardstick->costs[family][at];
    return json_pack("{s:o, s:I, s:I, s:I, s:o, s:o, s:I, s:I, s:I}", "families", families, "size",
                     (json_int_t)yardstick->inputs.told_sizes[at], "peak_bytes",
                     (json_int_t)mine->heap_peak_bytes, "reference_peak_bytes",
                     (json_int_t)theirs->heap_peak_bytes, "ratio", rounded(result->memory_ratio),
                     "band", rounded(yardstick->inputs.exercise->memory_band[part]), "allocations",
                     (json_int_t)mine->allocation_count, "stack_bytes",
                     (json_int_t)mine->stack_bytes, "static_bytes",
                     (json_int_t)trial->build.static_bytes);
}

static struct phrase class_title(const struct exercise *exercise, const char *name)
{
    for (int i = 0; i < exercise->class_count; i++)
        if (strcmp(exercise->classes[i].name, name) == 0)
            return message_phrase(&exercise->classes[i].title);
    return (struct phrase){name, name};
}

static json_t *phrase_json(struct phrase phrase)
{
    return json_pack("{s:s, s:s}", "en", phrase_text(phrase, LANGUAGE_EN), "es",
                     phrase_text(phrase, LANGUAGE_ES));
}

static json_t *bands_json(const struct trial *trial)
{
    const struct quality_rule *rule = &trial->yardstick->inputs.judge->quality;
    json_t *bands = json_array();
    for (int i = 0; i < quality_band_count(rule); i++) {
        const struct quality_band *band = &rule->bands[i];
        struct phrase title = class_title(trial->yardstick->inputs.exercise, band->class_name);
        json_array_append_new(bands, json_pack("{s:s, s:o, s:f}", "class", band->class_name, "name",
                                               phrase_json(quality_band_name(band, title)), "limit",
                                               band->limit));
    }
    return bands;
}

/* The attempt with the worst number, of all cases or of those whose class has a band; NULL when
 * none has a number. Those with a band speak for the whole: other inputs may allow no good answer.
 */
static const struct attempt *worst_of(const struct trial *trial, bool of_bands)
{
    const struct judge *judge = trial->yardstick->inputs.judge;
    const struct attempt *worst = NULL;
    for (size_t i = 0; i < judge->case_count; i++) {
        const struct attempt *attempt = &trial->cases[i].attempt;
        bool has_band = quality_band_of(&judge->quality, judge->cases[i].class_name) != NULL;
        if (trial->cases[i].run && attempt->has_quality && (has_band || !of_bands) &&
            (!worst || quality_is_worse(&judge->quality, attempt->quality, worst->quality)))
            worst = attempt;
    }
    return worst;
}

/* NULL when no case has a number. */
static json_t *quality_json(const struct trial *trial)
{
    const struct quality_rule *rule = &trial->yardstick->inputs.judge->quality;
    const struct attempt *worst = worst_of(trial, true);
    if (!worst)
        worst = worst_of(trial, false);
    if (!worst)
        return NULL;
    json_t *json =
        json_pack("{s:o, s:b, s:f, s:o}", "name", phrase_json(rule->name), "less_is_better",
                  rule->less_is_better, "worst", worst->quality, "bands", bands_json(trial));
    if (rule->unit.en)
        json_object_set_new(json, "unit", phrase_json(rule->unit));
    return json;
}

static json_t *family_accesses_json(const struct trial *trial, int family)
{
    const struct yardstick *yardstick = trial->yardstick;
    const struct family_result *found = &trial->families[family];
    json_t *sizes = json_array(), *mine = json_array(), *theirs = json_array();
    for (int i = 0; i < found->size_count; i++) {
        if (!found->costs[i].counted || !yardstick->costs[family][i].counted)
            continue;
        json_array_append_new(sizes, json_integer(yardstick->inputs.told_sizes[i]));
        json_array_append_new(mine, json_integer(found->costs[i].access_count));
        json_array_append_new(theirs, json_integer(yardstick->costs[family][i].access_count));
    }
    return json_pack("{s:s, s:o, s:o, s:o}", "name",
                     judge_family_name(yardstick->inputs.judge, family), "sizes", sizes, "accesses",
                     mine, "reference_accesses", theirs);
}

static json_t *accesses_json(const struct trial *trial)
{
    json_t *families = json_array();
    json_array_append_new(families, family_accesses_json(trial, trial->access_family));
    for (int i = 0; i < trial->yardstick->inputs.family_count; i++)
        if (i != trial->access_family)
            json_array_append_new(families, family_accesses_json(trial, i));
    return json_pack("{s:o, s:o, s:o}", "ratio", rounded(trial->access_ratio), "band",
                     rounded(trial->yardstick->inputs.exercise->access_band), "families", families);
}

static json_t *work_json(const struct trial *trial, enum exercise_part part)
{
    const struct part_result *result = &trial->parts[part];
    return json_pack("{s:o, s:o, s:o, s:o}", "ratio", rounded(result->work_ratio), "band",
                     rounded(trial->yardstick->inputs.exercise->work_band[part]),
                     "instruction_ratio", rounded(result->instruction_ratio), "miss_ratio",
                     rounded(result->miss_ratio));
}

json_t *measures_json(const struct trial *trial)
{
    static const char *const work_keys[] = {"work", "query_work"};
    static const char *const memory_keys[] = {"memory", "query_memory"};
    json_t *measures = json_object();
    if (trial->families[0].size_count > 0)
        json_object_set_new(measures, "growth", growth_json(trial));
    for (int part = 0; part < PART_COUNT; part++) {
        if (trial->parts[part].work_ratio > 0)
            json_object_set_new(measures, work_keys[part], work_json(trial, part));
        if (trial->parts[part].memory_ratio > 0)
            json_object_set_new(measures, memory_keys[part], memory_json(trial, part));
    }
    if (trial->access_ratio > 0)
        json_object_set_new(measures, "accesses", accesses_json(trial));
    json_t *quality = quality_json(trial);
    if (quality)
        json_object_set_new(measures, "quality", quality);
    return measures;
}
