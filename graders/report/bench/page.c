/* The page of a benchmark run; see page.h. */
#include "graders/report/bench/page.h"

#include "graders/report/documents.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static bool has_picture(const struct bench_page *context, const struct figure *figure)
{
    char path[DOCUMENT_PATH_BYTES];
    struct error ignored = {""};
    return document_path(path, &ignored, "%s/pictures/%s.png", context->folder, figure->name) ==
               0 &&
           access(path, R_OK) == 0;
}

static void write_image(struct html *page, const struct figure *figure)
{
    char path[96];
    snprintf(path, sizeof path, "pictures/%s.png", figure->name);
    html_open(page, "a");
    html_path(page, "href", path);
    html_open(page, "img");
    html_path(page, "src", path);
    html_attribute(page, "alt", figure->label);
    html_attribute_format(page, "width", "%d", figure->width);
    html_attribute_format(page, "height", "%d", figure->height);
    html_close(page, "img");
    html_close(page, "a");
}

void page_figure(struct html *page, struct bench_page *context, const struct figure *figure)
{
    json_t *scene = figure->scene(context->study);
    bool shown = scene != NULL;
    json_decref(scene);
    if (!shown) {
        html_open(page, "p");
        html_attribute(page, "class", "missing");
        html_format(page, "Left out: %s, for %s.", figure->label, figure->absent);
        html_close(page, "p");
        return;
    }
    char *words = figure_words(figure, context->study);
    html_open(page, "figure");
    html_attribute(page, "id", figure->name);
    if (has_picture(context, figure))
        write_image(page, figure);
    html_open(page, "figcaption");
    html_open(page, "b");
    html_format(page, "Figure %d. ", ++context->figures);
    html_close(page, "b");
    html_text(page, words ? words : figure->label);
    html_close(page, "figcaption");
    html_close(page, "figure");
    free(words);
}

static void write_head(struct html *page, const struct study *study)
{
    html_open(page, "head");
    html_open(page, "meta");
    html_attribute(page, "charset", "utf-8");
    html_close(page, "meta");
    html_open(page, "meta");
    html_attribute(page, "name", "viewport");
    html_attribute(page, "content", "width=device-width, initial-scale=1");
    html_close(page, "meta");
    html_open(page, "title");
    html_format(page, "Mesh representations and kernels, measured %.10s",
                study_text(study->document, "date"));
    html_close(page, "title");
    html_open(page, "link");
    html_attribute(page, "rel", "stylesheet");
    html_path(page, "href", "assets/bench.css");
    html_close(page, "link");
    html_close(page, "head");
}

static void write_title(struct html *page, const struct study *study)
{
    const json_t *machine = json_object_get(study->document, "machine");
    html_open(page, "header");
    html_leaf(page, "h1", NULL, "Mesh representations and kernels: what each costs");
    html_open(page, "p");
    html_attribute(page, "class", "byline");
    html_format(page, "meshgrade %s", study_text(study->document, "version"));
    html_format(page, ", %s run", study_text(study->document, "mode"));
    html_format(page, " of %s", study_text(study->document, "date"));
    html_format(page, " on %s", study_text(machine, "cpu"));
    html_close(page, "p");
    if (!json_is_true(json_object_get(study->document, "complete")))
        html_leaf(page, "p", "note",
                  "The run was stopped before all of its blocks were measured: intervals are wider "
                  "than they need be, and some rows are missing. The same command goes on.");
    html_close(page, "header");
}

/* The findings of the figures that lead, as the abstract. */
static void write_abstract(struct html *page, const struct bench_page *context)
{
    static const struct figure *const leading[] = {&figure_bytes, &figure_heat, &figure_doubling,
                                                   &figure_peers, NULL};
    html_open(page, "section");
    html_attribute(page, "class", "abstract");
    html_leaf(page, "h2", NULL, "In short");
    html_open(page, "ul");
    for (size_t i = 0; leading[i]; i++) {
        json_t *scene = leading[i]->scene(context->study);
        char *words = scene ? figure_words(leading[i], context->study) : NULL;
        if (words)
            html_leaf(page, "li", NULL, words);
        free(words);
        json_decref(scene);
    }
    html_close(page, "ul");
    html_close(page, "section");
}

static void section(struct html *page, const char *id, const char *title)
{
    html_open(page, "section");
    html_attribute(page, "id", id);
    html_leaf(page, "h2", NULL, title);
}

static void write_question(struct html *page)
{
    section(page, "question", "Question");
    html_leaf(page, "p", NULL,
              "A triangle mesh can be kept in many ways: as isolated triangles, as strips, with "
              "shared vertices, with its edges linked. Each way is small or fast at something and "
              "poor at something else. What does each cost in bytes and in time, how does that "
              "change with the size and the order of the mesh, and how near do the basic kernels "
              "come to what the machine's memory allows?");
    html_close(page, "section");
}

static void write_results(struct html *page, struct bench_page *context)
{
    section(page, "representations", "Representations");
    page_figure(page, context, &figure_bytes);
    page_figure(page, context, &figure_heat);
    page_representations(page, context);
    page_figure(page, context, &figure_costs);
    html_close(page, "section");
    section(page, "limits-reached", "Strips and voxels: two claims in the limit");
    page_figure(page, context, &figure_strips);
    page_figure(page, context, &figure_voxels);
    html_close(page, "section");
    section(page, "kernels", "Kernels");
    page_figure(page, context, &figure_doubling);
    page_figure(page, context, &figure_limit);
    page_figure(page, context, &figure_peers);
    page_comparison(page, context, "kernels", "Kernels and peer libraries");
    html_close(page, "section");
}

static void write_pictures(struct html *page, struct bench_page *context)
{
    section(page, "pictures", "The representations in pictures");
    page_figure(page, context, &lesson_half_edge);
    page_figure(page, context, &lesson_winged_edge);
    page_figure(page, context, &lesson_strips);
    page_figure(page, context, &lesson_voxels);
    html_close(page, "section");
}

void bench_page_write(struct html *page, struct bench_page *context)
{
    html_open(page, "html");
    html_attribute(page, "lang", "en");
    write_head(page, context->study);
    html_open(page, "body");
    html_open(page, "main");
    write_title(page, context->study);
    if (*context->pictures_reason) {
        html_open(page, "p");
        html_attribute(page, "class", "note");
        html_format(page, "Pictures were not drawn: %s", context->pictures_reason);
        html_close(page, "p");
    }
    write_abstract(page, context);
    write_question(page);
    page_method(page, context);
    page_machine(page, context);
    write_results(page, context);
    page_comparison(page, context, "readers", "Reading mesh files");
    page_goals(page, context);
    page_comparison(page, context, "paper", "The operations of Sieger and Botsch (2011)");
    page_claims(page, context);
    page_accesses(page, context);
    write_pictures(page, context);
    page_limits(page, context);
    page_repeat(page, context);
    html_close(page, "main");
    html_close(page, "body");
    html_close(page, "html");
}
