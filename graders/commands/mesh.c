/* meshgrade mesh: what a mesh is, and what is wrong with it. */
#include "graders/commands/common.h"
#include "graders/commands/options.h"

#include "graders/engine/base/files.h"
#include "graders/report/mesh/mesh_report.h"
#include "reference/formats/mesh_file.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

struct mesh_settings {
    bool json, strict, without_crossings;
    const char *picture, *page, *language_text, *tolerance_text;
    enum language language;
    double tolerance;
};

/* Reads a file, or with "-" the standard input. */
static int read_mesh(const struct mesh_settings *settings, struct mesh_report *report,
                     struct error *err)
{
    struct reading *reading = settings->strict ? NULL : &report->reading;
    if (strcmp(report->name, "-") == 0)
        return mesh_file_read_stream(stdin, "standard input", &report->mesh, reading, err);
    return mesh_file_read_told(report->name, &report->mesh, reading, err);
}

/* The pictures and pages that were asked for. */
static int publish(const struct mesh_settings *settings, const struct mesh_report *report,
                   struct error *err)
{
    const char *root = project_root(err);
    if (!root)
        return -1;
    if (settings->picture && mesh_report_picture(report, settings->picture, renderer_path(),
                                                 settings->language, err) != 0)
        return -1;
    if (settings->page && mesh_report_page(report, settings->page, root, renderer_path(), err) != 0)
        return -1;
    if (settings->page)
        fprintf(stderr, "page: %s/index.html\n", settings->page);
    return 0;
}

static int tell(const struct mesh_settings *settings, const struct mesh_report *report,
                json_t *list, struct error *err)
{
    struct terminal_style style = style_for(stdout, settings->language);
    if (list)
        json_array_append_new(list, mesh_report_json(report));
    else
        mesh_report_print(stdout, report, &style);
    return settings->picture || settings->page ? publish(settings, report, err) : 0;
}

/* Looks at one file; returns its exit code. A file that is no mesh is a mistake in what was asked
 * for; want of memory, or a picture that cannot be drawn, is ours. */
static int look_at(const struct mesh_settings *settings, const char *name, json_t *list)
{
    struct mesh_report report = {.name = name};
    struct error err = {""};
    const struct survey_wish wish = {.without_crossings = settings->without_crossings,
                                     .tolerance = settings->tolerance};
    int code;
    if (read_mesh(settings, &report, &err) != 0) {
        fprintf(stderr, "meshgrade: %s\n", err.text);
        if (list)
            json_array_append_new(list, json_pack("{s:s*, s:s*}", "file", name, "error", err.text));
        return EXIT_USAGE;
    }
    if (mesh_report_make(&report, &wish, &err) != 0 || tell(settings, &report, list, &err) != 0)
        code = report_fault(&err);
    else
        code = mesh_report_is_clean(&report) ? EXIT_PASSED : EXIT_NOT_PASSED;
    mesh_report_release(&report);
    return code;
}

static int read_tolerance(struct mesh_settings *settings)
{
    char *end;
    settings->tolerance = strtod(settings->tolerance_text, &end);
    if (*end == '\0' && settings->tolerance > 0 && isfinite(settings->tolerance))
        return 0;
    fprintf(stderr, "meshgrade: --tolerance %s: expected a distance greater than 0\n",
            settings->tolerance_text);
    return -1;
}

static bool settings_are_good(struct mesh_settings *settings, int file_count)
{
    if (file_count < 1) {
        fprintf(stderr, "meshgrade: mesh needs a file: .ply, .obj or .off, or - for the standard "
                        "input\n");
        return false;
    }
    if ((settings->picture || settings->page) && file_count > 1) {
        fprintf(stderr, "meshgrade: --picture and --page show one file, not %d\n", file_count);
        return false;
    }
    if (settings->tolerance_text && read_tolerance(settings) != 0)
        return false;
    return options_language(settings->language_text, language_here(), &settings->language) == 0;
}

static int run(int argc, char **argv)
{
    struct mesh_settings settings = {0};
    const struct option_rule rules[] = {
        {"json", 0, NULL, "as JSON, an array with an object a file", NULL, &settings.json},
        {"picture", 0, "FILE.png", "draw it, with what is wrong marked", &settings.picture, NULL},
        {"page", 0, "DIR", "write DIR/index.html, to turn it in 3D", &settings.page, NULL},
        {"strict", 0, NULL, "refuse a file of which something is left out", NULL, &settings.strict},
        {"no-crossings", 0, NULL, "do not search self-intersections", NULL,
         &settings.without_crossings},
        {"tolerance", 0, "X", "how near a T-vertex is (box diagonal / 10^6)",
         &settings.tolerance_text, NULL},
        {"lang", 0, "en|es", "language (default: by LANG)", &settings.language_text, NULL},
        {0}};
    int first = options_parse(&command_mesh, rules, argc, argv), code = EXIT_PASSED;
    if (first < 0 || !settings_are_good(&settings, argc - first))
        return EXIT_USAGE;
    json_t *list = settings.json ? json_array() : NULL;
    for (int i = first; i < argc; i++) {
        int own = look_at(&settings, argv[i], list);
        code = own > code ? own : code;
        if (!list && i + 1 < argc)
            putchar('\n');
    }
    if (list && print_value(list) != 0)
        code = EXIT_FAULT;
    json_decref(list);
    return code;
}

const struct command command_mesh = {"mesh", "FILE...", "what a mesh is and what is wrong with it",
                                     run};
