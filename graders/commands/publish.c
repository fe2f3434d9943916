/* Publishes a graded class; see publish.h. */
#include "graders/commands/publish.h"

#include "graders/commands/common.h"
#include "graders/commands/options.h"
#include "graders/engine/base/files.h"
#include "graders/report/report.h"

#include <jansson.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

static int exit_code(const json_t *results)
{
    int code = EXIT_PASSED;
    size_t index;
    json_t *result;
    json_array_foreach(results, index, result)
    {
        const char *verdict = json_string_value(json_object_get(result, "verdict"));
        if (!verdict || strcmp(verdict, "fault") == 0)
            return EXIT_FAULT;
        if (strcmp(verdict, "passed") != 0)
            code = EXIT_NOT_PASSED;
    }
    return code;
}

static int draw(const char *out, struct error *err)
{
    char reason[400];
    fprintf(stderr, "drawing pictures ...\n");
    if (report_pictures(out, renderer_path(), err) < 0)
        return -1;
    report_pictures_reason(out, reason, sizeof reason);
    if (reason[0])
        fprintf(stderr, "meshgrade: %s\n", reason);
    return 0;
}

int publish(const char *out, bool pictures, bool json, struct error *err)
{
    char page[PATH_MAX + 16], absolute[PATH_MAX];
    const char *root = project_root(err);
    if (!root || (pictures && draw(out, err) != 0) || report_grades(out, err) != 0 ||
        report_pages(out, root, err) != 0)
        return EXIT_FAULT;
    json_auto_t *results = report_results(out, err);
    if (!results)
        return EXIT_FAULT;
    struct terminal_style style = style_for(stdout, language_here());
    if (!json)
        terminal_print_marks(stdout, results, &style);
    else if (print_value(results) != 0)
        return EXIT_FAULT;
    snprintf(page, sizeof page, "%s/index.html", out);
    fprintf(stderr, "class page: %s\n", realpath(page, absolute) ? absolute : page);
    return exit_code(results);
}
