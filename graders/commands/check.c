/* meshgrade check: a student's own check of one answer. */
#include "graders/commands/common.h"
#include "graders/commands/options.h"
#include "graders/engine/base/files.h"
#include "graders/engine/classroom.h"
#include "graders/engine/run/cases.h"
#include "graders/judges/table.h"
#include "reference/base/plural.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <unistd.h>

struct request {
    bool quick, json, all, times;
    const char *only_case, *language_text, *without, *seed_text;
    enum language language;
    uint32_t seed;
};

static int exit_code_of(const json_t *result)
{
    const char *verdict = json_string_value(json_object_get(result, "verdict"));
    if (strcmp(verdict, verdict_name(VERDICT_FAULT)) == 0)
        return EXIT_FAULT;
    return strcmp(verdict, verdict_name(VERDICT_PASSED)) == 0 ? EXIT_PASSED : EXIT_NOT_PASSED;
}

static bool has_case(const char *exercise, const char *name)
{
    const struct judge *judge = judge_find(exercise);
    for (size_t i = 0; judge && i < judge->case_count; i++)
        if (strcmp(judge->cases[i].name, name) == 0)
            return true;
    return false;
}

/* The text to repeat a case names the student's own files. */
static void name_files(json_t *result, char **files, int count, uint32_t seed)
{
    size_t index;
    json_t *entry;
    json_array_foreach(json_object_get(result, "cases"), index, entry)
    {
        char text[1024];
        size_t used = (size_t)snprintf(text, sizeof text, "meshgrade check %s",
                                       json_string_value(json_object_get(result, "exercise")));
        for (int i = 0; i < count && used < sizeof text; i++)
            used += (size_t)snprintf(text + used, sizeof text - used, " %s", files[i]);
        if (used < sizeof text)
            used += (size_t)snprintf(text + used, sizeof text - used, " --case %s",
                                     json_string_value(json_object_get(entry, "name")));
        if (used < sizeof text && seed != SEED_PUBLISHED &&
            !json_is_true(json_object_get(entry, "public")))
            snprintf(text + used, sizeof text - used, " --seed %u", seed);
        json_t *named = json_string(text);
        if (named)
            json_object_set_new(entry, "reproduce", named);
    }
}

static void print_times(const int64_t stage_cpu_ns[STAGE_COUNT])
{
    static const char *const names[STAGE_COUNT] = {
        "build",  "cases",          "undefined behaviour", "allocation failures",
        "memory", "growth and work"};
    for (int stage = 0; stage < STAGE_COUNT; stage++)
        fprintf(stderr, "  %-22s %6.2f s of CPU\n", names[stage],
                (double)stage_cpu_ns[stage] / 1e9);
}

/* Inputs and the reference's runs, which a class makes once: so that the times of the steps are the
 * submission's own. */
static int make_cases(struct yardstick *yardstick, const struct trial_scope *scope,
                      struct error *err)
{
    const struct input *input;
    for (size_t i = 0; i < yardstick->inputs.judge->case_count; i++)
        if (cases_in_scope(&yardstick->inputs.judge->cases[i], scope) &&
            yardstick_case(yardstick, i, &input, err) != 0)
            return -1;
    return 0;
}

static int check(const struct exercise *exercise, const struct upload *upload,
                 const struct request *request, struct outcome *outcome, struct error *err)
{
    int64_t stage_cpu_ns[STAGE_COUNT] = {0};
    struct trial_scope scope = {.stage_cpu_ns = stage_cpu_ns,
                                .public_only = !request->all,
                                .quick = request->quick,
                                .only_case = request->only_case};
    struct submitter submitter = {upload->student, upload->student_folder};
    struct yardstick yardstick;
    if (upload->refusal.refused)
        return score_without_trial(exercise, &submitter, VERDICT_COMPILE_ERROR, &upload->refusal,
                                   outcome, err);
    bool uncounted = request->quick || request->only_case;
    struct seeds seeds = seeds_of_class(request->seed);
    if (request->seed == SEED_PUBLISHED && getrandom(&seeds.sizes, sizeof seeds.sizes, 0) < 0)
        return error_set(err, "no random number for the sizes: %s", strerror(errno));
    int result = yardstick_make(&yardstick, exercise, seeds, uncounted, err);
    if (result == 0 && request->times)
        result = make_cases(&yardstick, &scope, err);
    if (result == 0)
        result = grade_submission(&yardstick, upload, &scope, outcome, err);
    if (result == 0 && request->times)
        print_times(stage_cpu_ns);
    yardstick_release(&yardstick);
    return result;
}

/* What grading looks at and this check did not. */
static void print_left_out(const struct request *request, const json_t *result)
{
    const struct judge *judge = judge_find(json_string_value(json_object_get(result, "exercise")));
    size_t hidden = 0;
    for (size_t i = 0; judge && i < judge->case_count; i++)
        hidden += !judge_case_is_public(&judge->cases[i]);
    if (request->all || request->only_case || hidden == 0)
        return;
    struct message left_out;
    message_say(&left_out, "Grading has %zu further case%s, not public",
                "Al corregir hay además %zu caso%s sin publicar", hidden,
                plural_ending((long long)hidden));
    if (request->quick)
        message_add(&left_out, ", and more checks", ", y más comprobaciones");
    printf("\n%s.\n", message_text(&left_out, request->language));
}

static int show(const struct request *request, json_t *result)
{
    struct terminal_style style = style_for(stdout, request->language);
    if (request->json)
        return print_value(result) != 0 ? EXIT_FAULT : exit_code_of(result);
    terminal_print_result(stdout, result, &style);
    print_left_out(request, result);
    return exit_code_of(result);
}

static int run_files(const struct exercise *exercise, char **files, int count,
                     const struct request *request)
{
    struct upload upload = {0};
    struct outcome outcome = {0};
    struct error err = {""};
    int code;
    bool talk = isatty(STDERR_FILENO) && !request->json;
    if (talk)
        fprintf(stderr, "checking %s ...\r", exercise->name);
    if (upload_read_files((const char *const *)files, count, exercise->name, &upload, &err) == 0 &&
        !upload.student_folder)
        upload.student_folder = strdup("student");
    if (err.text[0] || !upload.student_folder ||
        check(exercise, &upload, request, &outcome, &err) != 0) {
        code = report_fault(&err);
    } else {
        name_files(outcome.result, files, count, request->seed);
        code = show(request, outcome.result);
    }
    outcome_release(&outcome);
    upload_release(&upload);
    return code;
}

static int run(int argc, char **argv)
{
    struct request request = {0};
    const struct option_rule rules[] = {
        {"quick", 'q', NULL, "a few cases, nothing counted: an answer in about a second", NULL,
         &request.quick},
        {"all", 0, NULL, "also the cases that are not public", NULL, &request.all},
        {"case", 0, "NAME", "only this case", &request.only_case, NULL},
        {"seed", 0, "N", "the cases that are not public as a class of this seed had them",
         &request.seed_text, NULL},
        {"lang", 0, "en|es", "language of the report (default: by LANG)", &request.language_text,
         NULL},
        {"json", 0, NULL, "the result as JSON", NULL, &request.json},
        {"without", 0, "LAYERS", "leave protections out, to test the others (see doctor)",
         &request.without, NULL},
        {"times", 0, NULL, "the CPU time of each step, to stderr", NULL, &request.times},
        {0}};
    struct exercise *exercises = NULL;
    int count, code = EXIT_USAGE;
    int at = options_parse(&command_check, rules, argc, argv);
    if (at < 0 || argc - at < 2) {
        fprintf(stderr, "usage: meshgrade check [options] EXERCISE FILE...\n");
        return EXIT_USAGE;
    }
    if (use_layers(request.without) != 0 ||
        options_seed(request.seed_text, SEED_PUBLISHED, &request.seed) != 0 ||
        options_language(request.language_text, language_here(), &request.language) != 0)
        return EXIT_USAGE;
    if (load_exercises(&exercises, &count) != 0)
        return EXIT_FAULT;
    const struct exercise *exercise = need_exercise(exercises, count, argv[at]);
    if (exercise && request.only_case && !has_case(exercise->name, request.only_case))
        fprintf(stderr, "meshgrade: %s has no case \"%s\"\n", exercise->name, request.only_case);
    else if (exercise)
        code = run_files(exercise, argv + at + 1, argc - at - 1, &request);
    free(exercises);
    return code;
}

const struct command command_check = {"check", "EXERCISE FILE...", "check your own answer", run};
