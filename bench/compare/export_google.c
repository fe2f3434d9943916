/* The times of bench.json in google/benchmark's JSON schema 1, for its compare.py; see document.h.
 *
 * Found out by reading and trying (1.7.1): a row needs name, run_name, run_type, real_time,
 * cpu_time and time_unit; counters are flat numbers; a row with time 0 spoils the geometric mean of
 * all, so what failed is left out; NaN and Infinity are no JSON. */
#include "bench/compare/document.h"

#include <string.h>

static json_t *context_of(const json_t *document)
{
    json_t *machine = json_object_get(document, "machine"), *caches = json_array();
    size_t i;
    json_t *cache;
    json_array_foreach(json_object_get(machine, "caches"), i, cache)
    {
        json_array_append_new(caches, json_pack("{s:O, s:O, s:O, s:i}", "type",
                                                json_object_get(cache, "type"), "level",
                                                json_object_get(cache, "level"), "size",
                                                json_object_get(cache, "bytes"), "num_sharing", 1));
    }
    return json_pack("{s:O, s:s, s:s, s:O, s:b, s:o, s:[], s:s, s:i, s:O}", "date",
                     json_object_get(document, "date"), "host_name", "", "executable", "meshgrade",
                     "num_cpus", json_object_get(machine, "cores"), "cpu_scaling_enabled", 0,
                     "caches", caches, "load_avg", "library_build_type", "release",
                     "json_schema_version", 1, "library_version",
                     json_object_get(document, "version"));
}

/* "kernels/edges-any/avx2/torus-100k-scrambled" */
static void name_of(const json_t *row, char *name, size_t capacity)
{
    const char *const keys[] = {"what", "subject", "variant", "operation", "mesh"};
    size_t used = 0;
    name[0] = '\0';
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        const char *text = json_string_value(json_object_get(row, keys[i]));
        bool again =
            i == 3 && text && strcmp(text, json_string_value(json_object_get(row, "subject"))) == 0;
        if (text && *text && !again && used < capacity)
            used += (size_t)snprintf(name + used, capacity - used, "%s%s", used ? "/" : "", text);
    }
}

static void add_counters(const json_t *row, json_t *benchmark)
{
    const char *key;
    json_t *value;
    json_object_foreach(json_object_get(row, "counts"), key, value)
    {
        if (json_is_number(value))
            json_object_set(benchmark, key, value);
    }
    json_t *ratio = json_object_get(row, "ratio");
    if (json_is_object(ratio))
        json_object_set(benchmark, "ratio", json_object_get(ratio, "median"));
}

/* One repetition for each block. */
static void add_benchmarks(const json_t *row, int family, json_t *benchmarks)
{
    char name[256];
    json_t *times = json_object_get(row, "block_ns"), *ns;
    size_t i;
    name_of(row, name, sizeof name);
    json_array_foreach(times, i, ns)
    {
        json_t *benchmark =
            json_pack("{s:s, s:i, s:i, s:s, s:s, s:i, s:i, s:O, s:i, s:O, s:O, s:s}", "name", name,
                      "family_index", family, "per_family_instance_index", 0, "run_name", name,
                      "run_type", "iteration", "repetitions", (int)json_array_size(times),
                      "repetition_index", (int)i, "threads", json_object_get(row, "threads"),
                      "iterations", 1, "real_time", ns, "cpu_time", ns, "time_unit", "ns");
        add_counters(row, benchmark);
        json_array_append_new(benchmarks, benchmark);
    }
}

json_t *bench_document_google(const json_t *document)
{
    json_t *benchmarks = json_array();
    size_t i;
    const json_t *row;
    json_array_foreach(json_object_get(document, "rows"), i, row)
    {
        add_benchmarks(row, (int)i, benchmarks);
    }
    return json_pack("{s:o, s:o}", "context", context_of(document), "benchmarks", benchmarks);
}
