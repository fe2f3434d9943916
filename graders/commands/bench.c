/* meshgrade bench: compares mesh representations, and the reference kernels with other libraries.
 */
#include "graders/commands/common.h"
#include "graders/commands/options.h"

#include "bench/compare/accesses.h"
#include "bench/compare/claims.h"
#include "bench/compare/document.h"
#include "bench/compare/fingerprint.h"
#include "bench/compare/run.h"
#include "bench/compare/subjects.h"
#include "bench/compare/table.h"
#include "graders/engine/base/files.h"
#include "graders/engine/result/lock.h"
#include "graders/engine/result/score.h"
#include "graders/report/bench/bench_report.h"

#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { QUICK_SECONDS = 40, FULL_MINUTES = 28, THOROUGH_MINUTES = 24 * 60, COPY_SIZES = 4 };

struct settings {
    unsigned what;
    bool quick, thorough, peers, json, csv, counts;
    const char *output, *mesh, *subject, *blocks, *minutes, *page;
    char folder[PATH_MAX], program[PATH_MAX], peers_folder[PATH_MAX], models[PATH_MAX];
};

static volatile sig_atomic_t stop;

static void ask_to_stop(int signal_number)
{
    (void)signal_number;
    stop = 1;
}

/* ---- what is wanted ---- */

static int read_what(struct settings *settings, int argc, char **argv, int first)
{
    for (int i = first; i < argc; i++) {
        unsigned what = bench_what_find(argv[i]);
        if (!what) {
            fprintf(stderr,
                    "meshgrade: bench does not know \"%s\"; choose of representations, kernels, "
                    "paper, readers, claims, all\n",
                    argv[i]);
            return -1;
        }
        settings->what |= what;
    }
    if (!settings->what)
        settings->what = BENCH_ALL;
    return 0;
}

/* Where this program, the peers and the models stand, and where results go. */
static int find_places(struct settings *settings, struct error *err)
{
    const char *root = project_root(err);
    ssize_t length = readlink("/proc/self/exe", settings->program, sizeof settings->program - 1);
    if (!root)
        return -1;
    if (length <= 0)
        return error_set(err, "/proc/self/exe cannot be read: is /proc mounted?");
    settings->program[length] = '\0';
    if (snprintf(settings->peers_folder, PATH_MAX, "%s/build/peers", root) >= PATH_MAX ||
        snprintf(settings->models, PATH_MAX, "%s/exercises/models", root) >= PATH_MAX ||
        (settings->output
             ? snprintf(settings->folder, PATH_MAX, "%s", settings->output)
             : snprintf(settings->folder, PATH_MAX, "%s/build/bench", root)) >= PATH_MAX)
        return error_set(err, "too long a path");
    return folder_make(settings->folder, err);
}

/* Says so when --peers finds none. */
static void look_for_peers(const struct settings *settings, const struct plan *plan)
{
    for (int i = 0; i < plan->job_count; i++)
        for (int k = 0; k < plan->jobs[i].contender_count; k++)
            if (plan->jobs[i].contenders[k].kind == CONTENDER_PEER)
                return;
    if (settings->peers)
        fprintf(stderr, "meshgrade: no other library takes part: build them with make peers\n");
}

/* ---- the run ---- */

static void show_progress(void *context, const struct run_progress *progress)
{
    enum { WIDTH = 28 };
    char bar[WIDTH + 1];
    int filled = progress->planned ? WIDTH * progress->done / progress->planned : WIDTH;
    (void)context;
    for (int i = 0; i < WIDTH; i++)
        bar[i] = i < filled ? '#' : '.';
    bar[WIDTH] = '\0';
    if (progress->doing[0])
        fprintf(stderr, "\r\033[K[%s] %d/%d  %.44s", bar, progress->done, progress->planned,
                progress->doing);
    else
        fprintf(stderr, "\r\033[K");
    fflush(stderr);
}

/* Copies of the sizes that the plan's meshes have, and one size more. */
static int measure_copies(const struct plan *plan, struct copy_bandwidth *copies, int *count,
                          struct error *err)
{
    static const int64_t sizes[COPY_SIZES] = {1 << 20, 16 << 20, 64 << 20, 512 << 20};
    enum { BYTES_PER_TRIANGLE = 24, REPETITIONS = 5 };
    int64_t largest = 0;
    for (int i = 0; i < plan->job_count; i++)
        if (plan->jobs[i].mesh.triangles > largest)
            largest = plan->jobs[i].mesh.triangles;
    *count = 0;
    while (*count < COPY_SIZES &&
           (*count == 0 || sizes[*count - 1] < BYTES_PER_TRIANGLE * largest)) {
        if (copy_bandwidth_measure(sizes[*count], REPETITIONS, &copies[*count], err) != 0)
            return -1;
        ++*count;
    }
    return 0;
}

static void print_document(const struct settings *settings, const json_t *document)
{
    if (settings->json) {
        json_t *google = bench_document_google(document);
        json_dumpf(google, stdout, JSON_INDENT(1) | JSON_REAL_PRECISION(6));
        putchar('\n');
        json_decref(google);
    } else if (settings->csv) {
        bench_document_csv(document, stdout);
    } else {
        table_write(document, style_for(stdout, language_here()).colour, stdout);
    }
}

/* The page of a folder of results; says where it is. */
static int write_report(const char *folder, struct error *err)
{
    char reason[400];
    const char *root = project_root(err);
    if (!root || bench_report(folder, renderer_path(), root, reason, sizeof reason, err) != 0)
        return -1;
    fprintf(stderr, "page: %s/index.html\n", folder);
    if (reason[0])
        fprintf(stderr, "meshgrade: pictures were not drawn: %s\n", reason);
    return 0;
}

/* Writes the files and prints; says where they are. */
static int publish_results(const struct settings *settings, const struct plan *plan,
                           const struct journal *journal, const struct document_facts *facts,
                           struct error *err)
{
    json_t *document = bench_document_make(plan, journal, facts, err);
    if (!document || bench_document_write(document, settings->folder, err) != 0) {
        json_decref(document);
        return -1;
    }
    print_document(settings, document);
    fflush(stdout);
    fprintf(stderr, "results: %s/bench.json, bench.csv, google.json%s\n", settings->folder,
            run_is_complete(plan, journal) ? ""
                                           : "; not all blocks are done: the same command goes on");
    json_decref(document);
    bool is_narrowed =
        settings->mesh || settings->subject; /* too little for a page; --page makes it */
    return is_narrowed ? 0 : write_report(settings->folder, err);
}

/* The claims as JSON; an empty array when they are not asked for. Returns 0, or -1 and *err. */
static int collect_claims(const struct settings *settings, json_t **json, struct error *err)
{
    struct claims claims = {0};
    if (settings->what & BENCH_CLAIMS && claims_collect(&claims, settings->models, err) != 0) {
        claims_release(&claims);
        return -1;
    }
    *json = claims_to_json(&claims);
    claims_release(&claims);
    return *json ? 0 : error_set(err, "out of memory: claims");
}

/* The accesses of queries, which belong to the claims, in the same way. */
static int collect_accesses(const struct settings *settings, json_t **json, struct error *err)
{
    struct access_counts counts = {.rows = NULL};
    if (settings->what & BENCH_CLAIMS && accesses_count(&counts, err) != 0) {
        accesses_release(&counts);
        return -1;
    }
    *json = accesses_to_json(&counts);
    accesses_release(&counts);
    return *json ? 0 : error_set(err, "out of memory: accesses");
}

static int run_and_publish(const struct settings *settings, const struct plan *plan,
                           struct journal *journal, const struct machine *machine,
                           struct error *err)
{
    struct copy_bandwidth copies[COPY_SIZES];
    double minutes = settings->minutes    ? strtod(settings->minutes, NULL)
                     : settings->thorough ? THOROUGH_MINUTES
                                          : FULL_MINUTES;
    struct run_wish wish = {.plan = plan,
                            .folder = settings->folder,
                            .models = settings->models,
                            .seconds = settings->quick && !settings->minutes ? QUICK_SECONDS
                                                                             : 60 * minutes,
                            .counts = settings->counts,
                            .progress = isatty(STDERR_FILENO) ? show_progress : NULL,
                            .stop = &stop};
    int copy_count;
    json_t *claims, *accesses;
    if (measure_copies(plan, copies, &copy_count, err) != 0 || run_plan(&wish, journal, err) != 0 ||
        collect_claims(settings, &claims, err) != 0)
        return -1;
    if (collect_accesses(settings, &accesses, err) != 0) {
        json_decref(claims);
        return -1;
    }
    struct document_facts facts = {.version = meshgrade_version(),
                                   .mode = settings->quick      ? "quick"
                                           : settings->thorough ? "thorough"
                                                                : "full",
                                   .machine = machine,
                                   .copy = copies,
                                   .copy_count = copy_count,
                                   .claims = claims,
                                   .accesses = accesses};
    return publish_results(settings, plan, journal, &facts, err);
}

static int bench(const struct settings *settings, struct error *err)
{
    struct plan plan;
    struct journal journal;
    struct machine machine;
    char fingerprint[FINGERPRINT_BYTES];
    struct plan_wish wish = {.what = settings->what,
                             .quick = settings->quick,
                             .thorough = settings->thorough,
                             .peers = settings->peers,
                             .mesh = settings->mesh,
                             .subject = settings->subject,
                             .blocks = (int)options_number("blocks", settings->blocks, 1, 0),
                             .program = settings->program,
                             .peers_folder = settings->peers_folder};
    machine_describe(&machine);
    if (plan_make(&plan, &wish, err) != 0)
        return -1;
    look_for_peers(settings, &plan);
    fingerprint_write(&plan, settings->program, &machine, fingerprint);
    int result = journal_open(&journal, settings->folder, fingerprint, err);
    if (result == 0) {
        if (journal.was_other)
            fprintf(stderr, "meshgrade: the program or the machine has changed since the last run "
                            "here: measuring anew (the old journal is journal.jsonl.old)\n");
        result = run_and_publish(settings, &plan, &journal, &machine, err);
        journal_close(&journal);
    }
    plan_release(&plan);
    return result;
}

/* meshgrade bench --worker SUBJECT SNAPSHOT: how the runs start themselves; not in the help. */
static int serve(const char *subject, const char *snapshot)
{
    struct error err = {""};
    if (subject_serve(subject, snapshot, stdin, stdout, &err) == 0)
        return EXIT_PASSED;
    printf("refused %s\n", err.text);
    return report_fault(&err);
}

/* What was left out of a file. */
static void tell_reading(const struct bench_mesh *mesh)
{
    for (int kind = 0; mesh->kind == MESH_FILE && kind < READING_KINDS; kind++) {
        struct message message;
        if (mesh->reading.notes[kind].count == 0)
            continue;
        reading_say(&mesh->reading, (enum reading_kind)kind, &message);
        fprintf(stderr, "meshgrade: %s: %s\n", mesh->path, message_text(&message, language_here()));
    }
}

static bool settings_are_good(const struct settings *settings)
{
    struct bench_mesh mesh = {.path = ""};
    struct error err = {""};
    if (settings->mesh && bench_mesh_find(settings->mesh, &mesh, &err) != 0) {
        report_fault(&err);
        return false;
    }
    if (settings->mesh)
        tell_reading(&mesh);
    if (settings->quick && settings->thorough) {
        fprintf(stderr, "meshgrade: bench is either --quick or --thorough\n");
        return false;
    }
    return options_number("blocks", settings->blocks, 1, 1) > 0 &&
           options_number("minutes", settings->minutes, 1, 1) > 0;
}

static int run_bench(int argc, char **argv)
{
    struct settings settings = {0};
    struct error err = {""};
    const struct option_rule rules[] = {
        {"quick", 'q', NULL, "few meshes, under a minute", NULL, &settings.quick},
        {"thorough", 0, NULL, "every mesh, 12 blocks, until done: hours", NULL, &settings.thorough},
        {"peers", 0, NULL, "also other libraries (after make peers)", NULL, &settings.peers},
        {"counts", 0, NULL, "also instructions, misses, allocations", NULL, &settings.counts},
        {"output", 'o', "DIR", "results and journal (build/bench)", &settings.output, NULL},
        {"json", 0, NULL, "print google/benchmark's JSON", NULL, &settings.json},
        {"csv", 0, NULL, "print CSV", NULL, &settings.csv},
        {"mesh", 0, "NAME", "only this mesh: a file, or as torus-100k-scrambled", &settings.mesh,
         NULL},
        {"subject", 0, "TEXT", "only what has TEXT in its name", &settings.subject, NULL},
        {"blocks", 0, "N", "fresh processes of each (6)", &settings.blocks, NULL},
        {"page", 0, "DIR", "only write DIR's page again, measure nothing", &settings.page, NULL},
        {"minutes", 0, "N", "begin nothing after that (28)", &settings.minutes, NULL},
        {0}};
    if (argc == 4 && strcmp(argv[1], "--worker") == 0)
        return serve(argv[2], argv[3]);
    int first = options_parse(&command_bench, rules, argc, argv);
    if (first < 0 || read_what(&settings, argc, argv, first) != 0 || !settings_are_good(&settings))
        return EXIT_USAGE;
    if (settings.page && !folder_holds(settings.page, "bench.json")) {
        fprintf(stderr, "meshgrade: %s holds no bench.json; run meshgrade bench -o %s first\n",
                settings.page, settings.page);
        return EXIT_USAGE;
    }
    if (settings.page)
        return write_report(settings.page, &err) == 0 ? EXIT_PASSED : report_fault(&err);
    struct sigaction action = {.sa_handler = ask_to_stop};
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    struct lock lock = {-1};
    int result = find_places(&settings, &err);
    if (result == 0)
        result = lock_take(&lock, settings.folder, &err); /* two runs would share a journal */
    if (result == 0)
        result = bench(&settings, &err);
    lock_release(&lock);
    return result == 0 ? EXIT_PASSED : report_fault(&err);
}

const struct command command_bench = {
    "bench", "[WHAT...]", "compare representations and kernels, measured on this machine",
    run_bench};
