/* Quality of right answers, and its bands; see quality.h. */
#include "graders/library/quality.h"

#include "reference/base/decimal.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

const struct cause quality_poor = {"poor-quality", {"poor quality", "poca calidad"}};

bool quality_is_measured(const struct quality_rule *rule)
{
    return rule->name.en != NULL;
}

int quality_band_count(const struct quality_rule *rule)
{
    int count = 0;
    while (count < QUALITY_BANDS && rule->bands[count].class_name)
        count++;
    return count;
}

const struct quality_band *quality_band_of(const struct quality_rule *rule, const char *class_name)
{
    for (int i = 0; i < quality_band_count(rule); i++)
        if (class_name && strcmp(rule->bands[i].class_name, class_name) == 0)
            return &rule->bands[i];
    return NULL;
}

struct phrase quality_band_name(const struct quality_band *band, struct phrase class_title)
{
    static const struct {
        const char *class_name;
        struct phrase name;
    } usual[] = {{"quality-fair", {"fair", "aceptable"}},
                 {"quality-good", {"good", "buena"}},
                 {"quality-best", {"best", "óptima"}}};
    if (band->name.en)
        return band->name;
    for (size_t i = 0; i < sizeof usual / sizeof *usual; i++)
        if (strcmp(usual[i].class_name, band->class_name) == 0)
            return usual[i].name;
    return class_title;
}

bool quality_is_worse(const struct quality_rule *rule, double a, double b)
{
    return rule->less_is_better ? a > b : a < b;
}

/* "1.31 indices per triangle", or with a unit "smallest angle 23.1 degrees". */
static void say_measured(struct message *message, const struct quality_rule *rule,
                         const char *number)
{
    if (rule->unit.en) {
        message_en(message, "%s %s %s", rule->name.en, number, rule->unit.en);
        message_es(message, "%s %s %s", rule->name.es, number, rule->unit.es);
    } else {
        message_en(message, "%s %s", number, rule->name.en);
        message_es(message, "%s %s", number, rule->name.es);
    }
}

static void reject(const struct quality_rule *rule, double limit, struct judgement *out)
{
    char number[DECIMAL_BYTES], allowed[DECIMAL_BYTES];
    struct message measured = {"", ""};
    decimal_write(out->quality, limit, number);
    decimal_write(limit, out->quality, allowed);
    say_measured(&measured, rule, number);
    if (!judge_reject_for(out, &quality_poor))
        return;
    message_clear(&out->message);
    judge_en(out, "The answer is right but poor: %s (at %s %s).", measured.en,
             rule->less_is_better ? "most" : "least", allowed);
    judge_es(out, "Respuesta correcta pero pobre: %s (%s %s).", measured.es,
             rule->less_is_better ? "máximo" : "mínimo", allowed);
}

int quality_judge(const struct quality_rule *rule, const char *class_name, struct judgement *out,
                  struct error *err)
{
    const struct quality_band *band = quality_band_of(rule, class_name);
    if (!out->accepted) {
        out->has_quality = false;
        return 0;
    }
    if (out->has_quality && !quality_is_measured(rule))
        return error_set(err, "the judge told a quality that it does not declare; name it in "
                              ".quality");
    if (out->has_quality && !isfinite(out->quality))
        return error_set(err,
                         "the quality of a right answer is %g; judge_quality() takes finite "
                         "numbers only",
                         out->quality);
    if (band && !out->has_quality)
        return error_set(err,
                         "class %s has a band of quality, and the judge accepted an answer without "
                         "a number; call judge_quality()",
                         class_name);
    if (band && quality_is_worse(rule, out->quality, band->limit))
        reject(rule, band->limit, out);
    return 0;
}
