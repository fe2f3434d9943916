/* bench.json; see document.h. */
#include "bench/compare/document.h"

#include "bench/compare/goals.h"
#include "bench/compare/rows.h"
#include "reference/kernels/cpu.h"

#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static json_t *caches_json(const struct machine *machine)
{
    json_t *caches = json_array();
    for (int i = 0; i < machine->cache_count; i++)
        json_array_append_new(caches,
                              json_pack("{s:i, s:s, s:I}", "level", machine->caches[i].level,
                                        "type", machine->caches[i].type, "bytes",
                                        (json_int_t)machine->caches[i].bytes));
    return caches;
}

static json_t *machine_json(const struct document_facts *facts)
{
    const struct machine *machine = facts->machine;
    json_t *copies = json_array();
    for (int i = 0; i < facts->copy_count; i++)
        json_array_append_new(copies,
                              json_pack("{s:I, s:s, s:f}", "bytes",
                                        (json_int_t)facts->copy[i].working_set_bytes, "method",
                                        facts->copy[i].method, "gigabytes_per_second",
                                        facts->copy[i].gigabytes_per_second));
    return json_pack("{s:s, s:s, s:s, s:i, s:b, s:I, s:s, s:s, s:s, s:s, s:o, s:o}", "cpu",
                     machine->cpu, "vectors", cpu_vectors_name(cpu_vectors()), "processor_vectors",
                     cpu_vectors_name(cpu_processor_vectors()), "cores", machine->core_count,
                     "hypervisor", machine->hypervisor, "ram_bytes", (json_int_t)machine->ram_bytes,
                     "kernel", machine->kernel, "compiler", machine->compiler, "flags",
                     machine->flags, "huge_pages", machine->huge_pages, "caches",
                     caches_json(machine), "copy", copies);
}

/* The meshes of the journal's blocks, each once. */
static json_t *meshes_json(const struct plan *plan, const struct journal *journal)
{
    json_t *meshes = json_array(), *seen = json_object();
    for (int i = 0; i < plan->job_count; i++)
        for (int block = 0; block < plan->jobs[i].blocks; block++) {
            json_t *mesh =
                json_object_get(journal_find(journal, plan->jobs[i].name, block), "mesh");
            const char *name = json_string_value(json_object_get(mesh, "name"));
            if (!name || json_object_get(seen, name))
                continue;
            json_object_set_new(seen, name, json_true());
            json_array_append(meshes, mesh);
        }
    json_decref(seen);
    return meshes;
}

static bool is_complete(const struct plan *plan, const struct journal *journal)
{
    for (int i = 0; i < plan->job_count; i++)
        for (int block = 0; block < plan->jobs[i].blocks; block++)
            if (!journal_find(journal, plan->jobs[i].name, block))
                return false;
    return true;
}

json_t *bench_document_make(const struct plan *plan, const struct journal *journal,
                            const struct document_facts *facts, struct error *err)
{
    char date[40];
    time_t now = time(NULL);
    struct tm parts;
    strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%S%z", localtime_r(&now, &parts));
    json_t *rows = rows_of(plan, journal, facts->copy, facts->copy_count);
    json_t *claims = facts->claims ? facts->claims : json_array();
    json_t *accesses = facts->accesses ? facts->accesses : json_array();
    json_t *document =
        json_pack("{s:s, s:s, s:s, s:s, s:b, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "schema",
                  "meshgrade-bench-1", "version", facts->version, "date", date, "mode", facts->mode,
                  "complete", is_complete(plan, journal), "machine", machine_json(facts), "noise",
                  rows_noise(rows), "meshes", meshes_json(plan, journal), "goals", goals_of(rows),
                  "rows", rows, "claims", claims, "accesses", accesses);
    if (!document)
        error_set(err, "out of memory: the results");
    return document;
}

/* ---- files ---- */

/* Opens PATH.partial to be renamed when whole. */
static FILE *begin_file(const char *folder, const char *name, char *path, char *partial,
                        struct error *err)
{
    if (snprintf(path, PATH_MAX, "%s/%s", folder, name) >= PATH_MAX - 10) {
        error_set(err, "%s: too long a name", folder);
        return NULL;
    }
    snprintf(partial, PATH_MAX, "%.*s.partial", PATH_MAX - 10, path);
    FILE *file = fopen(partial, "we");
    if (!file)
        error_set(err, "%s: %s", partial, strerror(errno));
    return file;
}

static int end_file(FILE *file, const char *path, const char *partial, bool good, struct error *err)
{
    if (fclose(file) == 0 && good && rename(partial, path) == 0)
        return 0;
    unlink(partial);
    return error_set(err, "%s cannot be written: %s", path, strerror(errno));
}

static int write_json(const json_t *value, const char *folder, const char *name, struct error *err)
{
    char path[PATH_MAX], partial[PATH_MAX];
    FILE *file = begin_file(folder, name, path, partial, err);
    if (!file)
        return -1;
    bool good = json_dumpf(value, file, JSON_INDENT(1) | JSON_REAL_PRECISION(6)) == 0;
    fputc('\n', file);
    return end_file(file, path, partial, good, err);
}

static int write_csv(const json_t *document, void (*write)(const json_t *document, FILE *to),
                     const char *folder, const char *name, struct error *err)
{
    char path[PATH_MAX], partial[PATH_MAX];
    FILE *file = begin_file(folder, name, path, partial, err);
    if (!file)
        return -1;
    write(document, file);
    return end_file(file, path, partial, !ferror(file), err);
}

int bench_document_write(const json_t *document, const char *folder, struct error *err)
{
    json_t *google = bench_document_google(document);
    int result = write_json(document, folder, "bench.json", err);
    if (result == 0)
        result = write_json(google, folder, "google.json", err);
    json_decref(google);
    if (result == 0)
        result = write_csv(document, bench_document_csv, folder, "bench.csv", err);
    if (result == 0 && json_array_size(json_object_get(document, "accesses")) > 0)
        result = write_csv(document, bench_accesses_csv, folder, "accesses.csv", err);
    return result;
}
