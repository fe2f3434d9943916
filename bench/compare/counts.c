/* Instructions, simulated cache misses and allocations; see counts.h. */
#include "bench/compare/counts.h"

#include "bench/measure/callgrind.h"
#include "bench/measure/process.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { DUMP_BYTES_MAX = 16 << 20, COUNT_SECONDS = 300 };
static const char *const valgrind = "/usr/bin/valgrind";

const char *const *contender_command(const struct contender *contender, const char *mesh_path,
                                     const char **argv)
{
    int count = 0;
    argv[count++] = contender->program;
    if (contender->worker[0]) {
        argv[count++] = "bench";
        argv[count++] = "--worker";
        argv[count++] = contender->worker;
    }
    argv[count++] = mesh_path;
    argv[count] = NULL;
    return argv;
}

/* Whether the process greets; its operations' names then stand in `names`. */
static bool greets(struct process *process, char *names, size_t capacity)
{
    if (process_read(process, COUNT_SECONDS, NULL) != 0 || strncmp(process->line, "ready ", 6) != 0)
        return false;
    snprintf(names, capacity, "%s", process->line + 6);
    return true;
}

static json_t *object_in(json_t *parent, const char *key)
{
    json_t *object = json_object_get(parent, key);
    if (!object) {
        object = json_object();
        json_object_set_new(parent, key, object);
    }
    return object;
}

/* The library to preload stands beside our own program, `ours`. */
static int count_allocations(const struct contender *contender, const char *ours,
                             const char *mesh_path, json_t *counts, struct error *err)
{
    char preload[PATH_MAX + 32], names[PROCESS_LINE_CAPACITY], *rest = NULL;
    const char *argv[6];
    const char *slash = strrchr(ours, '/');
    snprintf(preload, sizeof preload, "LD_PRELOAD=%.*s/bench-allocations.so",
             slash ? (int)(slash - ours) : 0, ours);
    const char *const environment[] = {preload, NULL};
    struct process process;
    if (access(preload + strlen("LD_PRELOAD="), R_OK) != 0)
        return 0;
    if (process_start(&process, contender_command(contender, mesh_path, argv), environment, err) !=
        0)
        return -1;
    bool up = greets(&process, names, sizeof names);
    for (char *name = up ? strtok_r(names, " ", &rest) : NULL; name;
         name = strtok_r(NULL, " ", &rest)) {
        long long allocations, bytes, peak, live;
        if (process_ask(&process, "count", name, COUNT_SECONDS, NULL) != 0)
            break;
        if (sscanf(process.line, "counted %lld %lld %lld %lld", &allocations, &bytes, &peak,
                   &live) != 4 ||
            allocations < 0)
            continue;
        json_t *object = object_in(counts, name);
        json_object_set_new(object, "allocations", json_integer(allocations));
        json_object_set_new(object, "allocated_bytes", json_integer(bytes));
        json_object_set_new(object, "peak_bytes", json_integer(peak));
        json_object_set_new(object, "live_bytes", json_integer(live));
    }
    process_stop(&process, 10);
    return 0;
}

/* Adds what a dump of callgrind says under the operation that is its label. */
static void read_dump(const char *path, json_t *counts)
{
    FILE *file = fopen(path, "re");
    char *text = file ? malloc(DUMP_BYTES_MAX) : NULL;
    size_t bytes = text ? fread(text, 1, DUMP_BYTES_MAX, file) : 0;
    struct callgrind_dump dump;
    if (text && callgrind_parse(text, bytes, &dump, NULL) == 0 && dump.label[0]) {
        json_t *object = object_in(counts, dump.label);
        json_object_set_new(object, "instructions", json_integer(dump.counts.instructions));
        json_object_set_new(object, "l1_misses", json_integer(dump.counts.l1_misses));
        json_object_set_new(object, "ll_misses", json_integer(dump.counts.ll_misses));
    }
    free(text);
    if (file)
        fclose(file);
}

static int count_instructions(const struct contender *contender, const char *mesh_path,
                              const char *folder, json_t *counts, struct error *err)
{
    char out[PATH_MAX], file[PATH_MAX], names[PROCESS_LINE_CAPACITY], *rest = NULL;
    const char *own[6], *argv[20] = {valgrind,
                                     "-q",
                                     "--tool=callgrind",
                                     "--vgdb=no",
                                     "--collect-atstart=no",
                                     "--cache-sim=yes",
                                     "--I1=32768,8,64",
                                     "--D1=32768,8,64",
                                     "--LL=8388608,16,64",
                                     out};
    struct process process;
    snprintf(file, sizeof file, "%s/callgrind.%ld", folder, (long)getpid());
    if (snprintf(out, sizeof out, "--callgrind-out-file=%s", file) >= (int)sizeof out)
        return error_set(err, "%s: too long a name", folder);
    contender_command(contender, mesh_path, own);
    for (int i = 0; i == 0 || own[i - 1]; i++)
        argv[10 + i] = own[i];
    if (process_start(&process, argv, NULL, err) != 0)
        return -1;
    bool up = greets(&process, names, sizeof names);
    int calls = 0;
    for (char *name = up ? strtok_r(names, " ", &rest) : NULL; name;
         name = strtok_r(NULL, " ", &rest)) {
        if (process_ask(&process, "count", name, COUNT_SECONDS, NULL) != 0)
            break;
        calls += strncmp(process.line, "counted ", 8) == 0;
    }
    process_stop(&process, 20);
    for (int i = 1; i <= calls; i++) {
        char dump[PATH_MAX + 16];
        snprintf(dump, sizeof dump, "%s.%d", file, i);
        read_dump(dump, counts);
        unlink(dump);
    }
    unlink(file);
    return 0;
}

static const json_t *find_counts(const struct journal *journal, const char *job,
                                 const char *contender)
{
    size_t i;
    const json_t *entry;
    json_array_foreach(journal->entries, i, entry)
    {
        const char *its_job = json_string_value(json_object_get(entry, "job"));
        const char *its_name = json_string_value(json_object_get(entry, "contender"));
        if (its_job && its_name && strcmp(its_job, job) == 0 && strcmp(its_name, contender) == 0)
            return json_object_get(entry, "counts");
    }
    return NULL;
}

const json_t *counts_find(const struct journal *journal, const char *job, const char *contender,
                          const char *operation)
{
    return json_object_get(find_counts(journal, job, contender), operation);
}

static int count_contender(const struct run_wish *wish, const struct job *job,
                           const struct contender *contender, struct journal *journal,
                           struct error *err)
{
    char mesh_path[PATH_MAX];
    run_mesh_path(wish->folder, &job->mesh, mesh_path, sizeof mesh_path);
    json_t *counts = json_object();
    int result = count_allocations(contender, job->contenders[job->baseline].program, mesh_path,
                                   counts, err);
    if (result == 0 && access(valgrind, X_OK) == 0)
        result = count_instructions(contender, mesh_path, wish->folder, counts, err);
    json_t *entry = json_pack("{s:s, s:i, s:s, s:o}", "job", job->name, "block", -1, "contender",
                              contender->name, "counts", counts);
    if (result == 0)
        return journal_add(journal, entry, err);
    json_decref(entry);
    return -1;
}

int count_plan(const struct run_wish *wish, struct journal *journal, struct error *err)
{
    for (int i = 0; i < wish->plan->job_count; i++) {
        const struct job *job = &wish->plan->jobs[i];
        if (job->mesh.triangles > COUNTED_TRIANGLES_MAX)
            continue;
        for (int k = 0; k < job->contender_count; k++) {
            if (wish->stop && *wish->stop)
                return 0;
            if (!find_counts(journal, job->name, job->contenders[k].name) &&
                count_contender(wish, job, &job->contenders[k], journal, err) != 0)
                return -1;
        }
    }
    return 0;
}
