/* The rows of bench.json; see rows.h. */
#include "bench/compare/rows.h"

#include "bench/compare/answers.h"
#include "bench/compare/counts.h"
#include "bench/measure/interval.h"

#include <stdlib.h>
#include <string.h>

/* One job with its blocks. */
struct gathered {
    const struct job *job;
    const struct journal *journal;
    const struct copy_bandwidth *copy;
    int copy_count;
    const json_t *blocks[INTERVAL_VALUES_MAX];
    int block_count;
    const json_t *mesh; /* counts of the mesh: NULL before any block */
};

/* ---- reading the journal ---- */

static const json_t *measure_in(const json_t *block, const char *contender, const char *operation)
{
    const json_t *measures = json_object_get(
        json_object_get(json_object_get(block, "contenders"), contender), "measures");
    size_t i;
    const json_t *measure;
    json_array_foreach(measures, i, measure)
    {
        const char *name = json_string_value(json_object_get(measure, "operation"));
        if (name && strcmp(name, operation) == 0)
            return measure;
    }
    return NULL;
}

static double number(const json_t *object, const char *key)
{
    return json_number_value(json_object_get(object, key));
}

/* A fact of the answer, " name=number ..."; `absent` when it has none of that name. */
static double fact(const json_t *measure, const char *name, double absent)
{
    const char *at = json_string_value(json_object_get(measure, "facts"));
    size_t length = strlen(name);
    while (at && *at) {
        at += strspn(at, " ");
        if (strncmp(at, name, length) == 0 && at[length] == '=')
            return strtod(at + length + 1, NULL);
        at = strchr(at, ' ');
    }
    return absent;
}

static struct worker_answer answer_in(const json_t *measure)
{
    const char *hash = json_string_value(json_object_get(measure, "hash"));
    return (struct worker_answer){.hash = hash ? strtoull(hash, NULL, 16) : 0,
                                  .value = number(measure, "value"),
                                  .scale = number(measure, "scale"),
                                  .tolerance = number(measure, "tolerance")};
}

/* ---- numbers to JSON ---- */

static json_t *interval_json(const struct interval *interval, double divide_by)
{
    if (interval->count == 0 || divide_by <= 0)
        return json_null();
    return json_pack("{s:f, s:f, s:f, s:f}", "median", interval->median / divide_by, "low",
                     interval->low / divide_by, "high", interval->high / divide_by, "least",
                     interval->least / divide_by);
}

/* Times by block under `key`; returns how many blocks have one. */
static int times(const struct gathered *all, const char *contender, const char *operation,
                 const char *key, double *values)
{
    int count = 0;
    for (int i = 0; i < all->block_count; i++) {
        double ns = number(measure_in(all->blocks[i], contender, operation), key);
        if (ns > 0)
            values[count++] = ns;
    }
    return count;
}

/* Ratio to another contender's operation, over the blocks that have both. */
static json_t *ratio_json(const struct gathered *all, const char *contender, const char *operation,
                          const char *to, const char *to_operation, const char *key)
{
    double ratios[INTERVAL_VALUES_MAX];
    int count = 0;
    for (int i = 0; i < all->block_count; i++) {
        double above = number(measure_in(all->blocks[i], contender, operation), key);
        double below = number(measure_in(all->blocks[i], to, to_operation), key);
        if (above > 0 && below > 0)
            ratios[count++] = above / below;
    }
    if (count == 0)
        return json_null();
    struct interval interval = interval_of(ratios, count);
    return json_pack("{s:s, s:f, s:f, s:f, s:f, s:i, s:b}", "to", to, "median", interval.median,
                     "low", interval.low, "high", interval.high, "confidence", interval.confidence,
                     "blocks", interval.count, "too_noisy", interval_too_noisy(&interval));
}

/* ---- what a row is ---- */

struct row {
    const struct gathered *all;
    const struct contender *contender;
    const char *operation;    /* as measured */
    const char *as_operation; /* as shown: a peer's edge table stands beside both of ours */
    const char *to;           /* contender that the ratio is to; NULL: none */
    const json_t *first;      /* its measure in the first block that has one */
};

/* Our fastest variant on one thread that has the operation. */
static const char *fastest_of_ours(const struct gathered *all, const char *operation)
{
    const char *found = NULL;
    for (int i = 0; i < all->job->contender_count; i++) {
        const struct contender *ours = &all->job->contenders[i];
        if (ours->kind == CONTENDER_KERNEL && ours->thread_count == 1 &&
            measure_in(all->blocks[0], ours->name, operation))
            found = ours->name;
    }
    return found;
}

static const char *compared_to(const struct gathered *all, const struct contender *contender,
                               const char *operation)
{
    const struct contender *baseline = &all->job->contenders[all->job->baseline];
    if (contender == baseline)
        return NULL;
    return contender->kind == CONTENDER_PEER && all->job->what == BENCH_KERNELS
               ? fastest_of_ours(all, operation)
               : baseline->name;
}

static void name_row(const struct row *row, json_t *object)
{
    static const char *const kinds[] = {"representation", "kernel", "reader", "peer"};
    const struct contender *contender = row->contender;
    const struct job *job = row->all->job;
    bool is_kernel = contender->kind == CONTENDER_KERNEL;
    char mesh[48];
    bench_mesh_name(&job->mesh, mesh, sizeof mesh);
    json_object_set_new(object, "what", json_string(bench_what_name(job->what)));
    json_object_set_new(object, "kind", json_string(kinds[contender->kind]));
    json_object_set_new(object, "subject",
                        json_string(is_kernel ? row->as_operation : contender->name));
    json_object_set_new(object, "title",
                        json_string(is_kernel ? row->as_operation : contender->title));
    json_object_set_new(object, "variant", json_string(is_kernel ? contender->name : ""));
    json_object_set_new(object, "threads", json_integer(contender->thread_count));
    json_object_set_new(object, "operation", json_string(row->as_operation));
    json_object_set_new(object, "mesh", json_string(mesh));
    json_object_set_new(object, "mesh_kind", json_string(mesh_kind_name(job->mesh.kind)));
    json_object_set_new(object, "order", json_string(mesh_order_name(job->mesh.order)));
    json_object_set(object, "triangles", json_object_get(row->all->mesh, "triangles"));
    json_object_set(object, "vertices", json_object_get(row->all->mesh, "vertices"));
}

static void add_times(const struct row *row, json_t *object)
{
    static const char *const keys[][4] = {{"warm_ns", "ns_per_triangle", "ratio", "ns_per_query"},
                                          {"cold_ns", "cold_ns_per_triangle", "cold_ratio", NULL}};
    const struct gathered *all = row->all;
    double values[INTERVAL_VALUES_MAX], triangles = number(all->mesh, "triangles");
    double queries = fact(row->first, "queries", 0);
    for (int i = 0; i < 2; i++) {
        int count = times(all, row->contender->name, row->operation, keys[i][0], values);
        struct interval interval = interval_of(values, count);
        bool has_ratio = row->to && (queries == 0 || i == 0);
        json_object_set_new(object, keys[i][1],
                            queries > 0 ? json_null() : interval_json(&interval, triangles));
        if (keys[i][3])
            json_object_set_new(object, keys[i][3],
                                queries > 0 ? interval_json(&interval, queries) : json_null());
        json_object_set_new(object, keys[i][2],
                            has_ratio ? ratio_json(all, row->contender->name, row->operation,
                                                   row->to, row->as_operation, keys[i][0])
                                      : json_null());
        if (i > 0)
            continue;
        json_t *all_times = json_array();
        for (int k = 0; k < count; k++)
            json_array_append_new(all_times, json_real(values[k]));
        json_object_set_new(object, "block_ns", all_times);
        json_object_set_new(object, "blocks", json_integer(count));
    }
}

static void add_samples(const struct row *row, json_t *object)
{
    json_int_t samples = 0, dropped = 0;
    int noisy_blocks = 0;
    for (int i = 0; i < row->all->block_count; i++) {
        const json_t *measure =
            measure_in(row->all->blocks[i], row->contender->name, row->operation);
        samples += json_integer_value(json_object_get(measure, "samples"));
        dropped += json_integer_value(json_object_get(measure, "dropped"));
        noisy_blocks += json_is_true(json_object_get(measure, "warm_noisy"));
    }
    json_object_set_new(object, "samples", json_integer(samples));
    json_object_set_new(object, "dropped", json_integer(dropped));
    json_object_set_new(object, "noisy", json_boolean(2 * noisy_blocks > row->all->block_count));
}

static void add_limit(const struct row *row, json_t *object)
{
    double bytes = fact(row->first, "limit_bytes", 0),
           triangles = number(row->all->mesh, "triangles");
    double rate = copy_bandwidth_at(row->all->copy, row->all->copy_count, (int64_t)bytes);
    double ns = number(json_object_get(object, "ns_per_triangle"), "least") * triangles;
    if (bytes <= 0 || rate <= 0 || ns <= 0)
        json_object_set_new(object, "limit", json_null());
    else
        json_object_set_new(object, "limit",
                            json_pack("{s:f, s:f, s:f}", "bytes_per_triangle", bytes / triangles,
                                      "gigabytes_per_second", rate, "fraction", bytes / rate / ns));
}

static void add_facts(const struct row *row, json_t *object)
{
    static const char *const told[] = {
        "vertices_processed", "queries",     "boundary_loops", "strips",
        "strip_vertices",     "records",     "indices",        "bytes",
        "file_bytes",         "cache_misses"};
    json_t *facts = json_object();
    double triangles = number(row->all->mesh, "triangles");
    double bytes = fact(row->first, "bytes", -1), formula = fact(row->first, "formula_bytes", -1);
    for (size_t i = 0; i < sizeof told / sizeof *told; i++) {
        double value = fact(row->first, told[i], -1);
        if (value >= 0)
            json_object_set_new(facts, told[i], json_integer((json_int_t)value));
    }
    json_object_set_new(object, "facts", facts);
    double live = number(
        counts_find(row->all->journal, row->all->job->name, row->contender->name, row->operation),
        "live_bytes");
    if (bytes < 0 || formula < 0)
        json_object_set_new(object, "bytes_per_triangle", json_null());
    else
        json_object_set_new(object, "bytes_per_triangle",
                            json_pack("{s:f, s:f, s:s}", "formula", formula / triangles, "measured",
                                      (live > 0 ? live : bytes) / triangles, "by",
                                      live > 0 ? "heap" : "tables"));
}

/* Whether the first block's answer is that of the contender that it is held against. */
static const char *answer_word(const struct row *row)
{
    if (!row->to)
        return "unchecked";
    const json_t *other = measure_in(row->all->blocks[0], row->to, row->as_operation);
    struct worker_answer mine = answer_in(row->first), theirs = answer_in(other);
    int agree = other ? answers_agree(&mine, &theirs) : -1;
    return agree < 0 ? "unchecked" : agree ? "equal" : "different";
}

static void add_row(const struct row *row, json_t *rows)
{
    json_t *object = json_object();
    const json_t *counts =
        counts_find(row->all->journal, row->all->job->name, row->contender->name, row->operation);
    json_t *error = json_object_get(row->first, "error");
    name_row(row, object);
    add_times(row, object);
    add_samples(row, object);
    add_limit(row, object);
    add_facts(row, object);
    json_object_set_new(object, "counts", counts ? json_deep_copy(counts) : json_null());
    json_object_set_new(object, "answer", json_string(error ? "unchecked" : answer_word(row)));
    json_object_set_new(object, "error", error ? json_incref(error) : json_null());
    json_array_append_new(rows, object);
}

/* The size of a representation as an operation of its own. */
static void add_bytes_row(const json_t *build, json_t *rows)
{
    static const char *const none[] = {
        "ns_per_triangle", "cold_ns_per_triangle", "ratio", "cold_ratio", "counts", "limit"};
    json_t *object = json_deep_copy(build);
    json_object_set_new(object, "operation", json_string("bytes"));
    json_object_set_new(object, "block_ns", json_array());
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        json_object_set_new(object, none[i], json_null());
    json_array_append_new(rows, object);
}

/* ---- all of them ---- */

static void add_refusal(const struct gathered *all, const struct contender *contender,
                        const char *why, json_t *rows)
{
    const char *operation = contender->kind == CONTENDER_REPRESENTATION ? "build" : "start";
    json_t *measure = json_pack("{s:s}", "error", why);
    struct row row = {.all = all,
                      .contender = contender,
                      .operation = operation,
                      .as_operation = operation,
                      .first = measure};
    add_row(&row, rows);
    json_decref(measure);
}

static void add_operation(const struct gathered *all, const struct contender *contender,
                          const json_t *measure, json_t *rows)
{
    const char *operation = json_string_value(json_object_get(measure, "operation"));
    struct row row = {.all = all,
                      .contender = contender,
                      .operation = operation,
                      .as_operation = operation,
                      .to = compared_to(all, contender, operation),
                      .first = measure};
    add_row(&row, rows);
    const json_t *added = json_array_get(rows, json_array_size(rows) - 1);
    if (!json_is_null(json_object_get(added, "bytes_per_triangle")))
        add_bytes_row(added, rows);
    if (contender->kind == CONTENDER_PEER && strcmp(operation, "edges-any") == 0) {
        row.as_operation = "edges-closed"; /* no peer has a function for this case alone */
        row.to = fastest_of_ours(all, row.as_operation);
        if (row.to)
            add_row(&row, rows);
    }
}

static void add_contender_rows(const struct gathered *all, const struct contender *contender,
                               json_t *rows)
{
    const json_t *found =
        json_object_get(json_object_get(all->blocks[0], "contenders"), contender->name);
    const char *refused = json_string_value(json_object_get(found, "refused"));
    size_t i;
    const json_t *measure;
    if (refused && contender->kind != CONTENDER_KERNEL) /* a variant may have nothing for a mesh */
        add_refusal(all, contender, refused, rows);
    json_array_foreach(json_object_get(found, "measures"), i, measure)
    {
        add_operation(all, contender, measure, rows);
    }
}

json_t *rows_of(const struct plan *plan, const struct journal *journal,
                const struct copy_bandwidth *copy, int copy_count)
{
    json_t *rows = json_array();
    for (int i = 0; i < plan->job_count; i++) {
        const struct job *job = &plan->jobs[i];
        struct gathered all = {
            .job = job, .journal = journal, .copy = copy, .copy_count = copy_count};
        for (int k = 0; k < job->blocks && all.block_count < INTERVAL_VALUES_MAX; k++) {
            const json_t *block = journal_find(journal, job->name, k);
            if (block)
                all.blocks[all.block_count++] = block;
        }
        if (all.block_count == 0)
            continue;
        all.mesh = json_object_get(all.blocks[0], "mesh");
        for (int k = 0; k < job->contender_count; k++)
            add_contender_rows(&all, &job->contenders[k], rows);
    }
    return rows;
}

json_t *rows_noise(const json_t *rows)
{
    json_int_t samples = 0, dropped = 0, noisy = 0;
    size_t i;
    const json_t *row;
    json_array_foreach(rows, i, row)
    {
        samples += json_integer_value(json_object_get(row, "samples"));
        dropped += json_integer_value(json_object_get(row, "dropped"));
        noisy += json_is_true(json_object_get(row, "noisy")) ||
                 json_is_true(json_object_get(json_object_get(row, "ratio"), "too_noisy"));
    }
    return json_pack("{s:I, s:I, s:I}", "samples", samples, "dropped", dropped, "noisy_rows",
                     noisy);
}
