/* A rejected case: what is wrong and where, its picture, a view to turn, the command to see it
 * again. */
#include "graders/report/page.h"

#include "graders/report/chart.h"
#include "graders/report/documents.h"

#include <stdio.h>
#include <string.h>

static const struct {
    const char *kind;
    struct phrase words;
} mark_words[] = {
    {"missing", {"missing", "falta"}},   {"duplicate", {"duplicate", "duplicada"}},
    {"extra", {"extra", "sobra"}},       {"degenerate", {"degenerate", "degenerada"}},
    {"boundary", {"boundary", "borde"}}, {"flipped", {"flipped", "invertida"}},
    {"wrong", {"wrong", "incorrecta"}},  {"right", {"should be", "debería ser"}},
};

/* What the scene, or that of the answer beside it, calls the marks of a kind, else the usual word.
 */
static struct phrase mark_name(const json_t *scene, const char *kind, struct phrase usual)
{
    const json_t *answer = json_object_get(scene, "answer");
    struct phrase name = words_in(json_object_get(scene, "mark_names"), kind);
    struct phrase other = words_in(json_object_get(answer, "mark_names"), kind);
    return *name.en ? name : *other.en ? other : usual;
}

/* Marks of a kind on the mesh and on that of the answer. */
static json_int_t mark_count(const json_t *scene, const char *kind)
{
    const json_t *counts = json_object_get(scene, "mark_counts");
    const json_t *others = json_object_get(json_object_get(scene, "answer"), "mark_counts");
    return json_integer_value(json_object_get(counts, kind)) +
           json_integer_value(json_object_get(others, kind));
}

static void write_legend_entry(struct html *page, const char *kind, struct phrase words,
                               json_int_t count)
{
    html_open(page, "li");
    html_open(page, "span");
    html_attribute_format(page, "class", "swatch mark-%s", kind);
    html_attribute(page, "aria-hidden", "true");
    html_close(page, "span");
    html_text(page, " ");
    html_both(page, words);
    html_format(page, " %lld", count);
    html_close(page, "li");
}

/* Turn colours: an entry for each that has a name of its own, and one for the others. */
static void write_turns(struct html *page, const json_t *scene)
{
    enum { TURNS = 6 };
    const struct phrase parts = {"parts", "partes"}, none = {"", ""};
    json_int_t others = 0;
    for (int turn = 0; turn < TURNS; turn++) {
        char kind[16];
        snprintf(kind, sizeof kind, "turn-%d", turn);
        json_int_t count = mark_count(scene, kind);
        struct phrase name = mark_name(scene, kind, none);
        if (*name.en && count > 0)
            write_legend_entry(page, kind, name, count);
        else
            others += count;
    }
    json_int_t all = json_integer_value(json_object_get(scene, "turn_count"));
    if (others > 0 || json_object_get(scene, "parts"))
        write_legend_entry(page, "turns", mark_name(scene, "turns", parts), all ? all : others);
}

/* The scale of values: "0.5 [bar] 1.5 mean curvature". */
static void write_scale(struct html *page, const json_t *values)
{
    if (!values)
        return;
    html_open(page, "li");
    html_format(page, "%.4g ", json_number_value(json_object_get(values, "low")));
    html_open(page, "span");
    html_attribute(page, "class", "swatch scale");
    html_attribute(page, "aria-hidden", "true");
    html_close(page, "span");
    html_format(page, " %.4g ", json_number_value(json_object_get(values, "high")));
    html_both(page, words_in(values, "unit"));
    html_close(page, "li");
}

static void write_legend(struct html *page, const json_t *scene)
{
    const json_t *ok_count = json_object_get(scene, "ok_count");
    html_open(page, "ul");
    html_attribute(page, "class", "legend");
    if (json_integer_value(ok_count) > 0)
        write_legend_entry(page, "ok", (struct phrase){"right", "correcta"},
                           json_integer_value(ok_count));
    for (size_t i = 0; i < sizeof mark_words / sizeof *mark_words; i++) {
        json_int_t count = mark_count(scene, mark_words[i].kind);
        if (count > 0)
            write_legend_entry(page, mark_words[i].kind,
                               mark_name(scene, mark_words[i].kind, mark_words[i].words), count);
    }
    write_turns(page, scene);
    write_scale(page, json_object_get(scene, "values"));
    write_scale(page, json_object_get(json_object_get(scene, "answer"), "values"));
    html_close(page, "ul");
    if (json_is_true(json_object_get(scene, "cut")))
        html_both_leaf(page, "p", "quiet",
                       (struct phrase){"Only the neighbourhood of the marks is shown.",
                                       "Solo se muestra el entorno de las marcas."});
}

/* The view's data stands in a script of its own, because a page that was opened from a file may
 * load scripts and nothing else; viewer.js loads it when it is asked for. */
static int write_scene_script(const struct page_context *context, const char *stem,
                              const json_t *scene, struct error *err)
{
    char path[DOCUMENT_PATH_BYTES];
    if (document_path(path, err, "%s/%s.js", context->out, stem) != 0)
        return -1;
    char *text = json_dumps(scene, JSON_COMPACT | JSON_ENSURE_ASCII | JSON_REAL_PRECISION(15));
    char *script = NULL;
    int length = text ? asprintf(&script, "meshgrade_scene(\"%s\", %s);\n", stem, text) : -1;
    int status = -1;
    if (length >= 0)
        status = document_write(path, script, (size_t)length, err);
    else
        error_set(err, "out of memory for a scene");
    if (length >= 0)
        free(script);
    free(text);
    return status;
}

static void write_view(struct html *page, const struct page_context *context, const char *stem,
                       const json_t *scene)
{
    char path[DOCUMENT_PATH_BYTES];
    struct error err = {""};
    if (write_scene_script(context, stem, scene, &err) != 0 ||
        document_path(path, &err, "%s%s.js", context->up, stem) != 0) {
        page->fault = "a scene could not be written beside its picture";
        return;
    }
    html_open(page, "div");
    html_attribute(page, "class", "view");
    html_path(page, "data-scene", path);
    html_attribute(page, "data-key", stem);
    html_open(page, "button");
    html_attribute(page, "type", "button");
    html_attribute(page, "class", "turn");
    html_flag(page, "hidden");
    html_both(page, (struct phrase){"Turn it in 3D", "Girarlo en 3D"});
    html_close(page, "button");
    html_close(page, "div");
}

void page_scene(struct html *page, const struct page_context *context, const char *stem,
                const json_t *scene, struct phrase message)
{
    char picture[DOCUMENT_PATH_BYTES];
    struct error ignored = {""};
    bool is_chart = strcmp(result_text(scene, "kind"), "chart") == 0;
    html_open(page, "figure");
    if (is_chart)
        chart_draw(page, scene, message);
    else if (document_path(picture, &ignored, "%s.png", stem) == 0 &&
             page_has_file(context, picture))
        page_picture(page, context, stem, message);
    if (!is_chart && context->has_three)
        write_view(page, context, stem, scene);
    if (!is_chart) {
        html_open(page, "figcaption");
        write_legend(page, scene);
        html_close(page, "figcaption");
    }
    html_close(page, "figure");
}

static void write_term(struct html *page, struct phrase term, const char *text)
{
    if (*text == '\0')
        return;
    html_both_leaf(page, "dt", NULL, term);
    html_open(page, "dd");
    html_text(page, text);
    html_close(page, "dd");
}

static void write_facts(struct html *page, const json_t *result, const json_t *one)
{
    html_open(page, "dl");
    struct phrase element = words_in(one, "element");
    if (*element.en) {
        html_both_leaf(page, "dt", NULL, (struct phrase){"where", "dónde"});
        html_both_leaf(page, "dd", NULL, element);
    }
    size_t i;
    json_t *part;
    json_array_foreach(json_object_get(result, "classes"), i, part)
    {
        if (strcmp(result_text(part, "name"), result_text(one, "class")) != 0)
            continue;
        html_both_leaf(page, "dt", NULL, (struct phrase){"class", "clase"});
        html_both_leaf(page, "dd", NULL, words_in(part, "title"));
    }
    char cause[64];
    if (*result_text(one, "cause")) {
        html_both_leaf(page, "dt", NULL, (struct phrase){"cause", "causa"});
        html_both_leaf(page, "dd", NULL, words_cause(one, cause, sizeof cause));
    }
    write_term(page, (struct phrase){"seed", "semilla"}, result_text(one, "seed"));
    html_close(page, "dl");
    if (*result_text(one, "reproduce")) {
        html_both_leaf(page, "p", "again", (struct phrase){"See it again:", "Verlo otra vez:"});
        html_open(page, "pre");
        html_attribute(page, "class", "command");
        html_attribute(page, "tabindex", "0");
        html_text(page, result_text(one, "reproduce"));
        html_close(page, "pre");
    }
}

void page_case(struct html *page, const struct page_context *context, const json_t *result,
               const json_t *one)
{
    char stem[DOCUMENT_PATH_BYTES];
    char path[DOCUMENT_PATH_BYTES];
    struct error err = {""};
    json_t *scene = NULL;
    if (json_is_true(json_object_get(one, "scene")) &&
        document_path(stem, &err, "pictures/%s/%s/%s", result_text(result, "student_folder"),
                      result_text(result, "exercise"), result_text(one, "name")) == 0 &&
        document_path(path, &err, "%s/%s.json", context->out, stem) == 0)
        scene = document_read_json(path, &err);

    html_open(page, "article");
    html_attribute(page, "class", scene ? "case" : "case without-picture");
    html_attribute_format(page, "id", "%s.%s", result_text(result, "exercise"),
                          result_text(one, "name"));
    if (scene)
        page_scene(page, context, stem, scene, words_in(one, "message"));
    html_open(page, "div");
    html_attribute(page, "class", "what");
    html_open(page, "h4");
    html_leaf(page, "code", NULL, result_text(one, "name"));
    html_text(page, " ");
    page_verdict(page, result_text(one, "verdict"));
    html_close(page, "h4");
    html_both_leaf(page, "p", NULL, words_in(one, "message"));
    write_facts(page, result, one);
    html_close(page, "div");
    html_close(page, "article");
    json_decref(scene);
}
