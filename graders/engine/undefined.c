/* Looks for undefined behaviour: the small cases again under ASan and UBSan, then, when these find
 * nothing, under valgrind's memcheck, which also sees what is read before it is written.
 *
 * That something was found is told by the way the program ends (sanitizers abort) and by memcheck's
 * error count, never by text; the tool's text only explains. */
#include "graders/engine/series.h"
#include "graders/engine/trial.h"

#include <ctype.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

enum { SANITIZED_INPUT_BYTES = 1 << 20, CHECKED_INPUT_BYTES = 1 << 17 };
static const struct call_limits limits = {20000000000LL, 5000000000LL};

/* ------------------------------------------------------------ explanations */

/* Copies printable ASCII up to the end of the line. */
static void copy_line(char *to, size_t capacity, const char *from)
{
    size_t count = 0;
    while (count + 1 < capacity && from[count] && from[count] != '\n') {
        to[count] = isprint((unsigned char)from[count]) ? from[count] : '?';
        count++;
    }
    to[count] = '\0';
}

/* "heap-buffer-overflow answer.c:31 in edge_table_any", or the line of UBSan that says what. */
static void explain_sanitizer(const char *output, char *text, size_t capacity)
{
    const char *summary = strstr(output, "SUMMARY: AddressSanitizer: ");
    const char *undefined = strstr(output, "runtime error: ");
    if (undefined) {
        while (undefined > output && undefined[-1] != '\n')
            undefined--;
        copy_line(text, capacity, undefined);
    } else if (summary) {
        copy_line(text, capacity, summary + strlen("SUMMARY: AddressSanitizer: "));
    } else {
        snprintf(text, capacity, "an invalid access");
    }
}

/* "Invalid read of size 4 at edge_table_any (answer.c:31)". */
static void explain_memcheck(const char *output, char *text, size_t capacity)
{
    char what[100] = "an invalid access", where[100] = "";
    const char *start = strstr(output, "==");
    const char *kind = start ? strstr(start + 2, "== ") : NULL;
    const char *at = kind ? strstr(kind, " at 0x") : NULL;
    if (kind)
        copy_line(what, sizeof what, kind + 3);
    at = at ? strstr(at, ": ") : NULL;
    if (at)
        copy_line(where, sizeof where, at + 2);
    snprintf(text, capacity, "%s%s%s", what, where[0] ? " in " : "", where);
}

static void report(struct trial *trial, size_t index, const char *tool, const char *text)
{
    const char *name = trial->yardstick->judge->cases[index].name;
    check_say(&trial->checks[CHECK_UNDEFINED_BEHAVIOUR], VERDICT_UNDEFINED_BEHAVIOUR, "found",
              "In case %s %s found: %s.", "En el caso %s, %s encontró: %s.", name, tool, text);
    struct attempt *attempt = &trial->cases[index].attempt;
    if (attempt->verdict != VERDICT_CRASH)
        return;
    size_t used = strlen(attempt->message), used_es = strlen(attempt->message_es);
    snprintf(attempt->message + used, sizeof attempt->message - used, " %s says: %s.", tool, text);
    snprintf(attempt->message_es + used_es, sizeof attempt->message_es - used_es, " %s dice: %s.",
             tool, text);
}

/* ------------------------------------------------------------------- calls */

/* Cases worth a second look: small, and neither too long nor forbidden the first time. A program
 * that ends itself tells nothing new. */
static bool is_wanted(const struct trial *trial, size_t index, size_t input_bytes)
{
    enum verdict verdict = trial->cases[index].attempt.verdict;
    const char *cause = trial->cases[index].attempt.cause;
    if (verdict == VERDICT_CRASH && (strcmp(cause, "abort") == 0 || strcmp(cause, "exit") == 0))
        return false;
    return trial->cases[index].run && trial->yardstick->cases[index].bytes <= input_bytes &&
           (verdict == VERDICT_PASSED || verdict == VERDICT_WRONG_ANSWER ||
            verdict == VERDICT_CRASH || verdict == VERDICT_UNDEFINED_BEHAVIOUR);
}

/* Calls the wanted cases from `*next` on until one shows an error or ends the program.
 *
 * found     the case at fault, or -1
 * next      the case to go on with; case_count: all done */
static int run_series(struct trial *trial, enum series_tool tool, size_t input_limit, size_t *next,
                      long *found, struct attempt *attempt, struct error *err)
{
    size_t case_count = trial->yardstick->judge->case_count;
    struct series series;
    struct series_plan plan = {
        .yardstick = trial->yardstick, .build = &trial->build, .tool = tool, .cpu = -1};
    for (size_t i = *next; i < case_count; i++) {
        const struct input *input = &trial->yardstick->cases[i];
        if (is_wanted(trial, i, input_limit) && input->bytes > plan.input_bytes)
            plan.input_bytes = input->bytes;
        if (is_wanted(trial, i, input_limit) && input->answer_bound > plan.answer_bytes)
            plan.answer_bytes = input->answer_bound;
    }
    memset(attempt, 0, sizeof *attempt);
    *found = -1;
    int result = series_start(&series, &plan, err);
    long last = -1;
    for (; result == 0 && *next < case_count && *found < 0 && series.end == CALL_ANSWERED;
         ++*next) {
        if (!is_wanted(trial, *next, input_limit))
            continue;
        last = (long)*next;
        series_call(&series, &trial->yardstick->cases[last], 0, &limits, attempt);
        if (attempt->claims.tool_errors > 0)
            *found = last;
    }
    if (series.started && series_end(&series, attempt, err) != 0)
        result = -1;
    if (tool == SERIES_SANITIZER && attempt->outcome.end == BOX_ENDED_SIGNAL &&
        attempt->outcome.signal == SIGABRT)
        *found = last;
    series_release(&series);
    return result;
}

static int look(struct trial *trial, enum series_tool tool, size_t input_limit, struct error *err)
{
    bool sanitizer = tool == SERIES_SANITIZER;
    long found = -1;
    for (size_t next = 0; next < trial->yardstick->judge->case_count && found < 0;) {
        struct attempt attempt;
        char text[240];
        int result = run_series(trial, tool, input_limit, &next, &found, &attempt, err);
        if (result == 0 && found >= 0) {
            (sanitizer ? explain_sanitizer : explain_memcheck)(attempt.output, text, sizeof text);
            report(trial, (size_t)found, sanitizer ? "the sanitizer" : "valgrind", text);
        }
        attempt_release(&attempt);
        if (result != 0)
            return -1;
    }
    return 0;
}

int trial_check_undefined_behaviour(struct trial *trial, struct error *err)
{
    struct check_result *check = &trial->checks[CHECK_UNDEFINED_BEHAVIOUR];
    check_say(check, VERDICT_PASSED, "", "The sanitizers and valgrind found nothing.%s",
              "Ni los sanitizers ni valgrind encontraron nada.%s", "");
    for (size_t i = 0; i < trial->yardstick->judge->case_count; i++)
        if (trial->cases[i].run && trial->cases[i].attempt.verdict == VERDICT_UNDEFINED_BEHAVIOUR) {
            *check = (struct check_result){.verdict = VERDICT_UNDEFINED_BEHAVIOUR};
            snprintf(check->cause, sizeof check->cause, "%s", trial->cases[i].attempt.cause);
            strcpy(check->message, trial->cases[i].attempt.message);
            strcpy(check->message_es, trial->cases[i].attempt.message_es);
        }
    if (look(trial, SERIES_SANITIZER, SANITIZED_INPUT_BYTES, err) != 0)
        return -1;
    if (check->verdict != VERDICT_PASSED || !trial->yardstick->probes.valgrind)
        return 0;
    return look(trial, SERIES_MEMCHECK, CHECKED_INPUT_BYTES, err);
}
