/* meshgrade report: pages and pictures of a graded class, made anew. */
#include "graders/commands/common.h"
#include "graders/commands/options.h"
#include "graders/commands/publish.h"
#include "graders/engine/result/store.h"

static int run(int argc, char **argv)
{
    bool json = false;
    const struct option_rule rules[] = {{"json", 0, NULL, "the results as JSON", NULL, &json}, {0}};
    struct error err = {""};
    struct store store;
    int at = options_parse(&command_report, rules, argc, argv);
    if (at < 0 || argc - at != 1) {
        fprintf(stderr, "usage: meshgrade report FOLDER\n");
        return EXIT_USAGE;
    }
    int result = store_open(&store, argv[at], &err);
    if (result == 0)
        result = store_write_files(&store, argv[at], &err);
    store_close(&store);
    int code = result == 0 ? publish(argv[at], true, json, &err) : EXIT_FAULT;
    if (code == EXIT_FAULT && err.text[0])
        report_fault(&err);
    return code;
}

const struct command command_report = {"report", "FOLDER", "pages and pictures of a graded class",
                                       run};
