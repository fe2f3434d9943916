/* What the pages share; see page.h. */
#include "graders/report/page.h"

#include "graders/box/box.h"
#include "graders/report/documents.h"
#include "reference/base/plural.h"

#include <string.h>
#include <unistd.h>

/* Scripts and styles come from files only: nothing inline runs, whatever a page may hold. */
static const char content_policy[] =
    "default-src 'none'; script-src 'self' file:; style-src 'self' file:; img-src 'self' file:; "
    "base-uri 'none'; form-action 'none'";

static void head_script(struct html *page, const struct page_context *context, const char *name)
{
    char path[128];
    snprintf(path, sizeof path, "%sassets/%s", context->up, name);
    html_open(page, "script");
    html_path(page, "src", path);
    html_flag(page, "defer");
    html_close(page, "script");
}

static void head_meta(struct html *page, const char *key, const char *name, const char *content)
{
    html_open(page, "meta");
    html_attribute(page, key, name);
    html_attribute(page, "content", content);
    html_close(page, "meta");
}

static void write_head(struct html *page, const struct page_context *context, const char *title,
                       bool has_views)
{
    char style[128];
    snprintf(style, sizeof style, "%sassets/page.css", context->up);
    html_open(page, "head");
    html_open(page, "meta");
    html_attribute(page, "charset", "utf-8");
    html_close(page, "meta");
    head_meta(page, "http-equiv", "Content-Security-Policy", content_policy);
    head_meta(page, "name", "viewport", "width=device-width, initial-scale=1");
    head_meta(page, "name", "referrer", "no-referrer");
    html_leaf(page, "title", NULL, title);
    html_open(page, "link");
    html_attribute(page, "rel", "stylesheet");
    html_path(page, "href", style);
    html_close(page, "link");
    head_script(page, context, "page.js");
    if (has_views)
        head_script(page, context, "viewer.js");
    html_close(page, "head");
}

/* Two radio buttons; the style sheet shows the language that is chosen, with or without scripts. */
static void write_language_switch(struct html *page)
{
    static const char *const codes[] = {"en", "es"};
    static const char *const names[] = {"English", "Español"};
    html_open(page, "div");
    html_attribute(page, "class", "languages");
    html_attribute(page, "role", "radiogroup");
    html_attribute(page, "aria-label", "Language / Idioma");
    for (int i = 0; i < 2; i++) {
        html_open(page, "input");
        html_attribute(page, "type", "radio");
        html_attribute(page, "name", "language");
        html_attribute_format(page, "id", "language-%s", codes[i]);
        html_attribute(page, "value", codes[i]);
        if (i == 0)
            html_flag(page, "checked");
        html_close(page, "input");
        html_open(page, "label");
        html_attribute_format(page, "for", "language-%s", codes[i]);
        html_text(page, names[i]);
        html_close(page, "label");
    }
    html_close(page, "div");
}

void page_begin(struct html *page, const struct page_context *context, const char *title,
                struct phrase course, bool has_views)
{
    html_open(page, "html");
    html_attribute(page, "lang", "en");
    write_head(page, context, title, has_views);
    html_open(page, "body");
    html_open(page, "a");
    html_attribute(page, "class", "skip");
    html_path(page, "href", "#main");
    html_both(page, (struct phrase){"Skip to the content", "Ir al contenido"});
    html_close(page, "a");
    html_open(page, "header");
    html_attribute(page, "class", "top");
    html_open(page, "div");
    html_attribute(page, "class", "course");
    html_both(page, course);
    html_close(page, "div");
    write_language_switch(page);
    html_close(page, "header");
    html_open(page, "main");
    html_attribute(page, "id", "main");
}

void page_end(struct html *page, const struct gradebook *book)
{
    const json_t *engine = json_object_get(json_array_get(book->all, 0), "engine");
    html_close(page, "main");
    html_open(page, "footer");
    html_format(page, "meshgrade %s · %s", result_text(engine, "version"),
                result_text(engine, "compiler"));
    if (*result_text(engine, "seed")) {
        struct message seed;
        message_say(&seed, " · seed %s", " · semilla %s", result_text(engine, "seed"));
        html_both(page, message_phrase(&seed));
    }
    html_close(page, "footer");
    html_close(page, "body");
    html_close(page, "html");
}

void page_symbol(struct html *page, enum standing standing)
{
    html_open(page, "span");
    html_attribute_format(page, "class", "symbol %s", words_of_standing(standing).en);
    html_open(page, "span");
    html_attribute(page, "aria-hidden", "true");
    html_text(page, words_symbol(standing));
    html_close(page, "span");
    html_both_leaf(page, "span", "unseen", words_of_standing(standing));
    html_close(page, "span");
}

void page_score(struct html *page, const json_t *result)
{
    enum standing standing = result_standing(result);
    char score[32];
    char max_score[32];
    words_of_points(result_number(result, "score"), score, sizeof score);
    words_of_points(result_number(result, "max_score"), max_score, sizeof max_score);
    html_open(page, "span");
    html_attribute_format(page, "class", "score %s", words_of_standing(standing).en);
    page_symbol(page, standing);
    html_text(page, " ");
    if (standing == STANDING_UNSCORED) {
        html_both(page, (struct phrase){"not scored", "sin nota"});
    } else {
        html_leaf(page, "b", NULL, score);
        html_format(page, " / %s", max_score);
    }
    html_close(page, "span");
}

void page_verdict(struct html *page, const char *verdict)
{
    html_open(page, "span");
    html_attribute_format(page, "class", "verdict %s",
                          words_of_standing(words_standing(verdict)).en);
    html_both(page, words_verdict(verdict));
    html_close(page, "span");
}

bool page_has_file(const struct page_context *context, const char *path)
{
    char full[DOCUMENT_PATH_BYTES];
    struct error ignored = {""};
    return document_path(full, &ignored, "%s/%s", context->out, path) == 0 &&
           access(full, R_OK) == 0;
}

static void write_picture(struct html *page, const struct page_context *context, const char *path,
                          const char *language, struct phrase alt)
{
    char from_page[DOCUMENT_PATH_BYTES];
    struct error ignored = {""};
    if (document_path(from_page, &ignored, "%s%s", context->up, path) != 0)
        return;
    html_open(page, "a");
    html_attribute(page, "class", "picture");
    if (language)
        html_attribute(page, "lang", language);
    html_path(page, "href", from_page);
    html_open(page, "img");
    html_path(page, "src", from_page);
    html_both_attribute(page, "alt", alt);
    html_attribute(page, "loading", "lazy");
    html_close(page, "img");
    html_close(page, "a");
}

void page_picture(struct html *page, const struct page_context *context, const char *stem,
                  struct phrase alt)
{
    char en[DOCUMENT_PATH_BYTES], es[DOCUMENT_PATH_BYTES];
    struct error ignored = {""};
    if (document_path(en, &ignored, "%s.png", stem) != 0 ||
        document_path(es, &ignored, "%s.es.png", stem) != 0)
        return;
    bool both = page_has_file(context, es);
    write_picture(page, context, en, both ? "en" : NULL, alt);
    if (both)
        write_picture(page, context, es, "es", alt);
}

void page_pictures_note(struct html *page, const struct page_context *context)
{
    struct phrase reason = words_in(context->pictures_status, "reason");
    if (*reason.en == '\0')
        return;
    html_open(page, "p");
    html_attribute(page, "class", "note");
    long long undrawn = json_integer_value(json_object_get(context->pictures_status, "undrawn"));
    struct message text = {"", ""};
    message_en(&text, "%lld picture%s of this class %s missing: ", undrawn, plural_ending(undrawn),
               undrawn == 1 ? "is" : "are");
    message_es(&text,
               undrawn == 1 ? "Falta %lld imagen de esta clase: "
                            : "Faltan %lld imágenes de esta clase: ",
               undrawn);
    html_both(page, (struct phrase){text.en, text.es});
    html_both(page, reason);
    html_close(page, "p");
}

/* ---------------------------------------------------------------- protections */

/* Counts in how many results each text stands: `counts` maps its English words to {es, count}. */
static void count(json_t *counts, struct phrase text)
{
    json_t *entry = json_object_get(counts, text.en);
    if (!entry) {
        entry = json_pack("{s:s, s:i}", "es", text.es, "count", 0);
        json_object_set_new(counts, text.en, entry);
    }
    json_int_t before = json_integer_value(json_object_get(entry, "count"));
    json_object_set_new(entry, "count", json_integer(before + 1));
}

/* "name: reason" */
static void count_reason(json_t *counts, struct phrase name, struct phrase reason)
{
    struct message text;
    message_clear(&text);
    message_en(&text, "%s: %s", name.en, reason.en);
    message_es(&text, "%s: %s", name.es, reason.es);
    count(counts, message_phrase(&text));
}

/* A layer that this version does not know stands by its name. */
static struct phrase layer_title(const char *name)
{
    for (int layer = 0; layer < BOX_LAYER_COUNT; layer++)
        if (strcmp(box_layer_name((enum box_layer)layer), name) == 0)
            return box_layer_title((enum box_layer)layer);
    return (struct phrase){name, name};
}

static void count_of_result(const json_t *result, json_t *active, json_t *inactive, json_t *missing)
{
    const json_t *protections = json_object_get(result, "protections");
    size_t i;
    json_t *value;
    json_array_foreach(json_object_get(protections, "active"), i, value)
    {
        count(active, layer_title(json_string_value(value)));
    }
    const char *layer;
    json_t *reasons = json_object_get(protections, "inactive");
    json_object_foreach(reasons, layer, value)
    {
        count_reason(inactive, layer_title(layer), words_in(reasons, layer));
    }
    json_array_foreach(json_object_get(result, "not_measured"), i, value)
    {
        count_reason(missing, words_in(value, "name"), words_in(value, "reason"));
    }
}

static void write_count_list(struct html *page, json_t *counts, size_t total)
{
    if (json_object_size(counts) == 0)
        return;
    html_open(page, "ul");
    html_attribute(page, "class", "facts");
    const char *en;
    json_t *entry;
    json_object_foreach(counts, en, entry)
    {
        long long number = json_integer_value(json_object_get(entry, "count"));
        html_open(page, "li");
        html_both(page, (struct phrase){en, result_text(entry, "es")});
        if ((size_t)number < total) {
            struct message share;
            message_say(&share, " (%lld of %zu results)", " (%lld de %zu resultados)", number,
                        total);
            html_both(page, message_phrase(&share));
        }
        html_close(page, "li");
    }
    html_close(page, "ul");
}

static void write_counts(struct html *page, struct phrase title, json_t *counts, size_t total,
                         struct phrase none)
{
    html_both_leaf(page, "h3", NULL, title);
    if (json_object_size(counts) == 0)
        html_both_leaf(page, "p", "quiet", none);
    write_count_list(page, counts, total);
}

/* ---------------------------------------------------------------- not measured */

/* A check that gave no points because its measure was not taken. A missing valgrind is told once,
 * with the probes. */
static bool is_unmeasured(const json_t *check)
{
    return strcmp(result_text(check, "verdict"), "not-measured") == 0 &&
           strcmp(result_text(check, "cause"), "no-valgrind") != 0;
}

static void write_unmeasured(struct html *page, const json_t *result, const json_t *check)
{
    html_open(page, "li");
    html_open(page, "bdi");
    html_json(page, json_object_get(result, "student"));
    html_close(page, "bdi");
    html_format(page, ", %s: ", result_text(result, "problem"));
    html_both(page, words_in(check, "title"));
    html_text(page, ". ");
    html_both(page, words_in(check, "message"));
    html_close(page, "li");
}

static size_t write_unmeasured_of(struct html *page, const json_t *result)
{
    size_t found = 0;
    size_t i;
    json_t *check;
    json_array_foreach(json_object_get(result, "checks"), i, check)
    {
        if (!is_unmeasured(check))
            continue;
        write_unmeasured(page, result, check);
        found++;
    }
    return found;
}

static void write_not_run(struct html *page, size_t case_count, size_t answer_count)
{
    char en[160];
    char es[160];
    snprintf(en, sizeof en,
             "Not run: %zu case%s of %zu answer%s, because earlier ones did not end in time.",
             case_count, plural_ending((long long)case_count), answer_count,
             plural_ending((long long)answer_count));
    snprintf(es, sizeof es,
             "Sin ejecutar: %zu caso%s de %zu respuesta%s, porque otros no terminaron a tiempo.",
             case_count, plural_ending((long long)case_count), answer_count,
             plural_ending((long long)answer_count));
    html_both_leaf(page, "li", NULL, (struct phrase){en, es});
}

/* What was not measured although its probe was there: checks that a tool could not finish, cases
 * that were left out. */
static void write_left_out(struct html *page, json_t *const *results, size_t result_count,
                           bool probes_are_missing)
{
    size_t unmeasured = 0, case_count = 0, answer_count = 0;
    html_open(page, "ul");
    html_attribute(page, "class", "facts");
    for (size_t i = 0; i < result_count; i++) {
        size_t not_run = result_not_run(results[i], NULL).count;
        unmeasured += write_unmeasured_of(page, results[i]);
        case_count += not_run;
        answer_count += not_run > 0;
    }
    if (case_count > 0)
        write_not_run(page, case_count, answer_count);
    if (unmeasured + case_count == 0 && !probes_are_missing)
        html_both_leaf(page, "li", "quiet",
                       (struct phrase){"Every tool was there, and finished what it was to measure.",
                                       "Todas las herramientas estaban y terminaron sus medidas."});
    html_close(page, "ul");
}

void page_protections(struct html *page, json_t *const *results, size_t result_count)
{
    json_t *active = json_object();
    json_t *inactive = json_object();
    json_t *missing = json_object();
    size_t total = 0;
    for (size_t i = 0; i < result_count; i++) {
        if (!results[i])
            continue;
        count_of_result(results[i], active, inactive, missing);
        total++;
    }
    html_open(page, "div");
    html_attribute(page, "class", "columns");
    html_open(page, "div");
    write_counts(page, (struct phrase){"Protections active", "Protecciones activas"}, active, total,
                 (struct phrase){"None.", "Ninguna."});
    html_close(page, "div");
    html_open(page, "div");
    write_counts(page, (struct phrase){"Not active here", "No activas aquí"}, inactive, total,
                 (struct phrase){"All were active.", "Todas estaban activas."});
    html_close(page, "div");
    html_open(page, "div");
    html_both_leaf(page, "h3", NULL, (struct phrase){"Not measured", "No medido"});
    write_count_list(page, missing, total);
    write_left_out(page, results, result_count, json_object_size(missing) > 0);
    html_close(page, "div");
    html_close(page, "div");
    json_decref(active);
    json_decref(inactive);
    json_decref(missing);
}

struct phrase page_course(const struct gradebook *book)
{
    size_t i;
    json_t *result;
    json_array_foreach(book->all, i, result)
    {
        struct phrase course = words_in(result, "course");
        if (*course.en)
            return course;
    }
    return (struct phrase){"Triangle meshes", "Mallas de triángulos"};
}
