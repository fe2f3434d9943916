/* Any bytes as a stored result, read back for reports: refused with a reason, or printed in every
 * format without a crash and without a control character of its own. */
#include "graders/report/check.h"
#include "graders/report/export.h"
#include "graders/report/terminal.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

/* All that a terminal could take for a command. */
static void check_inert(const char *text, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if ((unsigned char)text[i] < ' ' && text[i] != '\n' && text[i] != '\r')
            abort();
}

static void print_result(const json_t *result)
{
    const struct terminal_style styles[] = {{false, false}, {false, true}};
    for (int i = 0; i < 2; i++) {
        char *text = NULL;
        size_t count = 0;
        FILE *to = open_memstream(&text, &count);
        if (!to)
            return;
        terminal_print_result(to, result, &styles[i]);
        fclose(to);
        check_inert(text, count);
        free(text);
    }
}

static void export_result(json_t *result)
{
    static int (*const formats[])(const struct export_job *, struct error *) = {
        export_csv, export_gradescope, export_junit, export_vpl, export_json};
    struct gradebook book;
    struct error err = {""};
    json_auto_t *all = json_pack("[O]", result);
    if (!all || gradebook_from(all, &book, &err) != 0)
        return;
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        char *text = NULL;
        size_t count = 0;
        FILE *to = open_memstream(&text, &count);
        const struct export_job job = {&book, true, i % 2 == 0, to};
        if (!to || formats[i](&job, &err) != 0 || fclose(to) != 0)
            abort();
        check_inert(text, count);
        free(text);
    }
    gradebook_release(&book);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count)
{
    struct error err = {""};
    json_auto_t *result = json_loadb((const char *)bytes, count, JSON_REJECT_DUPLICATES, NULL);
    if (!result)
        return 0;
    if (result_check(result, &err) != 0) {
        if (!err.text[0])
            abort();
        return 0;
    }
    print_result(result);
    export_result(result);
    return 0;
}
