/* How near each variant of each kernel comes to the machine's copy bandwidth. */
#include "graders/report/bench/figures.h"

#include <math.h>
#include <string.h>

static const struct wanted kernels = {.what = "kernels", .kind = "kernel"};

static double fraction_of(const json_t *row)
{
    return study_number(json_object_get(row, "limit"), "fraction");
}

/* The mesh with most fractions: that of the kernels' rows. NULL when there is no fraction. */
static const char *choose_mesh(const struct study *study)
{
    struct wanted here = kernels;
    here.mesh = study_mesh(study, &kernels);
    size_t i;
    const json_t *row;
    json_array_foreach(study->rows, i, row)
    {
        if (here.mesh && study_matches(row, &here) && fraction_of(row) > 0)
            return here.mesh;
    }
    return NULL;
}

static enum look look_of(const char *variant)
{
    static const char *const variants[] = {"plain", "avx2", "avx512", "threads"};
    static const enum look looks[] = {LOOK_GREY, LOOK_SKY, LOOK_BLUE, LOOK_ORANGE};
    for (size_t i = 0; i < sizeof variants / sizeof *variants; i++)
        if (strcmp(variants[i], variant) == 0)
            return looks[i];
    return LOOK_DARK;
}

static json_t *bars_of(const struct study *study, const struct wanted *wanted)
{
    json_t *bars = json_array();
    size_t i;
    const json_t *row;
    json_array_foreach(study->rows, i, row)
    {
        char label[64], ns[24];
        double fraction = fraction_of(row);
        const char *variant = study_text(row, "variant");
        if (!study_matches(row, wanted) || !(fraction > 0))
            continue;
        study_time_words(study_time(row), ns, sizeof ns);
        snprintf(label, sizeof label, "%.0f %%   %s", 100 * fraction, ns);
        json_array_append_new(bars, json_pack("{s:s, s:s, s:f, s:i}", "name",
                                              strcmp(variant, "plain") == 0 ? "plain C" : variant,
                                              "label", label, "value", 100 * fraction, "look",
                                              (int)look_of(variant)));
    }
    return bars;
}

static json_t *scene(const struct study *study)
{
    struct wanted wanted = kernels;
    const char *operations[STUDY_NAMES_MAX];
    char words[100];
    wanted.mesh = choose_mesh(study);
    if (!wanted.mesh)
        return NULL;
    size_t count = study_names(study, &wanted, "operation", operations);
    json_t *groups = json_array();
    for (size_t i = 0; i < count; i++) {
        char title[80];
        wanted.operation = operations[i];
        figure_operation_title(operations[i], title, sizeof title);
        json_array_append_new(
            groups, json_pack("{s:s, s:o}", "title", title, "bars", bars_of(study, &wanted)));
    }
    study_mesh_words(wanted.mesh, words, sizeof words);
    return json_pack("{s:s, s:s, s:s, s:s, s:[o], s:o}", "kind", "bars", "title",
                     "How near the kernels come to the memory limit", "subtitle", words, "x_label",
                     "% of copy bandwidth: bytes that must move / time (labels: ns a triangle)",
                     "guides", figure_guide("x", 100, "copy bandwidth"), "groups", groups);
}

static void finding(const struct study *study, FILE *to)
{
    struct wanted wanted = kernels;
    const json_t *nearest = NULL, *farthest = NULL;
    const char *operations[STUDY_NAMES_MAX];
    wanted.mesh = choose_mesh(study);
    size_t count = study_names(study, &wanted, "operation", operations);
    for (size_t k = 0; k < count; k++) {
        const json_t *best = NULL;
        size_t i;
        const json_t *row;
        wanted.operation = operations[k];
        json_array_foreach(study->rows, i, row)
        {
            if (study_matches(row, &wanted) && study_number(row, "threads") < 2 &&
                fraction_of(row) > 0 && (!best || fraction_of(row) > fraction_of(best)))
                best = row;
        }
        if (best && (!nearest || fraction_of(best) > fraction_of(nearest)))
            nearest = best;
        if (best && (!farthest || fraction_of(best) < fraction_of(farthest)))
            farthest = best;
    }
    if (!nearest)
        return;
    fprintf(to, "On one thread, the best variants reach from %.0f %% (%s, %s) ",
            100 * fraction_of(farthest), study_operation(study_text(farthest, "operation")),
            study_text(farthest, "variant"));
    fprintf(to, "to %.0f %% (%s, %s) of what this core copies.", 100 * fraction_of(nearest),
            study_operation(study_text(nearest, "operation")), study_text(nearest, "variant"));
    if (fraction_of(nearest) > 1)
        fprintf(to, " More than all of it is possible: a mesh that stays in a cache is read "
                    "faster than memory is copied.");
}

const struct figure figure_limit = {.name = "limit",
                                    .label = "Fraction of the memory limit, by kernel and variant",
                                    .width = 1200,
                                    .height = 980,
                                    .scene = scene,
                                    .finding = finding,
                                    .absent = "no kernel was measured"};
