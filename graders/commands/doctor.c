/* meshgrade doctor: every protection and probe tried for real on this machine. */
#include "graders/box/box.h"
#include "graders/commands/common.h"
#include "graders/commands/options.h"
#include "graders/engine/base/files.h"
#include "graders/engine/run/yardstick.h"
#include "graders/report/renderer.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct finding {
    const char *name;
    bool works, needed; /* needed: without it nothing can be graded */
    char reason[400], remedy[200];
};

enum { FINDINGS_MAX = BOX_LAYER_COUNT + 8 };

static void add_layers(struct finding *findings, int *count)
{
    static struct box_probe probes[BOX_LAYER_COUNT];
    box_probe_layers(probes);
    for (int layer = 0; layer < BOX_LAYER_COUNT; layer++) {
        struct finding *finding = &findings[(*count)++];
        *finding = (struct finding){.name = box_layer_name((enum box_layer)layer),
                                    .works = probes[layer].works,
                                    .needed = layer == BOX_SECCOMP};
        snprintf(finding->reason, sizeof finding->reason, "%s", probes[layer].reason);
        snprintf(finding->remedy, sizeof finding->remedy, "%s", probes[layer].remedy);
    }
}

/* Builds, runs and counts the reference of the first exercise: the whole way, once. */
static void add_grading(struct finding *findings, int *count)
{
    struct exercise *exercises = NULL;
    struct yardstick yardstick = {0};
    struct error err = {""};
    int exercise_count = 0;
    struct finding *grading = &findings[(*count)++], *counting = &findings[(*count)++];
    *grading = (struct finding){.name = "compile and run", .needed = true};
    *counting = (struct finding){.name = "counted work (valgrind)"};
    const char *root = project_root(&err);
    if (root && exercises_read(root, &exercises, &exercise_count, &err) == 0) {
        grading->works = yardstick_make(&yardstick, &exercises[0], seeds_of_class(SEED_PUBLISHED),
                                        false, &err) == 0;
        counting->works = grading->works && yardstick.probes.valgrind;
        snprintf(counting->reason, sizeof counting->reason, "%s",
                 phrase_text(yardstick.probes.no_valgrind, LANGUAGE_EN));
        yardstick_release(&yardstick);
    }
    snprintf(grading->reason, sizeof grading->reason, "%.390s", err.text);
    snprintf(grading->remedy, sizeof grading->remedy,
             "make deps installs gcc, libc6-dev, binutils");
    snprintf(counting->remedy, sizeof counting->remedy,
             "apt-get install valgrind; until then growth and work give no marks");
    free(exercises);
}

/* Draws an empty picture with the real renderer. */
static void add_pictures(struct finding *findings, int *count)
{
    struct finding *finding = &findings[(*count)++];
    struct error err = {""};
    struct phrase reason = {"", ""};
    char folder[PATH_MAX] = "", path[PATH_MAX + 16];
    static const char scene[] =
        "{\"kind\": \"chart\", \"curves\": [{\"name\": \"n\", \"x\": [1, 10], "
        "\"y\": [1, 10], \"exponent\": 1}]}";
    static const char job[] = "{\"pictures\": [{\"scene\": \"s.json\", \"out\": \"s.png\", "
                              "\"width\": 320, \"height\": 240}], \"sheets\": []}";
    *finding = (struct finding){.name = "pictures (VTK, OpenGL)"};
    snprintf(finding->remedy, sizeof finding->remedy,
             "make deps installs VTK, OpenImageIO, libegl1 and Mesa; grading works without");
    if (folder_make_work(folder, &err) != 0)
        return;
    snprintf(path, sizeof path, "%s/s.json", folder);
    int written = file_write(path, scene, strlen(scene), &err);
    snprintf(path, sizeof path, "%s/job.json", folder);
    if (written == 0 && file_write(path, job, strlen(job), &err) == 0 && renderer_path()) {
        finding->works =
            renderer_run(renderer_path(), path, renderer_limits(1), &reason) == RENDERER_DREW;
        snprintf(finding->reason, sizeof finding->reason, "%s", reason.en);
    }
    folder_remove_work(folder);
}

static void add_viewer(struct finding *findings, int *count)
{
    struct finding *finding = &findings[(*count)++];
    *finding =
        (struct finding){.name = "interactive views (three.js)",
                         .works = access("/usr/share/javascript/three/three.min.js", R_OK) == 0,
                         .reason = "three.min.js is not installed",
                         .remedy = "apt-get install libjs-three; pages then have pictures only"};
}

static int print_json(const struct finding *findings, int count)
{
    json_auto_t *list = json_array();
    for (int i = 0; i < count; i++)
        json_array_append_new(list,
                              json_pack("{s:s, s:b, s:b, s:s, s:s}", "name", findings[i].name,
                                        "works", findings[i].works, "needed", findings[i].needed,
                                        "reason", findings[i].works ? "" : findings[i].reason,
                                        "remedy", findings[i].works ? "" : findings[i].remedy));
    return print_value(list);
}

static void print_table(const struct finding *findings, int count)
{
    struct terminal_style style = style_for(stdout, language_here());
    const char *good = style.colour ? "\033[32m" : "", *bad = style.colour ? "\033[33m" : "";
    const char *plain = style.colour ? "\033[0m" : "";
    for (int i = 0; i < count; i++) {
        const struct finding *f = &findings[i];
        printf("%s%-8s%s %s\n", f->works ? good : bad, f->works ? "works" : "MISSING", plain,
               f->name);
        if (!f->works)
            printf("         %s%s%s\n", f->reason, f->reason[0] && f->remedy[0] ? ": " : "",
                   f->remedy);
    }
}

static int run(int argc, char **argv)
{
    bool json = false;
    const struct option_rule rules[] = {{"json", 0, NULL, "as JSON", NULL, &json}, {0}};
    static struct finding findings[FINDINGS_MAX];
    int count = 0, code = EXIT_PASSED;
    if (options_parse(&command_doctor, rules, argc, argv) < 0)
        return EXIT_USAGE;
    add_layers(findings, &count);
    add_grading(findings, &count);
    add_pictures(findings, &count);
    add_viewer(findings, &count);
    if (!json)
        print_table(findings, count);
    else if (print_json(findings, count) != 0)
        return EXIT_FAULT;
    for (int i = 0; i < count; i++) {
        if (!findings[i].works && findings[i].needed)
            return EXIT_FAULT;
        if (!findings[i].works)
            code = EXIT_NOT_PASSED;
    }
    return code;
}

const struct command command_doctor = {"doctor", "", "each protection and probe tried for real",
                                       run};
