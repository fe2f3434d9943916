/* Heat map of representation and operation: times the fastest. */
#include "graders/report/bench/figures.h"

#include <math.h>
#include <string.h>

enum { OPERATIONS_MAX = 16, COLOUR_MOST = 1000 };

struct table {
    const char *mesh;
    const char *subjects[STUDY_NAMES_MAX];
    size_t subject_count;
    const char *operations[OPERATIONS_MAX];
    size_t operation_count;
    double ns[STUDY_NAMES_MAX][OPERATIONS_MAX]; /* NaN: not measured */
    double fastest[OPERATIONS_MAX];
};

static void add_operation(struct table *table, const struct study *study, struct wanted wanted)
{
    size_t column = table->operation_count;
    double fastest = (double)INFINITY;
    for (size_t s = 0; s < table->subject_count; s++) {
        wanted.subject = table->subjects[s];
        double ns = study_time(study_find(study, &wanted));
        table->ns[s][column] = ns > 0 ? ns : (double)NAN;
        if (ns > 0)
            fastest = fmin(fastest, ns);
    }
    if (isinf(fastest))
        return;
    table->operations[column] = wanted.operation;
    table->fastest[column] = fastest;
    table->operation_count++;
}

static bool collect(const struct study *study, struct table *table)
{
    struct wanted wanted = {.what = "representations", .kind = "representation"};
    *table = (struct table){.mesh = study_mesh(study, &wanted)};
    wanted.mesh = table->mesh;
    if (!table->mesh)
        return false;
    table->subject_count = study_names(study, &wanted, "subject", table->subjects);
    for (size_t i = 0; study_operations[i] && table->operation_count < OPERATIONS_MAX; i++) {
        wanted.operation = study_operations[i];
        add_operation(table, study, wanted);
    }
    return table->operation_count > 0 && table->subject_count > 1;
}

static double slowest_ratio(const struct table *table, size_t *subject, size_t *operation)
{
    double most = 1;
    *subject = *operation = 0;
    for (size_t s = 0; s < table->subject_count; s++)
        for (size_t o = 0; o < table->operation_count; o++)
            if (table->ns[s][o] / table->fastest[o] > most) {
                most = table->ns[s][o] / table->fastest[o];
                *subject = s;
                *operation = o;
            }
    return most;
}

static json_t *cells_of(const struct table *table, size_t subject)
{
    json_t *cells = json_array();
    for (size_t o = 0; o < table->operation_count; o++) {
        char label[32];
        double ratio = table->ns[subject][o] / table->fastest[o];
        study_number_words(ratio, label, sizeof label);
        json_t *cell = json_pack("{s:s}", "label", label);
        figure_number(cell, "value", ratio);
        json_array_append_new(cells, cell);
    }
    return cells;
}

static json_t *scene(const struct study *study)
{
    static struct table table;
    char words[100], subtitle[200], high_label[64];
    size_t ignored_subject, ignored_operation;
    if (!collect(study, &table))
        return NULL;
    json_t *rows = json_array(), *columns = json_array(), *cells = json_array();
    for (size_t s = 0; s < table.subject_count; s++) {
        json_array_append_new(
            rows, json_string(study_title(study, "representations", table.subjects[s])));
        json_array_append_new(cells, cells_of(&table, s));
    }
    for (size_t o = 0; o < table.operation_count; o++)
        json_array_append_new(columns, json_string(study_operation_short(table.operations[o])));
    double slowest = slowest_ratio(&table, &ignored_subject, &ignored_operation);
    double most = fmin(fmax(2, slowest), COLOUR_MOST);
    snprintf(high_label, sizeof high_label, "%.0f times as long%s", most,
             slowest > most ? " or longer" : "");
    study_mesh_words(table.mesh, words, sizeof words);
    snprintf(subtitle, sizeof subtitle,
             "times as long as the fastest representation for the operation; %s", words);
    return json_pack("{s:s, s:s, s:s, s:o, s:o, s:o, s:f, s:f, s:s, s:s}", "kind", "heatmap",
                     "title", "What each operation costs in each representation", "subtitle",
                     subtitle, "rows", rows, "columns", columns, "cells", cells, "low", 1.0, "high",
                     most, "low_label", "the fastest", "high_label", high_label);
}

/* How many operations a representation is fastest in. */
static size_t wins(const struct table *table, size_t subject)
{
    size_t count = 0;
    for (size_t o = 0; o < table->operation_count; o++)
        count += table->ns[subject][o] <= table->fastest[o];
    return count;
}

static void finding(const struct study *study, FILE *to)
{
    static struct table table;
    size_t best = 0, slow_subject, slow_operation;
    char most[32];
    if (!collect(study, &table))
        return;
    for (size_t s = 1; s < table.subject_count; s++)
        if (wins(&table, s) > wins(&table, best))
            best = s;
    study_number_words(slowest_ratio(&table, &slow_subject, &slow_operation), most, sizeof most);
    size_t won = wins(&table, best);
    fprintf(to, "Most often the fastest: %s, in %zu of %zu operations%s. ",
            study_title(study, "representations", table.subjects[best]), won, table.operation_count,
            won == table.operation_count ? "" : "; none is the fastest in all");
    fprintf(to,
            "The dearest choice is %s for \"%s\": %s times as long as the fastest. Structures "
            "without the link that a query needs search the whole mesh for it.",
            study_title(study, "representations", table.subjects[slow_subject]),
            study_operation(table.operations[slow_operation]), most);
}

const struct figure figure_heat = {.name = "heat",
                                   .label = "Times the fastest, by representation and operation",
                                   .width = 1440,
                                   .height = 860,
                                   .scene = scene,
                                   .finding = finding,
                                   .absent = "no two representations were timed on one mesh"};
