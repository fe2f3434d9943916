/* A mesh as a page; see mesh_report.h. */
#include "graders/report/page.h"
#include "graders/report/documents.h"
#include "graders/report/mesh/mesh_report.h"

#include <string.h>
#include <unistd.h>

static void write_facts(struct html *page, const struct mesh_report *report)
{
    struct mesh_fact facts[MESH_REPORT_FACTS];
    int count = mesh_report_facts(report, facts);
    html_open(page, "dl");
    for (int i = 0; i < count; i++) {
        html_both_leaf(page, "dt", NULL, facts[i].name);
        html_both_leaf(page, "dd", NULL, message_phrase(&facts[i].text));
    }
    html_close(page, "dl");
}

static void write_fault(struct html *page, const struct mesh_report *report, enum survey_kind kind)
{
    enum { SHOWN = 5 };
    const struct survey_fault *fault = &report->survey.faults[kind];
    struct message message;
    mesh_report_say_fault(report, kind, &message);
    html_both_leaf(page, "h3", NULL, message_phrase(&message));
    html_open(page, "ul");
    html_attribute(page, "class", "facts");
    for (int32_t i = 0; i < fault->kept_count && i < SHOWN; i++) {
        survey_say(kind, &fault->kept[i], &message);
        html_both_leaf(page, "li", NULL, message_phrase(&message));
    }
    if (fault->count > SHOWN) {
        message_say(&message, "and %lld more", "y %lld más", (long long)fault->count - SHOWN);
        html_both_leaf(page, "li", "quiet", message_phrase(&message));
    }
    html_close(page, "ul");
}

static void write_faults(struct html *page, const struct mesh_report *report)
{
    html_both_leaf(page, "h2", NULL, (struct phrase){"What is wrong", "Qué está mal"});
    if (mesh_report_is_clean(report))
        html_both_leaf(page, "p", NULL,
                       (struct phrase){"Nothing was found.", "No se encontró nada."});
    for (int kind = 0; kind < SURVEY_KINDS; kind++)
        if (report->survey.faults[kind].count > 0)
            write_fault(page, report, (enum survey_kind)kind);
    for (int kind = 0; kind < READING_KINDS; kind++) {
        struct message message;
        if (report->reading.notes[kind].count == 0)
            continue;
        reading_say(&report->reading, (enum reading_kind)kind, &message);
        html_both_leaf(page, "p", NULL, message_phrase(&message));
    }
    if (!report->survey.crossings_were_searched)
        html_both_leaf(page, "p", "quiet",
                       (struct phrase){"Self-intersections were not searched.",
                                       "No se buscaron autointersecciones."});
}

static void write_size(struct html *page, const struct mesh_report *report,
                       const struct representation_size *size, double most)
{
    html_open(page, "tr");
    html_leaf(page, "th", NULL, size->kind->title);
    html_open(page, "td");
    if (size->bytes >= 0)
        html_format(page, "%lld", (long long)size->bytes);
    html_close(page, "td");
    html_open(page, "td");
    if (size->bytes >= 0 && report->mesh.triangle_count > 0)
        html_format(page, "%.1f", (double)size->bytes / report->mesh.triangle_count);
    html_close(page, "td");
    if (size->bytes >= 0) {
        page_bar(page, "own", (double)size->bytes, most);
    } else {
        struct message message;
        struct phrase obstacle = survey_obstacle(size->obstacle);
        message_clear(&message);
        message_en(&message, "cannot hold %s", obstacle.en);
        message_es(&message, "no admite %s", obstacle.es);
        html_both_leaf(page, "td", "quiet", message_phrase(&message));
    }
    html_close(page, "tr");
}

static void write_sizes(struct html *page, const struct mesh_report *report)
{
    double most = 1;
    for (int i = 0; i < report->size_count; i++)
        if ((double)report->sizes[i].bytes > most)
            most = (double)report->sizes[i].bytes;
    html_both_leaf(page, "h2", NULL,
                   (struct phrase){"Bytes in each representation", "Bytes en cada representación"});
    html_open(page, "table");
    html_attribute(page, "class", "measures");
    html_open(page, "thead");
    html_open(page, "tr");
    html_both_leaf(page, "th", NULL, (struct phrase){"representation", "representación"});
    html_leaf(page, "th", NULL, "bytes");
    html_both_leaf(page, "th", NULL, (struct phrase){"per triangle", "por triángulo"});
    html_leaf(page, "th", NULL, "");
    html_close(page, "tr");
    html_close(page, "thead");
    html_open(page, "tbody");
    for (int i = 0; i < report->size_count; i++)
        write_size(page, report, &report->sizes[i], most);
    html_close(page, "tbody");
    html_close(page, "table");
}

static void write_page(struct html *page, const struct page_context *context,
                       const struct mesh_report *report, const json_t *scene)
{
    const char *slash = strrchr(report->name, '/');
    const char *name = slash ? slash + 1 : report->name;
    struct mesh_fact facts[MESH_REPORT_FACTS];
    mesh_report_facts(report, facts);
    page_begin(page, context, name, (struct phrase){"A mesh", "Una malla"}, true);
    html_leaf(page, "h1", NULL, name);
    html_open(page, "article");
    html_attribute(page, "class", "case");
    html_attribute(page, "id", "mesh");
    page_scene(page, context, "mesh", scene, message_phrase(&facts[0].text));
    html_open(page, "div");
    html_attribute(page, "class", "what");
    write_facts(page, report);
    html_close(page, "div");
    html_close(page, "article");
    write_faults(page, report);
    write_sizes(page, report);
    html_close(page, "main");
    html_close(page, "body");
    html_close(page, "html");
}

/* mesh.png and mesh.es.png; a page does without them where there is no renderer. */
static void draw_pictures(const struct mesh_report *report, const char *folder,
                          const char *renderer)
{
    char path[DOCUMENT_PATH_BYTES];
    struct error ignored = {""};
    if (document_path(path, &ignored, "%s/mesh.png", folder) != 0 ||
        mesh_report_picture(report, path, renderer, LANGUAGE_EN, &ignored) != 0 ||
        document_path(path, &ignored, "%s/mesh.es.png", folder) != 0)
        return;
    if (mesh_report_picture(report, path, renderer, LANGUAGE_ES, &ignored) != 0)
        return;
}

int mesh_report_page(const struct mesh_report *report, const char *folder, const char *root,
                     const char *renderer, struct error *err)
{
    char path[DOCUMENT_PATH_BYTES];
    struct page_context context = {.out = folder, .up = ""};
    struct html page;
    if (page_assets(folder, root, &context.has_three, err) != 0 ||
        document_path(path, err, "%s/index.html", folder) != 0)
        return -1;
    draw_pictures(report, folder, renderer);
    json_t *scene = mesh_report_scene(report, err);
    if (!scene || html_start(&page, err) != 0) {
        json_decref(scene);
        return -1;
    }
    write_page(&page, &context, report, scene);
    json_decref(scene);
    int status = html_finish(&page, err);
    if (status == 0)
        status = document_write(path, page.text, page.length, err);
    html_release(&page);
    return status;
}
