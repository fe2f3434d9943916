/* Looks for undefined behaviour: the small cases again under ASan and UBSan, then, when these find
 * nothing, under valgrind's memcheck, which also sees what is read before it is written.
 *
 * That something was found is told by the tool's own exit code and by memcheck's error count, never
 * by text; the tool's text only explains. */
#include "graders/engine/run/undefined.h"

#include "graders/engine/run/cases.h"
#include "graders/engine/run/series.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

static const struct cause tool_found = {"found",
                                        {"undefined behaviour", "comportamiento indefinido"}};
static const struct cause never_written = {"never-written",
                                           {"never written", "no se escribió nunca"}};
static const struct cause too_much_for_tool = {
    "too-much-for-tool", {"too much for the tool", "demasiado para la herramienta"}};
static const struct cause behaves_differently = {
    "behaves-differently",
    {"behaves differently under a tool", "se comporta de otro modo con una herramienta"}};

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

/* "use-after-poison, answer.c:31, edge_table_any" of ASan's summary "use-after-poison
 * /work/answer.c:31 in edge_table_any". Only places in the submission are told: "bad-free, free" of
 * "bad-free ../src/libsanitizer/... in __interceptor_free". */
static void explain_summary(const char *summary, char *text, size_t capacity)
{
    static const char submission[] = "/work/", interceptor[] = "__interceptor_";
    char line[200], place[200] = "";
    copy_line(line, sizeof line, summary);
    char *function = strstr(line, " in ");
    if (function) {
        *function = '\0';
        function += strlen(" in ");
        if (strncmp(function, interceptor, strlen(interceptor)) == 0)
            function += strlen(interceptor);
    }
    char *path = strchr(line, ' ');
    if (path) {
        *path++ = '\0';
        if (strncmp(path, submission, strlen(submission)) == 0)
            snprintf(place, sizeof place, ", %s", path + strlen(submission));
    }
    snprintf(text, capacity, "%s%s%s%s", line, place, function ? ", " : "",
             function ? function : "");
}

/* What ASan's summary or UBSan's line says. Returns the name of the one that spoke. */
static const char *explain_sanitizer(const char *output, char *text, size_t capacity)
{
    static const char asan[] = "AddressSanitizer", ubsan[] = "UBSan";
    static const char start[] = "SUMMARY: AddressSanitizer: ";
    const char *summary = strstr(output, start);
    const char *undefined = strstr(output, "runtime error: ");
    if (undefined) {
        while (undefined > output && undefined[-1] != '\n')
            undefined--;
        copy_line(text, capacity, undefined);
        return ubsan;
    }
    if (summary)
        explain_summary(summary + strlen(start), text, capacity);
    else
        snprintf(text, capacity, "invalid access");
    return asan;
}

/* "Invalid read of size 4, edge_table_any (answer.c:31)". */
static const char *explain_memcheck(const char *output, char *text, size_t capacity)
{
    char what[100] = "invalid access", where[100] = "";
    const char *start = strstr(output, "==");
    const char *kind = start ? strstr(start + 2, "== ") : NULL;
    const char *at = kind ? strstr(kind, " at 0x") : NULL;
    if (kind)
        copy_line(what, sizeof what, kind + 3);
    at = at ? strstr(at, ": ") : NULL;
    if (at)
        copy_line(where, sizeof where, at + 2);
    snprintf(text, capacity, "%s%s%s", what, where[0] ? ", " : "", where);
    return "valgrind";
}

/* memcheck saw that a part of the answer was never written, and the runner says which. */
static void report_unset(struct trial *trial, size_t index, const struct control *claims)
{
    const struct judge *judge = trial->yardstick->inputs.judge;
    struct check_result *check = &trial->checks[CHECK_UNDEFINED_BEHAVIOUR];
    struct message place;
    answer_place(judge->answer, claims->unset_table, claims->unset_place - 1, &place);
    check_say(check, VERDICT_UNDEFINED_BEHAVIOUR, &never_written, "In case %s ", "En el caso %s, ",
              judge->cases[index].name);
    message_add_phrase(&check->message, message_phrase(&place));
    message_add(&check->message, " was never written.", " no se escribió nunca.");
}

/* The tool's own words are quoted as they are, in both languages. */
static void report(struct trial *trial, size_t index, const char *tool, const char *text)
{
    const char *name = trial->yardstick->inputs.judge->cases[index].name;
    check_say(&trial->checks[CHECK_UNDEFINED_BEHAVIOUR], VERDICT_UNDEFINED_BEHAVIOUR, &tool_found,
              "In case %s %s found \"%s\".", "En el caso %s, %s encontró \"%s\".", name, tool,
              text);
    struct attempt *attempt = &trial->cases[index].attempt;
    if (attempt->verdict != VERDICT_CRASH)
        return;
    message_add(&attempt->message, " %s says \"%s\".", " %s dice \"%s\".", tool, text);
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
    return trial->cases[index].run && trial->yardstick->inputs.cases[index].weight <= input_bytes &&
           (attempt_is_right(&trial->cases[index].attempt) || verdict == VERDICT_WRONG_ANSWER ||
            verdict == VERDICT_CRASH || verdict == VERDICT_UNDEFINED_BEHAVIOUR);
}

/* How far one tool has looked, and what it came upon. */
struct look {
    enum series_tool tool;
    size_t input_limit; /* larger inputs are left out */
    size_t next;        /* the case to go on with */
    long last;          /* the case called last, -1: none */
    bool found;         /* an error in the case called last */
    bool differs;       /* that case passed by itself, and does otherwise under the tool */
};

static void size_series(const struct trial *trial, const struct look *look,
                        struct series_plan *plan)
{
    for (size_t i = look->next; i < trial->yardstick->inputs.judge->case_count; i++) {
        const struct input *input = &trial->yardstick->inputs.cases[i];
        if (!is_wanted(trial, i, look->input_limit))
            continue;
        if (input->bytes > plan->input_bytes)
            plan->input_bytes = input->bytes;
        if (input->answer_bound > plan->answer_bytes)
            plan->answer_bytes = input->answer_bound;
    }
}

/* Calls one case. What was right by itself must be right here too: a program that knows the tool
 * and then keeps still would else seem faultless. */
static int call_case(const struct trial *trial, struct series *series, struct look *look,
                     struct attempt *attempt, struct error *err)
{
    const struct input *input = &trial->yardstick->inputs.cases[look->last];
    memset(attempt, 0, sizeof *attempt);
    attempt->uncounted = true;
    series_call(series, input, 0, &limits, attempt);
    look->found = attempt->claims.tool_errors > 0;
    if (series->end != CALL_ANSWERED || look->found ||
        !attempt_is_right(&trial->cases[look->last].attempt))
        return 0;
    if (attempt_judge(&trial->yardstick->inputs, input, &series->session, attempt, err) != 0)
        return -1;
    look->differs =
        attempt->verdict != VERDICT_PASSED &&
        !(look->tool == SERIES_MEMCHECK && trial->yardstick->inputs.judge->answers_reals);
    return 0;
}

/* Calls the wanted cases in one process, until one shows an error, does otherwise than by itself,
 * or ends the program. */
static int run_series(struct trial *trial, struct look *look, struct attempt *attempt,
                      struct error *err)
{
    size_t case_count = trial->yardstick->inputs.judge->case_count;
    struct series series;
    struct series_plan plan = {
        .inputs = &trial->yardstick->inputs, .build = &trial->build, .tool = look->tool, .cpu = -1};
    size_series(trial, look, &plan);
    memset(attempt, 0, sizeof *attempt);
    int result = series_start(&series, &plan, err);
    for (; result == 0 && look->next < case_count && !look->found && !look->differs &&
           series.end == CALL_ANSWERED;
         look->next++) {
        if (!is_wanted(trial, look->next, look->input_limit))
            continue;
        attempt_release(attempt);
        look->last = (long)look->next;
        result = call_case(trial, &series, look, attempt, err);
    }
    bool died = series.end != CALL_ANSWERED;
    if (series.started && series_end(&series, attempt, err) != 0)
        result = -1;
    if (attempt->outcome.end == BOX_ENDED_EXIT && attempt->outcome.exit_code == SERIES_FOUND)
        look->found = look->last >= 0;
    else if (died && attempt_is_right(&trial->cases[look->last].attempt))
        look->differs = true;
    series_release(&series);
    return result;
}

/* Tools cost time and memory themselves: a program that runs out of either under them has not been
 * looked at, which gives no points, and is told how to get them. */
static void report_exhaustion(struct trial *trial, const char *name, const char *tool,
                              bool out_of_time)
{
    struct check_result *check = &trial->checks[CHECK_UNDEFINED_BEHAVIOUR];
    if (out_of_time)
        check_say(check, VERDICT_NOT_MEASURED, &too_much_for_tool,
                  "In case %s your function did not end within %lld s of CPU time under %s, which "
                  "slows programs down, so undefined behaviour could not be checked, and the "
                  "check gives no points. A function that does less work here can be checked.",
                  "En el caso %s tu función no terminó en %lld s de CPU con %s, que ralentiza los "
                  "programas, así que no se pudo comprobar si hay comportamiento indefinido y la "
                  "comprobación no da puntos. Una función que trabaje menos en este caso se podrá "
                  "comprobar.",
                  name, (long long)(limits.cpu_ns / 1000000000), tool);
    else
        check_say(check, VERDICT_NOT_MEASURED, &too_much_for_tool,
                  "In case %s your function ran out of memory under %s, which needs memory of its "
                  "own, so undefined behaviour could not be checked, and the check gives no "
                  "points. A function that uses less memory here can be checked.",
                  "En el caso %s tu función agotó la memoria con %s, que necesita memoria propia, "
                  "así que no se pudo comprobar si hay comportamiento indefinido y la comprobación "
                  "no da puntos. Una función que use menos memoria en este caso se podrá "
                  "comprobar.",
                  name, tool);
}

static void say_difference(struct check_result *check, const char *name, const char *tool,
                           struct phrase end)
{
    check_say(check, VERDICT_FLAGGED, &behaves_differently,
              "Case %s passes on its own but ends differently under %s (",
              "El caso %s es correcto, pero con %s acaba de otro modo (", name, tool);
    message_add_phrase(&check->message, end);
    message_add(&check->message, "): a person must look at it.", "): debe mirarlo una persona.");
}

/* Any other difference is for a person to look at, unless a case tells the mistake already. */
static void report_difference(struct trial *trial, const struct look *look, const char *tool,
                              const struct attempt *attempt)
{
    const char *name = trial->yardstick->inputs.judge->cases[look->last].name;
    struct check_result *check = &trial->checks[CHECK_UNDEFINED_BEHAVIOUR];
    if (attempt->verdict == VERDICT_CPU_TIME || attempt->verdict == VERDICT_OUT_OF_MEMORY)
        report_exhaustion(trial, name, tool, attempt->verdict == VERDICT_CPU_TIME);
    else if (cases_any_failed(trial))
        check_say(check, VERDICT_NOT_MEASURED, &behaves_differently,
                  "Case %s passes on its own but fails under %s: fix the rejected cases first.",
                  "El caso %s es correcto, pero con %s falla: corrige antes los casos rechazados.",
                  name, tool);
    else
        say_difference(check, name, tool, verdict_words(attempt->verdict));
}

static int look_with(struct trial *trial, enum series_tool tool, size_t input_limit,
                     struct error *err)
{
    bool sanitizer = tool == SERIES_SANITIZER;
    const char *tool_name = sanitizer ? "AddressSanitizer" : "valgrind";
    struct look look = {.tool = tool, .input_limit = input_limit, .last = -1};
    while (look.next < trial->yardstick->inputs.judge->case_count && !look.found && !look.differs) {
        struct attempt attempt;
        char text[240];
        int result = run_series(trial, &look, &attempt, err);
        if (result == 0 && look.found && attempt.claims.unset_place > 0) {
            report_unset(trial, (size_t)look.last, &attempt.claims);
        } else if (result == 0 && look.found) {
            const char *speaker = (sanitizer ? explain_sanitizer
                                             : explain_memcheck)(attempt.output, text, sizeof text);
            report(trial, (size_t)look.last, speaker, text);
        } else if (result == 0 && look.differs) {
            report_difference(trial, &look, tool_name, &attempt);
        }
        attempt_release(&attempt);
        if (result != 0)
            return -1;
    }
    return 0;
}

int undefined_check(struct trial *trial, struct error *err)
{
    struct check_result *check = &trial->checks[CHECK_UNDEFINED_BEHAVIOUR];
    check_say(check, VERDICT_PASSED, NULL, "AddressSanitizer, UBSan and valgrind found nothing.",
              "AddressSanitizer, UBSan y valgrind no encontraron nada.");
    for (size_t i = 0; i < trial->yardstick->inputs.judge->case_count; i++)
        if (trial->cases[i].run && trial->cases[i].attempt.verdict == VERDICT_UNDEFINED_BEHAVIOUR) {
            const struct attempt *attempt = &trial->cases[i].attempt;
            *check = (struct check_result){.verdict = VERDICT_UNDEFINED_BEHAVIOUR,
                                           .cause_name = attempt->cause_name,
                                           .message = attempt->message};
            memcpy(check->cause, attempt->cause, sizeof check->cause);
        }
    if (look_with(trial, SERIES_SANITIZER, SANITIZED_INPUT_BYTES, err) != 0)
        return -1;
    if (check->verdict != VERDICT_PASSED || !trial->yardstick->probes.valgrind)
        return 0;
    return look_with(trial, SERIES_MEMCHECK, CHECKED_INPUT_BYTES, err);
}
