/* What several commands share; see common.h. */
#include "graders/commands/common.h"

#include "graders/box/box.h"
#include "graders/commands/nearest.h"
#include "graders/commands/options.h"
#include "graders/engine/base/files.h"
#include "graders/engine/run/soundness.h"

#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int report_fault(const struct error *err)
{
    fprintf(stderr, "meshgrade: %s\n", err->text);
    return error_is_request(err) ? EXIT_USAGE : EXIT_FAULT;
}

int print_value(const json_t *value)
{
    if (json_dumpf(value, stdout, JSON_INDENT(2) | JSON_REAL_PRECISION(15)) == 0 &&
        putchar('\n') != EOF)
        return 0;
    fprintf(stderr, "meshgrade: the result could not be written: %s\n", strerror(errno));
    return -1;
}

int load_exercises(struct exercise **exercises, int *count)
{
    struct error err = {""};
    const char *root = project_root(&err);
    if (root && soundness_read(root, exercises, count, &err) == 0)
        return 0;
    report_fault(&err);
    return -1;
}

const char **exercise_names(const struct exercise *exercises, int count)
{
    const char **names = calloc((size_t)count + 1, sizeof *names);
    for (int i = 0; names && i < count; i++)
        names[i] = exercises[i].name;
    return names;
}

const struct exercise *need_exercise(const struct exercise *exercises, int count, const char *name)
{
    const struct exercise *exercise = exercise_find(exercises, count, name);
    char near[3 * EXERCISE_NAME + 8] = "";
    const char **names = exercise ? NULL : exercise_names(exercises, count);
    if (exercise)
        return exercise;
    if (names)
        nearest_names(name, names, (size_t)count, near, sizeof near);
    fprintf(stderr, "meshgrade: there is no exercise \"%s\"; %s%s\n", name,
            near[0] ? "nearest: " : "see meshgrade list", near);
    free(names);
    return NULL;
}

bool folder_holds(const char *folder, const char *name)
{
    char path[PATH_MAX];
    return file_path(path, NULL, "%s/%s", folder, name) == 0 &&
           (access(path, F_OK) == 0 || errno == EACCES);
}

int use_layers(const char *without)
{
    struct error err = {""};
    if (!without || box_switch_off(without, &err) == 0)
        return 0;
    report_fault(&err);
    return -1;
}

enum language language_here(void)
{
    const char *lang = getenv("LC_ALL");
    if (!lang || !*lang)
        lang = getenv("LC_MESSAGES");
    if (!lang || !*lang)
        lang = getenv("LANG");
    return lang && strncmp(lang, "es", 2) == 0 ? LANGUAGE_ES : LANGUAGE_EN;
}

struct terminal_style style_for(FILE *stream, enum language language)
{
    const char *none = getenv("NO_COLOR");
    return (struct terminal_style){.colour = isatty(fileno(stream)) && !(none && *none),
                                   .language = language};
}

const char *renderer_path(void)
{
    static char path[PATH_MAX];
    const char *root = project_root(NULL);
    if (!root)
        return NULL;
    snprintf(path, sizeof path, "%s/build/meshgrade-render", root);
    return path;
}
