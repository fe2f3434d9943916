/* Marks and the result file; see score.h.
 *
 * A class gives its points when every one of its cases passed. A check gives its points when it
 * passed. The verdict is the one that takes precedence over all cases and checks; a fault in
 * handling refused allocations speaks only when nothing else is wrong, so that it never hides the
 * mistake that matters more. */
#include "graders/engine/result/score.h"

#include "graders/engine/build/toolset.h"
#include "graders/engine/result/measures.h"
#include "graders/engine/run/cases.h"

#include <limits.h>
#include <math.h>
#include <nettle/sha2.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wchar.h>

#ifndef MESHGRADE_VERSION
#define MESHGRADE_VERSION "0.1.0"
#endif

const char *meshgrade_version(void)
{
    return MESHGRADE_VERSION;
}

/* Bytes of the UTF-8 character that begins here, 0 when none does (a text may have been cut inside
 * one). jansson refuses what is not UTF-8, and would lose the whole result for it. */
static size_t character_bytes(const char *at)
{
    mbstate_t state = {0};
    size_t count = mbrtowc(NULL, at, MB_LEN_MAX, &state);
    return count == (size_t)-1 || count == (size_t)-2 ? 0 : count;
}

/* A JSON string of any bytes: what is not UTF-8 becomes a question mark. */
static json_t *text_json(const char *text)
{
    char *clean = strdup(text);
    for (char *at = clean; at && *at;) {
        size_t count = character_bytes(at);
        if (count == 0)
            *at = '?';
        at += count ? count : 1;
    }
    json_t *json = clean ? json_string(clean) : NULL;
    free(clean);
    return json;
}

static json_t *phrase_json(struct phrase phrase)
{
    return json_pack("{s:o, s:o}", "en", text_json(phrase_text(phrase, LANGUAGE_EN)), "es",
                     text_json(phrase_text(phrase, LANGUAGE_ES)));
}

static json_t *message_json(const struct message *message)
{
    return phrase_json(message_phrase(message));
}

static json_t *points_json(double points)
{
    return json_real(round(points * 100) / 100);
}

/* ----------------------------------------------------------- the submission */

static json_t *source_json(const struct source *source)
{
    struct sha256_ctx hash;
    uint8_t digest[SHA256_DIGEST_SIZE];
    char text[2 * SHA256_DIGEST_SIZE + 1];
    sha256_init(&hash);
    sha256_update(&hash, source->count, (const uint8_t *)source->bytes);
    sha256_digest(&hash, sizeof digest, digest);
    for (size_t i = 0; i < sizeof digest; i++)
        snprintf(text + 2 * i, 3, "%02x", digest[i]);
    return json_pack("{s:s, s:I, s:s}", "name", source->name, "bytes", (json_int_t)source->count,
                     "sha256", text);
}

static json_t *submission_json(const struct trial *trial)
{
    json_t *files = json_array();
    for (int i = 0; i < trial->source_count; i++)
        json_array_append_new(files, source_json(&trial->sources[i]));
    return json_pack("{s:o}", "files", files);
}

static json_t *reason_json(const struct box_reason *reason)
{
    return phrase_json((struct phrase){reason->en, reason->es});
}

static json_t *protections_json(const struct trial *trial)
{
    json_t *active = json_array(), *inactive = json_object();
    for (int layer = 0; layer < BOX_LAYER_COUNT; layer++) {
        const char *name = box_layer_name((enum box_layer)layer);
        if (trial->active_layers >> layer & 1)
            json_array_append_new(active, json_string(name));
        else
            json_object_set_new(inactive, name, reason_json(&trial->layer_reasons[layer]));
    }
    return json_pack("{s:o, s:o}", "active", active, "inactive", inactive);
}

static json_t *not_measured_json(const struct trial *trial)
{
    static const struct phrase by_valgrind = {"counted work and memcheck",
                                              "trabajo contado y memcheck"};
    json_t *list = json_array();
    const struct probes *probes = &trial->yardstick->probes;
    if (!probes->valgrind)
        json_array_append_new(list, json_pack("{s:o, s:o}", "name", phrase_json(by_valgrind),
                                              "reason", phrase_json(probes->no_valgrind)));
    return list;
}

/* `seed` is empty where nothing ran. */
static json_t *engine_of(const char *seed)
{
    const struct toolset *tools = toolset_here();
    return json_pack("{s:s, s:o, s:o, s:o, s:s, s:s}", "version", MESHGRADE_VERSION, "compiler",
                     text_json(tools->compiler), "libc", text_json(tools->libc), "valgrind",
                     text_json(tools->valgrind), "layers", tools->layers, "seed", seed);
}

static json_t *engine_json(const struct trial *trial)
{
    char seed[32];
    snprintf(seed, sizeof seed, "%u", trial->yardstick->inputs.seeds.cases);
    return engine_of(seed);
}

/* ------------------------------------------------------------ cases, classes */

/* Says in the scene what it shows; the renderer writes it into the picture. */
static void describe_scene(const struct trial *trial, size_t index, const char *seed,
                           const char *student)
{
    const struct judge_case *c = &trial->yardstick->inputs.judge->cases[index];
    const struct exercise *exercise = trial->yardstick->inputs.exercise;
    const struct attempt *attempt = &trial->cases[index].attempt;
    struct message title;
    message_set_phrase(&title, message_phrase(&exercise->title));
    message_add(&title, ": %s", ": %s", c->name);
    json_object_set_new(attempt->scene, "title", message_json(&title));
    json_object_set_new(attempt->scene, "subtitle", message_json(&attempt->message));
    json_object_set_new(attempt->scene, "metadata",
                        json_pack("{s:s, s:s, s:s, s:s, s:s}", "exercise", exercise->name, "case",
                                  c->name, "verdict", verdict_name(attempt->verdict), "seed", seed,
                                  "student", student));
}

/* A case with a seed of the class is only made again with the class's number. */
static void write_seed_option(const struct yardstick *yardstick, const struct judge_case *c,
                              char *text, size_t capacity)
{
    size_t used = strlen(text);
    if (yardstick->inputs.seeds.cases != SEED_PUBLISHED && !judge_case_is_public(c) &&
        used < capacity)
        snprintf(text + used, capacity - used, " --seed %u", yardstick->inputs.seeds.cases);
}

static json_t *case_json(struct trial *trial, size_t index, const struct submitter *submitter,
                         json_t *scenes)
{
    const struct judge_case *c = &trial->yardstick->inputs.judge->cases[index];
    const char *exercise = trial->yardstick->inputs.exercise->name;
    struct attempt *attempt = &trial->cases[index].attempt;
    bool rejected = attempt->verdict != VERDICT_PASSED;
    char seed[32], reproduce[256], picture[512];
    snprintf(seed, sizeof seed, "%llu", (unsigned long long)c->seed);
    snprintf(reproduce, sizeof reproduce, "meshgrade check %s FILE --case %s", exercise, c->name);
    write_seed_option(trial->yardstick, c, reproduce, sizeof reproduce);
    json_t *json = json_pack("{s:s, s:s, s:s, s:s, s:o, s:s, s:b, s:s}", "name", c->name, "class",
                             c->class_name, "verdict", verdict_name(attempt->verdict), "cause",
                             attempt->cause, "message", message_json(&attempt->message), "seed",
                             seed, "public", judge_case_is_public(c), "reproduce", reproduce);
    if (rejected) {
        json_object_set_new(json, "cause_name", message_json(&attempt->cause_name));
        json_object_set_new(json, "element", message_json(&attempt->element));
    }
    if (attempt->has_quality)
        json_object_set_new(json, "quality", json_real(attempt->quality));
    if (rejected && attempt->scene) {
        snprintf(picture, sizeof picture, "pictures/%s/%s/%s.png", submitter->student_folder,
                 exercise, c->name);
        json_object_set_new(json, "scene", json_true());
        json_object_set_new(json, "picture", json_string(picture));
        describe_scene(trial, index, seed, submitter->student);
        json_object_set(scenes, c->name, attempt->scene);
    }
    return json;
}

static json_t *class_json(const struct trial *trial, const struct exercise_class *class,
                          double *score)
{
    const struct judge *judge = trial->yardstick->inputs.judge;
    int passed = 0, count = 0;
    for (size_t i = 0; i < judge->case_count; i++) {
        if (!trial->cases[i].run || strcmp(judge->cases[i].class_name, class->name) != 0)
            continue;
        count++;
        passed += trial->cases[i].attempt.verdict == VERDICT_PASSED;
    }
    double points = count > 0 && passed == count ? class->points : 0;
    *score += points;
    return json_pack("{s:s, s:o, s:o, s:o, s:i, s:i}", "name", class->name, "title",
                     message_json(&class->title), "points", points_json(points), "max_points",
                     points_json(class->points), "passed", passed, "cases", count);
}

/* `check` looks at less than `grade`: what it leaves out neither gives nor costs points. */
static bool class_is_in_scope(const struct trial *trial, const struct exercise_class *class)
{
    const struct judge *judge = trial->yardstick->inputs.judge;
    for (size_t i = 0; i < judge->case_count; i++)
        if (strcmp(judge->cases[i].class_name, class->name) == 0 &&
            cases_in_scope(&judge->cases[i], &trial->scope))
            return true;
    return false;
}

static bool check_is_in_scope(const struct trial *trial, enum check_kind check)
{
    bool partial = trial->scope.quick || trial->scope.only_case;
    return trial->yardstick->inputs.exercise->checked[check] && (!partial || check == CHECK_LEAK);
}

static bool check_counts(const struct trial *trial, enum check_kind check)
{
    return trial->yardstick->inputs.exercise->checked[check] &&
           trial->checks[check].verdict == VERDICT_PASSED && cases_basic_class_passed(trial);
}

static json_t *check_json(const struct trial *trial, enum check_kind check, double *score)
{
    const struct exercise *exercise = trial->yardstick->inputs.exercise;
    const struct check_result *result = &trial->checks[check];
    static const struct check_result withheld = {
        VERDICT_NOT_REACHED,
        "basic-class",
        {"basic class", "clase básica"},
        {"No points before the first class of inputs passes.",
         "Sin puntos mientras no pase la primera clase de entradas."}};
    double points = check_counts(trial, check) ? exercise->check_points[check] : 0;
    *score += points;
    if (result->verdict == VERDICT_PASSED && !cases_basic_class_passed(trial))
        result = &withheld;
    json_t *json = json_pack(
        "{s:s, s:o, s:o, s:o, s:s, s:s, s:o}", "name", check_name(check), "title",
        phrase_json(check_title(check)), "points", points_json(points), "max_points",
        points_json(exercise->check_points[check]), "verdict", verdict_name(result->verdict),
        "cause", result->cause, "message", message_json(&result->message));
    if (result->cause[0])
        json_object_set_new(json, "cause_name", message_json(&result->cause_name));
    return json;
}

/* ------------------------------------------------------------------ verdict */

/* The verdict with what explains it, borrowed from the trial. */
struct decision {
    enum verdict verdict;
    struct cause cause;
    struct phrase message;
    const char *case_name; /* NULL: of no case */
};

static void consider(struct decision *decision, enum verdict verdict, struct cause cause,
                     const struct message *message, const char *case_name)
{
    if (verdict < decision->verdict && verdict < VERDICT_PASSED)
        *decision = (struct decision){verdict, cause, message_phrase(message), case_name};
}

static struct cause refusal_cause(const struct refusal *refusal)
{
    return (struct cause){refusal->cause, refusal->cause_name};
}

static struct cause check_cause(const struct check_result *result)
{
    return (struct cause){result->cause, message_phrase(&result->cause_name)};
}

static struct decision decide(const struct trial *trial)
{
    const struct judge *judge = trial->yardstick->inputs.judge;
    struct decision decision = {VERDICT_PASSED, {"", {NULL, NULL}}, {NULL, NULL}, NULL};
    const struct refusal *refusal = &trial->build.refusal;
    if (refusal->refused) {
        consider(&decision, VERDICT_COMPILE_ERROR, refusal_cause(refusal), &refusal->message, NULL);
        return decision;
    }
    for (size_t i = 0; i < judge->case_count; i++) {
        const struct attempt *attempt = &trial->cases[i].attempt;
        if (trial->cases[i].run)
            consider(&decision, attempt->verdict, attempt_cause(attempt), &attempt->message,
                     judge->cases[i].name);
    }
    for (int check = 0; check < CHECK_COUNT; check++) {
        const struct check_result *result = &trial->checks[check];
        if (check_is_in_scope(trial, (enum check_kind)check) && check != CHECK_ALLOCATION_FAILURE)
            consider(&decision, result->verdict, check_cause(result), &result->message, NULL);
    }
    const struct check_result *sweep = &trial->checks[CHECK_ALLOCATION_FAILURE];
    if (decision.verdict == VERDICT_PASSED && check_is_in_scope(trial, CHECK_ALLOCATION_FAILURE))
        consider(&decision, sweep->verdict, check_cause(sweep), &sweep->message, NULL);
    return decision;
}

static json_t *summary_json(const struct decision *decision)
{
    struct message summary;
    if (decision->verdict == VERDICT_PASSED)
        return phrase_json((struct phrase){"Passed.", "Superado."});
    message_set_phrase(&summary, decision->message);
    if (decision->case_name)
        message_add(&summary, " (case %s)", " (caso %s)", decision->case_name);
    return message_json(&summary);
}

/* ------------------------------------------------------------------- result */

static json_t *header_json(const struct exercise *exercise, const struct submitter *submitter,
                           const struct decision *decision)
{
    static const struct message untitled;
    json_t *json = json_pack(
        "{s:s, s:s, s:s, s:s, s:s, s:o, s:s, s:s, s:s, s:o}", "schema", "meshgrade-result-1",
        "student", submitter->student, "student_folder", submitter->student_folder, "exercise",
        exercise ? exercise->name : "unknown", "group", exercise ? exercise->group : "", "title",
        message_json(exercise ? &exercise->title : &untitled), "problem",
        exercise ? exercise->problem : "", "verdict", verdict_name(decision->verdict), "cause",
        decision->cause.slug, "summary", summary_json(decision));
    if (decision->cause.slug[0])
        json_object_set_new(json, "cause_name", phrase_json(decision->cause.name));
    return json;
}

int score_trial(struct trial *trial, const struct submitter *submitter, struct outcome *outcome,
                struct error *err)
{
    const struct exercise *exercise = trial->yardstick->inputs.exercise;
    struct decision decision = decide(trial);
    json_t *classes = json_array(), *checks = json_array(), *cases = json_array();
    json_auto_t *scenes = json_object();
    double score = 0, max_score = 0;
    for (int i = 0; i < exercise->class_count; i++) {
        if (!class_is_in_scope(trial, &exercise->classes[i]))
            continue;
        json_array_append_new(classes, class_json(trial, &exercise->classes[i], &score));
        max_score += exercise->classes[i].points;
    }
    for (int check = 0; check < CHECK_COUNT; check++) {
        if (!check_is_in_scope(trial, (enum check_kind)check))
            continue;
        json_array_append_new(checks, check_json(trial, (enum check_kind)check, &score));
        max_score += exercise->check_points[check];
    }
    for (size_t i = 0; i < trial->yardstick->inputs.judge->case_count; i++)
        if (trial->cases[i].run)
            json_array_append_new(cases, case_json(trial, i, submitter, scenes));
    outcome->result = header_json(exercise, submitter, &decision);
    json_t *rest =
        json_pack("{s:o, s:o, s:o, s:o, s:o, s:o, s:{s:b, s:s, s:o}, s:o, s:o, s:o, s:o, s:o}",
                  "score", decision.verdict == VERDICT_FLAGGED ? json_null() : points_json(score),
                  "max_score", points_json(max_score), "classes", classes, "checks", checks,
                  "cases", cases, "measures", measures_json(trial), "build", "ok",
                  !trial->build.refusal.refused, "cause", trial->build.refusal.cause, "diagnostics",
                  text_json(trial->build.diagnostics), "output", text_json(trial->output),
                  "protections", protections_json(trial), "not_measured", not_measured_json(trial),
                  "submission", submission_json(trial), "engine", engine_json(trial));
    outcome->scenes = json_dumps(scenes, JSON_COMPACT | JSON_REAL_PRECISION(9));
    if (!outcome->scenes || !outcome->result || !rest ||
        json_object_update(outcome->result, rest) != 0)
        error_set(err, "out of memory for the result, or a text that is not UTF-8");
    json_decref(rest);
    return outcome->result && json_object_get(outcome->result, "engine") ? 0 : -1;
}

int score_without_trial(const struct exercise *exercise, const struct submitter *submitter,
                        enum verdict verdict, const struct refusal *why, struct outcome *outcome,
                        struct error *err)
{
    struct decision decision = {verdict, refusal_cause(why), message_phrase(&why->message), NULL};
    json_t *score = verdict == VERDICT_FAULT ? json_null() : json_real(0);
    outcome->scenes = strdup("{}");
    outcome->result = header_json(exercise, submitter, &decision);
    json_t *rest = json_pack(
        "{s:o, s:o, s:[], s:[], s:[], s:{}, s:{s:b, s:s, s:s}, s:s, s:{s:[], s:{}}, s:[], "
        "s:{s:[]}, s:o}",
        "score", score, "max_score", points_json(exercise ? exercise->max_score : 0), "classes",
        "checks", "cases", "measures", "build", "ok", 0, "cause", why->cause, "diagnostics", "",
        "output", "", "protections", "active", "inactive", "not_measured", "submission", "files",
        "engine", engine_of(""));
    if (!outcome->scenes || !outcome->result || !rest ||
        json_object_update(outcome->result, rest) != 0)
        error_set(err, "out of memory for the result, or a text that is not UTF-8");
    json_decref(rest);
    return outcome->result && json_object_get(outcome->result, "engine") ? 0 : -1;
}

void outcome_release(struct outcome *outcome)
{
    json_decref(outcome->result);
    free(outcome->scenes);
    *outcome = (struct outcome){NULL, NULL};
}
