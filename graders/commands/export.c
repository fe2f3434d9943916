/* meshgrade export: gradebooks and the formats of other platforms. */
#include "graders/commands/common.h"
#include "graders/commands/options.h"
#include "graders/report/report.h"

#include <string.h>

static int run(int argc, char **argv)
{
    const char *format = NULL, *language = NULL;
    struct export_selection selection = {0};
    const struct option_rule rules[] = {
        {"format", 'f', "FORMAT", "csv, gradescope, junit, vpl or json (needed)", &format, NULL},
        {"student", 0, "NAME", "only this student", &selection.student, NULL},
        {"lang", 0, "en|es", "language of the texts", &language, NULL},
        {0}};
    struct error err = {""};
    int at = options_parse(&command_export, rules, argc, argv);
    if (at < 0 || argc - at != 1 || !format) {
        fprintf(stderr, "usage: meshgrade export [options] FOLDER --format FORMAT\n");
        return EXIT_USAGE;
    }
    if (options_language(language, LANGUAGE_EN, &selection.language) != 0)
        return EXIT_USAGE;
    if (report_export(argv[at], format, &selection, stdout, &err) != 0)
        return report_fault(&err);
    return EXIT_PASSED;
}

const struct command command_export = {"export", "FOLDER --format FORMAT",
                                       "csv, gradescope, junit, vpl, json", run};
