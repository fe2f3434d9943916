/* A bench run; see run.h. */
#include "bench/compare/run.h"

#include "bench/compare/counts.h"
#include "bench/compare/mesh_files.h"
#include "bench/compare/snapshot.h"
#include "bench/measure/clock.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

enum { ANSWER_SECONDS = 300 };

/* ---- meshes ---- */

void run_mesh_path(const char *folder, const struct bench_mesh *mesh, char *path, int capacity)
{
    char name[48];
    bench_mesh_name(mesh, name, sizeof name);
    snprintf(path, (size_t)capacity, "%s/meshes/%s.mesh", folder, name);
}

static int make_folder(const char *path, struct error *err)
{
    return mkdir(path, 0777) == 0 || errno == EEXIST
               ? 0
               : error_set(err, "%s: %s", path, strerror(errno));
}

/* Makes the snapshot unless a whole one is there. */
static int need_snapshot(const struct run_wish *wish, const struct job *job, const char *path,
                         struct error *err)
{
    struct snapshot snapshot;
    struct mesh mesh;
    if (snapshot_read_counts(path, &snapshot, NULL) == 0)
        return 0;
    if (bench_mesh_make(&job->mesh, wish->models, &mesh, err) != 0)
        return -1;
    int result = snapshot_write(path, &mesh, err);
    mesh_release(&mesh);
    return result;
}

static int need_mesh(const struct run_wish *wish, const struct job *job, const char *path,
                     struct error *err)
{
    if (need_snapshot(wish, job, path, err) != 0)
        return -1;
    return job->what == BENCH_READERS ? mesh_files_write(path, err) : 0;
}

/* ---- one block ---- */

static json_t *measure_to_json(const struct block_measure *measure)
{
    char hash[20];
    const struct worker_answer *answer = &measure->answer;
    snprintf(hash, sizeof hash, "%016llx", (unsigned long long)answer->hash);
    json_t *object = json_pack("{s:s, s:i, s:i}", "operation", measure->operation, "samples",
                               measure->samples, "dropped", measure->dropped);
    if (measure->error[0]) {
        json_object_set_new(object, "error",
                            json_stringn_nocheck(measure->error, strlen(measure->error)));
        return object;
    }
    json_object_set_new(object, "warm_ns", json_real(measure->warm.ns));
    json_object_set_new(object, "warm_noisy", json_boolean(measure->warm.noisy));
    if (measure->cold.ns > 0) {
        json_object_set_new(object, "cold_ns", json_real(measure->cold.ns));
        json_object_set_new(object, "cold_noisy", json_boolean(measure->cold.noisy));
    }
    json_object_set_new(object, "hash", json_string(hash));
    json_object_set_new(object, "value", json_real(answer->value));
    json_object_set_new(object, "scale", json_real(answer->scale));
    json_object_set_new(object, "tolerance", json_real(answer->tolerance));
    json_object_set_new(object, "facts", json_string(answer->facts));
    return object;
}

static json_t *mesh_to_json(const struct job *job, const char *mesh_path)
{
    struct snapshot snapshot;
    char name[48];
    if (snapshot_read_counts(mesh_path, &snapshot, NULL) != 0)
        return json_null();
    bench_mesh_name(&job->mesh, name, sizeof name);
    return json_pack("{s:s, s:s, s:s, s:i, s:i, s:I, s:I, s:I}", "name", name, "kind",
                     mesh_kind_name(job->mesh.kind), "order", mesh_order_name(job->mesh.order),
                     "triangles", (int)snapshot.mesh.triangle_count, "vertices",
                     (int)snapshot.mesh.vertex_count, "edges", (json_int_t)snapshot.edge_count,
                     "boundary_edges", (json_int_t)snapshot.boundary_edge_count, "highest_valence",
                     (json_int_t)snapshot.highest_valence);
}

static json_t *block_to_json(const struct job *job, int number, const struct block_result *results,
                             const char *mesh_path, double seconds)
{
    json_t *entry =
        json_pack("{s:s, s:i, s:f}", "job", job->name, "block", number, "seconds", seconds);
    json_t *contenders = json_object();
    json_object_set_new(entry, "mesh", mesh_to_json(job, mesh_path));
    for (int i = 0; i < job->contender_count; i++) {
        json_t *contender = json_object(), *measures = json_array();
        if (results[i].refused[0])
            json_object_set_new(contender, "refused", json_string(results[i].refused));
        for (int k = 0; k < results[i].measure_count; k++)
            json_array_append_new(measures, measure_to_json(&results[i].measures[k]));
        json_object_set_new(contender, "measures", measures);
        json_object_set_new(contenders, job->contenders[i].name, contender);
    }
    json_object_set_new(entry, "contenders", contenders);
    return entry;
}

static int do_block(const struct run_wish *wish, const struct job *job, int number,
                    struct core_watch *watch, struct journal *journal, struct error *err)
{
    char mesh_path[PATH_MAX];
    const char *argv[BLOCK_PROGRAMS_MAX][6];
    const char *const *programs[BLOCK_PROGRAMS_MAX];
    static struct block_result results[BLOCK_PROGRAMS_MAX]; /* too large for the stack */
    int64_t start = clock_wall_ns();
    run_mesh_path(wish->folder, &job->mesh, mesh_path, sizeof mesh_path);
    if (need_mesh(wish, job, mesh_path, err) != 0)
        return -1;
    for (int i = 0; i < job->contender_count; i++)
        programs[i] = contender_command(&job->contenders[i], mesh_path, argv[i]);
    struct block_plan plan = {.programs = programs,
                              .program_count = job->contender_count,
                              .number = number,
                              .rounds = job->rounds,
                              .cold_rounds = job->cold_rounds,
                              .seconds = ANSWER_SECONDS,
                              .only = job->only};
    if (block_run(&plan, watch, results, err) != 0)
        return -1;
    return journal_add(
        journal,
        block_to_json(job, number, results, mesh_path, (double)(clock_wall_ns() - start) * 1e-9),
        err);
}

/* ---- the run ---- */

static bool is_done(const struct journal *journal, const struct job *job, int block)
{
    return journal_find(journal, job->name, block) != NULL;
}

static double seconds_of(const struct journal *journal, const struct job *job, int block)
{
    return json_real_value(json_object_get(journal_find(journal, job->name, block), "seconds"));
}

/* What the next block will take: what the last one took; the first one, as long for each triangle
 * as the slowest of its kind so far. */
static double expected_seconds(const struct run_wish *wish, const struct journal *journal,
                               const struct job *job, int block)
{
    double most = 0;
    if (block > 0)
        return seconds_of(journal, job, block - 1);
    for (int i = 0; i < wish->plan->job_count; i++) {
        const struct job *other = &wish->plan->jobs[i];
        double rate = seconds_of(journal, other, 0) / (double)other->mesh.triangles;
        if (other->what == job->what && rate > most)
            most = rate;
    }
    return most * (double)job->mesh.triangles;
}

static void tell(const struct run_wish *wish, const struct journal *journal, const struct job *job)
{
    struct run_progress progress = {.doing = job ? job->name : ""};
    for (int i = 0; i < wish->plan->job_count; i++)
        for (int block = 0; block < wish->plan->jobs[i].blocks; block++) {
            progress.planned++;
            progress.done += is_done(journal, &wish->plan->jobs[i], block);
        }
    if (wish->progress)
        wish->progress(wish->context, &progress);
}

static bool is_over(const struct run_wish *wish, int64_t start, double expected)
{
    double elapsed = (double)(clock_wall_ns() - start) * 1e-9;
    return (wish->stop && *wish->stop) || elapsed + expected > wish->seconds;
}

/* A run under way. */
struct going {
    const struct run_wish *wish;
    struct journal *journal;
    struct core_watch watch;
    int64_t start;
};

/* Blocks first ... end - 1 of a job, as far as it has them, lacks them, and there is time. */
static int go_blocks(struct going *going, const struct job *job, int first, int end,
                     struct error *err)
{
    for (int number = first; number < end && number < job->blocks; number++) {
        if (is_done(going->journal, job, number) ||
            is_over(going->wish, going->start,
                    expected_seconds(going->wish, going->journal, job, number)))
            continue;
        tell(going->wish, going->journal, job);
        if (do_block(going->wish, job, number, &going->watch, going->journal, err) != 0)
            return -1;
    }
    return 0;
}

int run_plan(const struct run_wish *wish, struct journal *journal, struct error *err)
{
    char meshes[PATH_MAX];
    struct going going = {.wish = wish, .journal = journal, .start = clock_wall_ns()};
    const struct plan *plan = wish->plan;
    int most_blocks = 0;
    snprintf(meshes, sizeof meshes, "%s/meshes", wish->folder);
    if (make_folder(meshes, err) != 0)
        return -1;
    core_watch_begin(&going.watch);
    for (int i = 0; i < plan->job_count; i++)
        if (plan->jobs[i].blocks > most_blocks)
            most_blocks = plan->jobs[i].blocks;
    for (int first = 0; first < most_blocks; first += plan->blocks_at_once) {
        for (int i = 0; i < plan->job_count; i++)
            if (go_blocks(&going, &plan->jobs[i], first, first + plan->blocks_at_once, err) != 0)
                return -1;
        if (first == 0 && wish->counts && count_plan(wish, journal, err) != 0)
            return -1;
    }
    tell(wish, journal, NULL);
    return 0;
}

bool run_is_complete(const struct plan *plan, const struct journal *journal)
{
    for (int i = 0; i < plan->job_count; i++)
        for (int block = 0; block < plan->jobs[i].blocks; block++)
            if (!is_done(journal, &plan->jobs[i], block))
                return false;
    return true;
}
