/* The table of counted accesses; see page.h. */
#include "graders/report/bench/page.h"

#include <math.h>
#include <string.h>

static const struct {
    const char *query, *head;
} queries[] = {{"face-vertices", "vertices of a face"},
               {"face-neighbours", "neighbours of a face"},
               {"faces-around-vertex", "faces around a vertex"},
               {"vertices-around-vertex", "vertices around a vertex"},
               {"is-edge", "is {u,v} an edge?"}};
enum { QUERIES = sizeof queries / sizeof *queries };

static const json_t *find(const json_t *accesses, const char *subject, const char *query)
{
    size_t i;
    const json_t *row;
    json_array_foreach(accesses, i, row)
    {
        if (strcmp(study_text(row, "subject"), subject) == 0 &&
            strcmp(study_text(row, "query"), query) == 0)
            return row;
    }
    return NULL;
}

/* "n 13 → 13" */
static void write_pair(struct html *page, const json_t *row, const char *by, const char *letter)
{
    const json_t *pair = json_object_get(row, by);
    double low = study_number(json_array_get(pair, 0), "accesses");
    double high = study_number(json_array_get(pair, 1), "accesses");
    if (isnan(low) || isnan(high))
        return;
    html_open(page, "small");
    html_format(page, "%s %.*f → %.*f", letter, low < 100 && low != floor(low), low,
                high < 100 && high != floor(high), high);
    html_close(page, "small");
}

static void write_cell(struct html *page, const json_t *row)
{
    bool holds = json_is_true(json_object_get(row, "holds"));
    html_open(page, "td");
    html_attribute(page, "class", holds ? "time" : "time fails");
    html_format(page, "%s%s", holds ? "" : "✗ ", study_text(row, "claim"));
    write_pair(page, row, "by_size", "n:");
    write_pair(page, row, "by_valence", "k:");
    html_close(page, "td");
}

static void write_rows(struct html *page, const json_t *accesses)
{
    size_t i;
    const json_t *row;
    const char *before = "";
    json_array_foreach(accesses, i, row)
    {
        const char *subject = study_text(row, "subject");
        if (strcmp(subject, before) == 0)
            continue;
        before = subject;
        html_open(page, "tr");
        html_open(page, "th");
        html_attribute(page, "scope", "row");
        html_text(page, study_text(row, "title"));
        html_close(page, "th");
        for (int k = 0; k < QUERIES; k++)
            write_cell(page, find(accesses, subject, queries[k].query));
        html_close(page, "tr");
    }
}

static void write_finding(struct html *page, const json_t *accesses)
{
    size_t i, holding = 0;
    const json_t *row;
    json_array_foreach(accesses, i, row)
    {
        holding += json_is_true(json_object_get(row, "holds"));
    }
    html_open(page, "p");
    html_format(page,
                "%zu of %zu costs grow as the structure's description says. An access reads a row "
                "of a table: a half edge, the corners of a triangle, a position. They are counted "
                "in the same source that is timed, compiled with a call before every read.",
                holding, json_array_size(accesses));
    html_close(page, "p");
}

void page_accesses(struct html *page, struct bench_page *context)
{
    const json_t *accesses = json_object_get(context->study->document, "accesses");
    const json_t *first = json_array_get(accesses, 0);
    const json_t *sizes = json_object_get(first, "by_size");
    const json_t *valences = json_object_get(first, "by_valence");
    const char *names[QUERIES + 1] = {"representation"};
    char caption[400];
    if (json_array_size(accesses) == 0)
        return;
    for (int k = 0; k < QUERIES; k++)
        names[k + 1] = queries[k].head;
    snprintf(
        caption, sizeof caption,
        "Accesses of one query: what is claimed (1 constant, k valence or sides of the face, n "
        "all faces or edges, lg s a search among strips), and below it what was counted. n: "
        "on tori of %.0f and of %.0f triangles. k: at vertices of valence %.0f and %.0f; for "
        "faces, with one and with two vertices of the higher valence.",
        study_number(json_array_get(sizes, 0), "triangles"),
        study_number(json_array_get(sizes, 1), "triangles"),
        study_number(json_array_get(valences, 0), "valence"),
        study_number(json_array_get(valences, 1), "valence"));
    html_open(page, "section");
    html_attribute(page, "id", "accesses");
    html_leaf(page, "h2", NULL, "What queries cost, counted");
    write_finding(page, accesses);
    table_open(page, context, caption);
    table_head(page, names, QUERIES + 1);
    html_open(page, "tbody");
    write_rows(page, accesses);
    html_close(page, "tbody");
    table_close(page);
    html_close(page, "section");
}
