/* meshgrade list: the exercises. */
#include "graders/commands/common.h"
#include "graders/commands/options.h"
#include "graders/engine/base/exercise.h"
#include "graders/engine/base/files.h"

#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>

static int print_json(const struct exercise *exercises, int count)
{
    json_auto_t *list = json_array();
    for (int i = 0; i < count; i++) {
        const struct exercise *e = &exercises[i];
        json_array_append_new(list,
                              json_pack("{s:s, s:s, s:s, s:{s:s, s:s}, s:f}", "name", e->name,
                                        "group", e->group, "problem", e->problem, "title", "en",
                                        e->title.en, "es", e->title.es, "max_score", e->max_score));
    }
    return print_value(list);
}

static int run(int argc, char **argv)
{
    bool json = false;
    const char *language_text = NULL;
    enum language language;
    const struct option_rule rules[] = {
        {"json", 0, NULL, "as JSON", NULL, &json},
        {"lang", 0, "en|es", "language of the titles (default: by LANG)", &language_text, NULL},
        {0}};
    static const struct phrase points = {"points", "puntos"};
    struct exercise *exercises;
    int count, code = EXIT_PASSED;
    if (options_parse(&command_list, rules, argc, argv) < 0 ||
        options_language(language_text, language_here(), &language) != 0)
        return EXIT_USAGE;
    if (load_exercises(&exercises, &count) != 0)
        return EXIT_FAULT;
    if (json && print_json(exercises, count) != 0)
        code = EXIT_FAULT;
    for (int i = 0; i < count && !json; i++)
        printf("%-24s %-8s %4.4g %s  %s\n", exercises[i].name, exercises[i].problem,
               exercises[i].max_score, phrase_text(points, language),
               message_text(&exercises[i].title, language));
    free(exercises);
    return code;
}

const struct command command_list = {"list", "", "the exercises, their problems and points", run};
