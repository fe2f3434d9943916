/* The tables of the page; see page.h. */
#include "graders/report/bench/page.h"

#include <math.h>
#include <string.h>

/* ---------------------------------------------------------------- parts */

void table_open(struct html *page, struct bench_page *context, const char *caption)
{
    html_open(page, "div");
    html_attribute(page, "class", "scroll");
    html_attribute(page, "tabindex", "0");
    html_open(page, "table");
    html_open(page, "caption");
    html_open(page, "b");
    html_format(page, "Table %d. ", ++context->tables);
    html_close(page, "b");
    html_text(page, caption);
    html_close(page, "caption");
}

void table_close(struct html *page)
{
    html_close(page, "table");
    html_close(page, "div");
}

void table_head(struct html *page, const char *const *names, size_t count)
{
    html_open(page, "thead");
    html_open(page, "tr");
    for (size_t i = 0; i < count; i++) {
        html_open(page, "th");
        html_attribute(page, "scope", "col");
        html_text(page, names[i]);
        html_close(page, "th");
    }
    html_close(page, "tr");
    html_close(page, "thead");
}

void table_cell(struct html *page, const char *class_name, const char *text)
{
    html_leaf(page, "td", class_name, text);
}

static void row_head(struct html *page, const char *text)
{
    html_open(page, "th");
    html_attribute(page, "scope", "row");
    html_text(page, text);
    html_close(page, "th");
}

void ratio_words(const json_t *ratio, char *text, size_t capacity)
{
    double median = study_number(ratio, "median");
    double low = study_number(ratio, "low"), high = study_number(ratio, "high");
    if (isnan(median))
        snprintf(text, capacity, "%s", "");
    else if (json_is_true(json_object_get(ratio, "too_noisy")))
        snprintf(text, capacity, "%.3g to %.3g, too noisy", low, high);
    else if (!study_is_decided(ratio))
        snprintf(text, capacity, "× %.3g", median);
    else
        snprintf(text, capacity, "× %.3g (%.3g – %.3g)", median, low, high);
}

static const json_t *time_of(const json_t *row)
{
    const json_t *query = json_object_get(row, "ns_per_query");
    return json_is_object(query) ? query : json_object_get(row, "ns_per_triangle");
}

/* "1.80 ns (1.79 ns – 1.82 ns)", with "~" before it when the core was disturbed most of the time.
 */
static void time_words(const json_t *row, char *text, size_t capacity)
{
    char median[24], low[24], high[24];
    const json_t *time = time_of(row);
    study_time_words(study_number(time, "median"), median, sizeof median);
    study_time_words(study_number(time, "low"), low, sizeof low);
    study_time_words(study_number(time, "high"), high, sizeof high);
    if (isnan(study_number(time, "median")))
        snprintf(text, capacity, "–");
    else if (study_number(row, "blocks") < 2)
        snprintf(text, capacity, "%s", median);
    else
        snprintf(text, capacity, "%s%s (%s – %s)",
                 json_is_true(json_object_get(row, "noisy")) ? "~" : "", median, low, high);
}

/* ---------------------------------------------------------------- representations */

/* Time, and below it the ratio to the indexed mesh. */
static void time_cell(struct html *page, const json_t *row)
{
    char time[32], ratio[80];
    const char *error = study_text(row, "error");
    html_open(page, "td");
    html_attribute(page, "class", "time");
    study_time_words(study_time(row), time, sizeof time);
    ratio_words(json_object_get(row, "ratio"), ratio, sizeof ratio);
    html_text(page, *error ? "refused" : time);
    char *interval = strchr(ratio, '(');
    if (interval && interval > ratio)
        interval[-1] = '\0';
    if (*ratio)
        html_leaf(page, "small", NULL, ratio);
    if (interval)
        html_leaf(page, "small", NULL, interval);
    html_close(page, "td");
}

static void representation_row(struct html *page, const struct study *study, struct wanted wanted,
                               const char *const *operations, size_t count)
{
    char bytes[24] = "–";
    const char *title = study_title(study, "representations", wanted.subject);
    wanted.operation = "bytes";
    double size =
        study_number(json_object_get(study_find(study, &wanted), "bytes_per_triangle"), "measured");
    if (!isnan(size))
        snprintf(bytes, sizeof bytes, "%.1f", size);
    html_open(page, "tr");
    row_head(page, title);
    table_cell(page, NULL, bytes);
    for (size_t i = 0; i < count; i++) {
        wanted.operation = operations[i];
        time_cell(page, study_find(study, &wanted));
    }
    html_close(page, "tr");
}

/* Sweeps or queries of all representations on one mesh. */
static void representation_table(struct html *page, struct bench_page *context, const char *mesh,
                                 bool queries)
{
    enum { COLUMNS_MAX = 14 };
    const struct study *study = context->study;
    struct wanted wanted = {.what = "representations", .kind = "representation", .mesh = mesh};
    const char *subjects[STUDY_NAMES_MAX], *operations[COLUMNS_MAX], *names[COLUMNS_MAX + 2];
    char caption[256], words[120];
    size_t count = 0, subject_count = study_names(study, &wanted, "subject", subjects);
    for (size_t i = 0; study_operations[i] && count < COLUMNS_MAX; i++)
        if (study_is_query(study_operations[i]) == queries)
            operations[count++] = study_operations[i];
    names[0] = "representation";
    names[1] = "bytes a triangle";
    for (size_t i = 0; i < count; i++)
        names[i + 2] = study_operation(operations[i]);
    study_mesh_words(mesh, words, sizeof words);
    snprintf(caption, sizeof caption,
             "%s on the %s: time %s; below it, how many times that of the indexed mesh it is, with "
             "its interval.",
             queries ? "Queries" : "Sweeps", words, queries ? "of one query" : "a triangle");
    table_open(page, context, caption);
    table_head(page, names, count + 2);
    html_open(page, "tbody");
    for (size_t s = 0; s < subject_count; s++) {
        wanted.subject = subjects[s];
        representation_row(page, study, wanted, operations, count);
    }
    html_close(page, "tbody");
    table_close(page);
}

void page_representations(struct html *page, struct bench_page *context)
{
    const char *mesh = study_mesh(
        context->study, &(struct wanted){.what = "representations", .kind = "representation"});
    if (!mesh)
        return;
    representation_table(page, context, mesh, false);
    representation_table(page, context, mesh, true);
}

/* ---------------------------------------------------------------- other comparisons */

static void comparison_row(struct html *page, const json_t *row)
{
    char time[96], ratio[80], cold_ratio[80], limit[24], cold[24] = "";
    double cold_ns = study_number(json_object_get(row, "cold_ns_per_triangle"), "median");
    const json_t *fraction = json_object_get(row, "limit");
    const char *variant = study_text(row, "variant"), *error = study_text(row, "error");
    bool is_kernel = strcmp(study_text(row, "kind"), "kernel") == 0;
    time_words(row, time, sizeof time);
    ratio_words(json_object_get(row, "ratio"), ratio, sizeof ratio);
    ratio_words(json_object_get(row, "cold_ratio"), cold_ratio, sizeof cold_ratio);
    if (!isnan(cold_ns))
        study_time_words(cold_ns, cold, sizeof cold);
    snprintf(limit, sizeof limit, "%.0f %%", 100 * study_number(fraction, "fraction"));
    html_open(page, "tr");
    row_head(page, study_operation(study_text(row, "operation")));
    html_open(page, "td");
    html_text(page, is_kernel ? "ours" : study_text(row, "title"));
    if (*variant)
        html_format(page, ", %s", strcmp(variant, "plain") == 0 ? "plain C" : variant);
    html_close(page, "td");
    table_cell(page, NULL, *error ? error : time);
    table_cell(page, NULL, ratio);
    table_cell(page, NULL, study_text(json_object_get(row, "ratio"), "to"));
    table_cell(page, NULL, cold);
    table_cell(page, NULL, cold_ratio);
    table_cell(page, NULL, json_is_object(fraction) ? limit : "");
    table_cell(page, NULL, study_text(row, "answer"));
    html_close(page, "tr");
}

static void comparison_table(struct html *page, struct bench_page *context,
                             const struct wanted *wanted, const char *title)
{
    static const char *const names[] = {"operation", "who",        "time a triangle", "ratio", "to",
                                        "cold",      "cold ratio", "memory limit",    "answer"};
    const struct study *study = context->study;
    const char *operations[STUDY_NAMES_MAX];
    char caption[256], words[120];
    size_t count = study_names(study, wanted, "operation", operations);
    study_mesh_words(wanted->mesh, words, sizeof words);
    snprintf(caption, sizeof caption,
             "%s on the %s: medians over fresh processes with their intervals.", title, words);
    table_open(page, context, caption);
    table_head(page, names, sizeof names / sizeof *names);
    html_open(page, "tbody");
    for (size_t k = 0; k < count; k++) {
        size_t i;
        const json_t *row;
        json_array_foreach(study->rows, i, row)
        {
            if (study_matches(row, wanted) &&
                strcmp(study_text(row, "operation"), operations[k]) == 0)
                comparison_row(page, row);
        }
    }
    html_close(page, "tbody");
    table_close(page);
}

void page_comparison(struct html *page, struct bench_page *context, const char *what,
                     const char *title)
{
    struct wanted wanted = {.what = what};
    const char *first = study_mesh(context->study, &wanted), *meshes[STUDY_NAMES_MAX];
    bool is_section = strcmp(what, "kernels") != 0;
    if (!first)
        return;
    if (is_section) {
        html_open(page, "section");
        html_attribute(page, "id", what);
        html_leaf(page, "h2", NULL, title);
    }
    wanted.mesh = first;
    comparison_table(page, context, &wanted, title);
    wanted.mesh = NULL;
    size_t count = study_names(context->study, &wanted, "mesh", meshes);
    if (count > 1) {
        html_open(page, "details");
        html_leaf(page, "summary", NULL, "The same on the other meshes of the run");
        for (size_t m = 0; m < count; m++) {
            wanted.mesh = meshes[m];
            if (strcmp(meshes[m], first) != 0)
                comparison_table(page, context, &wanted, title);
        }
        html_close(page, "details");
    }
    if (is_section)
        html_close(page, "section");
}

/* ---------------------------------------------------------------- meshes and claims */

static void number_cell(struct html *page, const json_t *object, const char *key)
{
    html_open(page, "td");
    double number = study_number(object, key);
    if (isnan(number))
        html_text(page, "–");
    else
        html_format(page, "%.7g", number);
    html_close(page, "td");
}

void page_meshes(struct html *page, struct bench_page *context)
{
    static const char *const names[] = {"mesh",  "triangles",      "vertices",
                                        "edges", "boundary edges", "highest valence"};
    const json_t *meshes = json_object_get(context->study->document, "meshes"), *mesh;
    size_t i;
    if (json_array_size(meshes) == 0)
        return;
    table_open(page, context, "The meshes of the run.");
    table_head(page, names, sizeof names / sizeof *names);
    html_open(page, "tbody");
    json_array_foreach(meshes, i, mesh)
    {
        html_open(page, "tr");
        row_head(page, study_text(mesh, "name"));
        number_cell(page, mesh, "triangles");
        number_cell(page, mesh, "vertices");
        number_cell(page, mesh, "edges");
        number_cell(page, mesh, "boundary_edges");
        number_cell(page, mesh, "highest_valence");
        html_close(page, "tr");
    }
    html_close(page, "tbody");
    table_close(page);
}

static void claim_rows(struct html *page, const json_t *claims)
{
    size_t i;
    const json_t *claim;
    json_array_foreach(claims, i, claim)
    {
        bool holds = json_is_true(json_object_get(claim, "holds"));
        html_open(page, "tr");
        row_head(page, study_text(claim, "claim"));
        table_cell(page, NULL, study_text(claim, "source"));
        table_cell(page, NULL, study_text(claim, "mesh"));
        number_cell(page, claim, "claimed");
        number_cell(page, claim, "measured");
        table_cell(page, holds ? "holds" : "fails", holds ? "✓ holds" : "✗ does not hold");
        html_close(page, "tr");
    }
}

void page_claims(struct html *page, struct bench_page *context)
{
    static const char *const names[] = {"claim", "source", "mesh", "claimed", "measured", ""};
    const json_t *claims = json_object_get(context->study->document, "claims"), *claim;
    size_t i, holding = 0, count = json_array_size(claims);
    html_open(page, "section");
    html_attribute(page, "id", "claims");
    html_leaf(page, "h2", NULL, "Claims of the course, against measurement");
    json_array_foreach(claims, i, claim)
    {
        holding += json_is_true(json_object_get(claim, "holds"));
    }
    if (count == 0) {
        html_leaf(page, "p", "missing",
                  "Left out: the table of claims, for this run measured none.");
    } else {
        html_open(page, "p");
        html_format(page, "%zu of %zu claims hold within what they say.", holding, count);
        html_close(page, "p");
        table_open(page, context, "What the course's documents say, and what was measured.");
        table_head(page, names, sizeof names / sizeof *names);
        html_open(page, "tbody");
        claim_rows(page, claims);
        html_close(page, "tbody");
        table_close(page);
    }
    html_close(page, "section");
}
