/* bench.json as tables to read; see table.h. */
#include "bench/compare/table.h"

#include "bench/compare/table_parts.h"

#include <string.h>

enum { NUMBER = TABLE_NUMBER, NAME_WIDTH = 27 };

/* ---- the machine ---- */

static void write_machine(const struct table *table, const json_t *document)
{
    const json_t *machine = json_object_get(document, "machine"), *item;
    size_t i;
    fprintf(table->to, "%s, %d core%s%s, %.0f GiB, %s, %s\n", table_text(machine, "cpu"),
            (int)table_number(machine, "cores"), table_number(machine, "cores") > 1 ? "s" : "",
            json_is_true(json_object_get(machine, "hypervisor")) ? " of a virtual machine" : "",
            table_number(machine, "ram_bytes") / (1 << 30), table_text(machine, "kernel"),
            table_text(machine, "compiler"));
    fputs("caches", table->to);
    json_array_foreach(json_object_get(machine, "caches"), i, item)
    {
        double kib = table_number(item, "bytes") / 1024;
        if (strcmp(table_text(item, "type"), "Instruction") != 0)
            fprintf(table->to, "%s L%d %.0f %s", i ? "," : "", (int)table_number(item, "level"),
                    kib < 1024 ? kib : kib / 1024, kib < 1024 ? "KiB" : "MiB");
    }
    if (strcmp(table_text(machine, "vectors"), table_text(machine, "processor_vectors")) != 0)
        fprintf(table->to, "; vectors: %s, by MESHGRADE_CPU; the processor has %s",
                table_text(machine, "vectors"), table_text(machine, "processor_vectors"));
    else if (*table_text(machine, "vectors"))
        fprintf(table->to, "; vectors: %s", table_text(machine, "vectors"));
    fputs("\ncopies", table->to);
    json_array_foreach(json_object_get(machine, "copy"), i, item)
    {
        fprintf(table->to, "%s %.0f MiB at %.0f GB/s", i ? "," : "",
                table_number(item, "bytes") / (1 << 20),
                table_number(item, "gigabytes_per_second"));
    }
    fputs(" (the faster of memcpy and stores past the caches)\n", table->to);
}

static void write_title(const struct table *table, const json_t *document, const json_t *row)
{
    char triangles[NUMBER], vertices[NUMBER];
    const char *what = table_text(row, "what");
    size_t i;
    const json_t *mesh;
    table_grouped(triangles, (long long)table_number(row, "triangles"));
    table_grouped(vertices, (long long)table_number(row, "vertices"));
    fprintf(table->to, "\n%s%c%s on %s%s: %s triangles, %s vertices", table->bold ? "\033[1m" : "",
            what[0] - 'a' + 'A', what + 1, table_text(row, "mesh"), table->bold ? "\033[0m" : "",
            triangles, vertices);
    json_array_foreach(json_object_get(document, "meshes"), i, mesh)
    {
        if (strcmp(table_text(mesh, "name"), table_text(row, "mesh")) == 0)
            fprintf(table->to, ", %s, valence <= %.0f",
                    table_number(mesh, "boundary_edges") > 0 ? "open" : "closed",
                    table_number(mesh, "highest_valence"));
    }
    fputs("\n", table->to);
}

/* ---- one table a representation and operation ---- */

static const struct {
    const char *operation, *head;
} sweeps[] = {{"bytes", "bytes"}, {"build", "build"},          {"transform", "move"},
              {"area", "area"},   {"face-normals", "face n"},  {"vertex-normals", "vert n"},
              {"edges", "edges"}, {"boundary-loops", "loops"}, {"smooth", "smooth"}},
  queries[] = {{"faces-around-vertex", "faces around v"},
               {"vertices-around-vertex", "vertices around v"},
               {"face-neighbours", "face neighbours"},
               {"is-edge", "is (u,v) edge"}};
enum {
    SWEEPS = sizeof sweeps / sizeof *sweeps,
    QUERIES = sizeof queries / sizeof *queries,
    SWEEP_WIDTH = 8,
    QUERY_WIDTH = 18
};

/* The row of that subject and operation on the same mesh. */
static const json_t *find_row(const json_t *rows, const json_t *like, const char *operation)
{
    size_t i;
    const json_t *row;
    json_array_foreach(rows, i, row)
    {
        if (strcmp(table_text(row, "operation"), operation) == 0 &&
            strcmp(table_text(row, "subject"), table_text(like, "subject")) == 0 &&
            strcmp(table_text(row, "what"), table_text(like, "what")) == 0 &&
            strcmp(table_text(row, "mesh"), table_text(like, "mesh")) == 0)
            return row;
    }
    return NULL;
}

static void write_cell(struct table *table, const json_t *row, int width)
{
    char value[NUMBER] = "-";
    const char *mark = "";
    const json_t *query = json_object_get(row, "ns_per_query");
    if (row && json_is_string(json_object_get(row, "error"))) {
        snprintf(value, sizeof value, "refused");
        table->has_refused = true;
    } else if (row && strcmp(table_text(row, "operation"), "bytes") == 0) {
        table_digits(value, table_number(json_object_get(row, "bytes_per_triangle"), "measured"));
    } else if (row && json_is_object(query)) {
        table_time(value, table_number(query, "median"));
    } else if (row && json_is_object(json_object_get(row, "ns_per_triangle"))) {
        table_time(value, table_number(json_object_get(row, "ns_per_triangle"), "median"));
    }
    if (row && (json_is_true(json_object_get(row, "noisy")) ||
                json_is_true(json_object_get(json_object_get(row, "ratio"), "too_noisy")))) {
        mark = "~";
        table->has_noisy = true;
    }
    if (row && strcmp(table_text(row, "answer"), "different") == 0) {
        mark = "!";
        table->has_different = true;
    }
    char marked[NUMBER + 2];
    snprintf(marked, sizeof marked, "%s%s", mark, value);
    fprintf(table->to, "%*s", width, marked);
}

static bool begins_subject(const json_t *rows, size_t at)
{
    const json_t *row = json_array_get(rows, at);
    for (size_t i = 0; i < at; i++) {
        const json_t *before = json_array_get(rows, i);
        if (strcmp(table_text(before, "subject"), table_text(row, "subject")) == 0 &&
            strcmp(table_text(before, "what"), table_text(row, "what")) == 0 &&
            strcmp(table_text(before, "mesh"), table_text(row, "mesh")) == 0)
            return false;
    }
    return true;
}

static bool same_table(const json_t *left, const json_t *right)
{
    return strcmp(table_text(left, "what"), table_text(right, "what")) == 0 &&
           strcmp(table_text(left, "mesh"), table_text(right, "mesh")) == 0;
}

static void write_matrix(struct table *table, const json_t *rows, const json_t *first, bool sweep)
{
    int count = sweep ? SWEEPS : QUERIES, width = sweep ? SWEEP_WIDTH : QUERY_WIDTH;
    size_t i;
    const json_t *row;
    fprintf(table->to, "%-*s", NAME_WIDTH, sweep ? "  ns a triangle, warm" : "  ns a query");
    for (int k = 0; k < count; k++)
        fprintf(table->to, "%*s", width, sweep ? sweeps[k].head : queries[k].head);
    fputs("\n", table->to);
    json_array_foreach(rows, i, row)
    {
        if (!same_table(row, first) || !begins_subject(rows, i))
            continue;
        fprintf(table->to, "  %-*.*s", NAME_WIDTH - 2, NAME_WIDTH - 2, table_text(row, "title"));
        for (int k = 0; k < count; k++)
            write_cell(table,
                       find_row(rows, row, sweep ? sweeps[k].operation : queries[k].operation),
                       width);
        fputs("\n", table->to);
    }
}

/* ---- one table an operation and program ---- */

static void write_ratio(struct table *table, const json_t *row)
{
    char whole[TABLE_INTERVAL];
    const json_t *ratio = json_object_get(row, "ratio");
    bool too_noisy = json_is_true(json_object_get(ratio, "too_noisy"));
    table_interval(whole, ratio, too_noisy);
    table->has_noisy |= too_noisy;
    fprintf(table->to, "%20s %-7s", json_is_object(ratio) ? whole : "", table_text(ratio, "to"));
}

/* The median: its interval is in bench.json, and with the goals. */
static void write_cold_ratio(struct table *table, const json_t *row)
{
    char median[TABLE_NUMBER] = "";
    const json_t *ratio = json_object_get(row, "cold_ratio");
    bool too_noisy = json_is_true(json_object_get(ratio, "too_noisy"));
    if (json_is_object(ratio))
        table_digits(median, table_number(ratio, "median"));
    table->has_noisy |= too_noisy;
    fprintf(table->to, "%7s", too_noisy ? "~" : median);
}

static void write_line(struct table *table, const json_t *row, const char *operation)
{
    char warm[NUMBER] = "-", cold[NUMBER] = "-", limit[NUMBER] = "";
    const json_t *times = json_object_get(row, "ns_per_triangle");
    const json_t *fresh = json_object_get(row, "cold_ns_per_triangle");
    const json_t *bound = json_object_get(row, "limit");
    const char *answer = table_text(row, "answer");
    bool is_kernel = strcmp(table_text(row, "kind"), "kernel") == 0;
    fprintf(table->to, "  %-16s%-21.20s", operation,
            is_kernel ? table_text(row, "variant") : table_text(row, "title"));
    if (json_is_string(json_object_get(row, "error"))) {
        fprintf(table->to, "  %.56s\n", table_text(row, "error"));
        return;
    }
    if (json_is_object(times))
        table_time(warm, table_number(times, "median"));
    if (json_is_object(fresh))
        table_time(cold, table_number(fresh, "median"));
    if (json_is_object(bound))
        snprintf(limit, sizeof limit, "%.0f %%", 100 * table_number(bound, "fraction"));
    fprintf(table->to, "%8s", warm);
    write_ratio(table, row);
    fprintf(table->to, " %s%8s",
            strcmp(answer, "equal") == 0       ? "="
            : strcmp(answer, "different") == 0 ? "!"
                                               : " ",
            cold);
    write_cold_ratio(table, row);
    fprintf(table->to, "%6s\n", limit);
    table->has_different |= strcmp(answer, "different") == 0;
    table->has_equal |= strcmp(answer, "equal") == 0;
}

/* What strips or orders are worth: "  indices a triangle: plain 1.02, OpenMesh 1.27". */
static void write_worth(const struct table *table, const json_t *rows, const json_t *like,
                        const char *fact, const char *title)
{
    size_t i;
    const json_t *row;
    bool begun = false;
    json_array_foreach(rows, i, row)
    {
        const json_t *value = json_object_get(json_object_get(row, "facts"), fact);
        if (!value || !same_table(row, like) ||
            strcmp(table_text(row, "operation"), table_text(like, "operation")) != 0)
            continue;
        bool is_kernel = strcmp(table_text(row, "kind"), "kernel") == 0;
        fprintf(table->to, "%s %s %.3f", begun ? "," : title,
                is_kernel ? table_text(row, "variant") : table_text(row, "title"),
                json_number_value(value) / table_number(row, "triangles"));
        begun = true;
    }
    if (begun)
        fputs("\n", table->to);
}

static void write_list(struct table *table, const json_t *rows, const json_t *first)
{
    size_t i, k;
    const json_t *row, *other;
    fprintf(table->to, "  %-37s%8s%20s %-9s%8s%7s%6s\n", "operation", "ns/tri", "ratio [interval]",
            "to", "cold", "ratio", "limit");
    json_array_foreach(rows, i, row)
    {
        bool is_first_of_its_kind = same_table(row, first);
        for (k = 0; k < i && is_first_of_its_kind; k++) {
            other = json_array_get(rows, k);
            is_first_of_its_kind =
                !same_table(other, first) ||
                strcmp(table_text(other, "operation"), table_text(row, "operation")) != 0;
        }
        if (!is_first_of_its_kind)
            continue;
        const char *operation = table_text(row, "operation");
        json_array_foreach(rows, k, other)
        {
            if (!same_table(other, first) ||
                strcmp(table_text(other, "operation"), table_text(row, "operation")) != 0)
                continue;
            write_line(table, other, operation);
            operation = "";
        }
        write_worth(table, rows, row, "indices", "      indices a triangle:");
        write_worth(table, rows, row, "cache_misses", "      vertices processed a triangle:");
    }
}

/* ---- the whole ---- */

/* All rows of one claim: whether it is the same number everywhere, and what was measured. */
struct claim_summary {
    double claimed, least, most; /* measured; as parts of what is claimed when that varies */
    const char *least_mesh, *most_mesh;
    int count, holding;
    bool varies;
};

static struct claim_summary sum_up_claim(const json_t *claims, const char *name)
{
    struct claim_summary summary = {.count = 0};
    size_t i;
    const json_t *claim;
    json_array_foreach(claims, i, claim)
    {
        if (strcmp(table_text(claim, "name"), name) != 0)
            continue;
        if (summary.count++ == 0)
            summary.claimed = table_number(claim, "claimed");
        summary.varies |= table_number(claim, "claimed") != summary.claimed;
        summary.holding += json_is_true(json_object_get(claim, "holds"));
    }
    bool is_first = true;
    json_array_foreach(claims, i, claim)
    {
        if (strcmp(table_text(claim, "name"), name) != 0)
            continue;
        double value =
            table_number(claim, "measured") / (summary.varies ? table_number(claim, "claimed") : 1);
        if (is_first || value < summary.least) {
            summary.least = value;
            summary.least_mesh = table_text(claim, "mesh");
        }
        if (is_first || value > summary.most) {
            summary.most = value;
            summary.most_mesh = table_text(claim, "mesh");
        }
        is_first = false;
    }
    return summary;
}

static bool is_first_of_its_name(const json_t *claims, size_t at)
{
    for (size_t i = 0; i < at; i++)
        if (strcmp(table_text(json_array_get(claims, i), "name"),
                   table_text(json_array_get(claims, at), "name")) == 0)
            return false;
    return true;
}

static void write_claims(const struct table *table, const json_t *claims)
{
    size_t i;
    const json_t *claim;
    if (json_array_size(claims) == 0)
        return;
    fprintf(table->to, "\n%sClaims of the course's documents%s\n", table->bold ? "\033[1m" : "",
            table->bold ? "\033[0m" : "");
    fprintf(table->to, "  %-43s%9s %-36s%9s\n", "claim", "claimed", " measured, least and most",
            "holds on");
    json_array_foreach(claims, i, claim)
    {
        char range[96], claimed[NUMBER] = "";
        if (!is_first_of_its_name(claims, i))
            continue;
        struct claim_summary summary = sum_up_claim(claims, table_text(claim, "name"));
        if (!summary.varies)
            snprintf(claimed, sizeof claimed, "%.4g", summary.claimed);
        snprintf(range, sizeof range, "%.3g %.11s%s%.3g %.11s", summary.least, summary.least_mesh,
                 summary.varies ? " ... of it " : " ... ", summary.most, summary.most_mesh);
        fprintf(table->to, "%c %-43.42s%9s  %-35.35s%3d of %d\n",
                summary.holding == summary.count ? ' ' : '!', table_text(claim, "claim"),
                summary.varies ? "it varies" : claimed, range, summary.holding, summary.count);
    }
}

static double least_confidence(const json_t *document)
{
    double least = 1;
    size_t i;
    const json_t *row;
    json_array_foreach(json_object_get(document, "rows"), i, row)
    {
        const json_t *ratio = json_object_get(row, "ratio");
        if (json_is_object(ratio) && table_number(ratio, "confidence") < least)
            least = table_number(ratio, "confidence");
    }
    return least;
}

static void write_closing(const struct table *table, const json_t *document)
{
    const json_t *noise = json_object_get(document, "noise");
    double samples = table_number(noise, "samples");
    if (samples == 0)
        return;
    fprintf(table->to, "\n%.0f samples, %.1f %% of them dropped because the core was slowed\n",
            samples, samples > 0 ? 100 * table_number(noise, "dropped") / samples : 0.0);
    fprintf(table->to, "intervals: of the sign test over fresh processes, at least %.0f %% sure\n",
            100 * least_confidence(document));
    if (table->has_equal)
        fputs(
            "ratio: time over that of the row named, in the same blocks; = the answers are equal\n"
            "cold: on fresh pages, and its ratio; limit: copying the bytes that must move, over "
            "the least time\n",
            table->to);
    if (table->has_noisy)
        fputs("~, too noisy: the interval is wider than a quarter either way\n", table->to);
    if (table->has_refused)
        fputs("refused: the structure cannot hold this mesh (bench.json says why)\n", table->to);
    if (table->has_different)
        fputs("!  the answer differs from that of the row compared to\n", table->to);
}

void table_write(const json_t *document, bool bold, FILE *to)
{
    struct table table = {.to = to, .bold = bold};
    const json_t *rows = json_object_get(document, "rows"), *row;
    size_t i;
    write_machine(&table, document);
    json_array_foreach(rows, i, row)
    {
        bool is_new = true;
        for (size_t k = 0; k < i && is_new; k++)
            is_new = !same_table(json_array_get(rows, k), row);
        if (!is_new)
            continue;
        write_title(&table, document, row);
        if (strcmp(table_text(row, "what"), "representations") == 0) {
            write_matrix(&table, rows, row, true);
            write_matrix(&table, rows, row, false);
        } else {
            write_list(&table, rows, row);
        }
    }
    table_goals(&table, json_object_get(document, "goals"));
    write_claims(&table, json_object_get(document, "claims"));
    table_accesses(&table, json_object_get(document, "accesses"));
    write_closing(&table, document);
}
