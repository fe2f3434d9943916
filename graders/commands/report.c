/* meshgrade report: pages and pictures of a graded class, made anew. */
#include "graders/commands/common.h"
#include "graders/commands/options.h"
#include "graders/commands/publish.h"
#include "graders/engine/result/lock.h"
#include "graders/engine/result/store.h"

static int report(const char *out, bool json, struct error *err)
{
    struct lock lock;
    struct store store = {NULL};
    int result = lock_take(&lock, out, err);
    if (result == 0)
        result = store_open(&store, out, err);
    if (result == 0)
        result = store_write_files(&store, out, err);
    store_close(&store);
    int code = result == 0 ? publish(out, true, json, err) : EXIT_FAULT;
    lock_release(&lock);
    return code == EXIT_FAULT && err->text[0] ? report_fault(err) : code;
}

static int run(int argc, char **argv)
{
    bool json = false;
    const struct option_rule rules[] = {{"json", 0, NULL, "the results as JSON", NULL, &json}, {0}};
    struct error err = {""};
    int at = options_parse(&command_report, rules, argc, argv);
    if (at < 0 || argc - at != 1) {
        fprintf(stderr, "usage: meshgrade report FOLDER\n");
        return EXIT_USAGE;
    }
    const char *out = argv[at];
    if (folder_holds(out, "meshgrade.sqlite"))
        return report(out, json, &err);
    fprintf(stderr,
            "meshgrade: %s holds no graded class; run meshgrade grade PATH... -o %s first\n", out,
            out);
    return EXIT_USAGE;
}

const struct command command_report = {"report", "FOLDER", "pages and pictures of a graded class",
                                       run};
