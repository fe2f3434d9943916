/* Bytes per triangle by representation, formula against measured. */
#include "graders/report/bench/figures.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct wanted sizes = {
    .what = "representations", .kind = "representation", .operation = "bytes"};

struct size {
    const char *title;
    bool is_counted; /* by the allocation counter */
    double measured, formula;
};

static int by_bytes(const void *a, const void *b)
{
    const struct size *x = a, *y = b;
    return (x->measured > y->measured) - (x->measured < y->measured);
}

/* The sizes on the mesh that has most of them, smallest first. Returns how many. */
static size_t collect(const struct study *study, struct size list[STUDY_NAMES_MAX],
                      const char **mesh)
{
    struct wanted here = sizes;
    size_t i, count = 0;
    const json_t *row;
    here.mesh = *mesh = study_mesh(study, &sizes);
    if (!here.mesh)
        return 0;
    json_array_foreach(study->rows, i, row)
    {
        const json_t *bytes = json_object_get(row, "bytes_per_triangle");
        struct size one = {.title = study_text(row, "title"),
                           .is_counted = strcmp(study_text(bytes, "by"), "heap") == 0,
                           .measured = study_number(bytes, "measured"),
                           .formula = study_number(bytes, "formula")};
        if (study_matches(row, &here) && one.measured > 0 && count < STUDY_NAMES_MAX)
            list[count++] = one;
    }
    qsort(list, count, sizeof *list, by_bytes);
    return count;
}

static bool all_counted(const struct size *list, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!list[i].is_counted)
            return false;
    return true;
}

static json_t *scene(const struct study *study)
{
    struct size list[STUDY_NAMES_MAX] = {{0}};
    const char *mesh;
    char words[100];
    size_t count = collect(study, list, &mesh);
    if (count == 0)
        return NULL;
    json_t *bars = json_array();
    for (size_t i = 0; i < count; i++) {
        char label[32];
        snprintf(label, sizeof label, "%.1f", list[i].measured);
        json_t *bar = json_pack("{s:s, s:s, s:i, s:f}", "name", list[i].title, "label", label,
                                "look", (int)LOOK_BLUE, "value", list[i].measured);
        figure_number(bar, "tick", list[i].formula);
        json_array_append_new(bars, bar);
    }
    study_mesh_words(mesh, words, sizeof words);
    return json_pack(
        "{s:s, s:s, s:s, s:s, s:[{s:s, s:o}], s:[o, o]}", "kind", "bars", "title",
        "Bytes per triangle by representation", "subtitle", words, "x_label", "bytes a triangle",
        "groups", "title", "", "bars", bars, "legend",
        figure_key("bar", LOOK_BLUE,
                   all_counted(list, count) ? "counted on the heap" : "lengths of its tables"),
        figure_key("tick", LOOK_DARK, "formula"));
}

static void finding(const struct study *study, FILE *to)
{
    struct size list[STUDY_NAMES_MAX] = {{0}};
    const char *mesh;
    char words[100];
    size_t count = collect(study, list, &mesh), worst = 0;
    if (count == 0)
        return;
    for (size_t i = 1; i < count; i++)
        if (fabs(list[i].measured / list[i].formula - 1) >
            fabs(list[worst].measured / list[worst].formula - 1))
            worst = i;
    const struct size *least = &list[0], *most = &list[count - 1];
    double off = 100 * fabs(list[worst].measured / list[worst].formula - 1);
    study_mesh_words(mesh, words, sizeof words);
    fprintf(to,
            "On the %s a triangle takes from %.1f bytes (%s) to %.1f (%s): %.1f times as much. ",
            words, least->measured, least->title, most->measured, most->title,
            most->measured / least->measured);
    if (isnan(off))
        return;
    fputs(all_counted(list, count)
              ? "Measured is what building left on the heap, by the allocation counter. "
              : "Measured are the lengths of the structures' tables (--counts counts the heap). ",
          to);
    if (off < 0.05)
        fprintf(to, "In all %zu it is what the formula says.", count);
    else
        fprintf(to, "Formula and measurement differ most for %s, by %.1f %%.", list[worst].title,
                off);
}

const struct figure figure_bytes = {.name = "bytes",
                                    .label = "Bytes per triangle by representation",
                                    .width = 1200,
                                    .height = 820,
                                    .scene = scene,
                                    .finding = finding,
                                    .absent = "no representation was built"};
