/* bench.json as tables to read; see table.h. */
#include "bench/compare/table.h"

#include <string.h>

enum { NUMBER = 24, NAME_WIDTH = 27 };

struct table {
    FILE *to;
    bool bold;
    bool has_noisy, has_refused, has_equal, has_different; /* what the closing lines must explain */
};

/* ---- numbers ---- */

static double number(const json_t *object, const char *key)
{
    return json_number_value(json_object_get(object, key));
}

static const char *text(const json_t *object, const char *key)
{
    const char *found = json_string_value(json_object_get(object, key));
    return found ? found : "";
}

/* Three digits or so. */
static void write_digits(char *out, double value)
{
    snprintf(out, NUMBER, "%.*f", value < 10 ? 2 : value < 100 ? 1 : 0, value);
}

/* A time with its unit where it is not some ns. */
static void write_time(char *out, double ns)
{
    char digits[NUMBER];
    double scale = ns < 1e4 ? 1 : ns < 1e7 ? 1e3 : 1e6;
    write_digits(digits, ns / scale);
    snprintf(out, NUMBER, "%.12s%s", digits, ns < 1e4 ? "" : ns < 1e7 ? " us" : " ms");
}

/* 1,234,567 */
static void write_grouped(char *out, long long value)
{
    char digits[NUMBER];
    int length = snprintf(digits, sizeof digits, "%lld", value), at = 0;
    for (int i = 0; i < length && at < NUMBER - 2; i++) {
        if (i > 0 && (length - i) % 3 == 0)
            out[at++] = ',';
        out[at++] = digits[i];
    }
    out[at] = '\0';
}

/* ---- the machine ---- */

static void write_machine(const struct table *table, const json_t *document)
{
    const json_t *machine = json_object_get(document, "machine"), *item;
    size_t i;
    fprintf(table->to, "%s, %d core%s%s, %.0f GiB, %s, %s\n", text(machine, "cpu"),
            (int)number(machine, "cores"), number(machine, "cores") > 1 ? "s" : "",
            json_is_true(json_object_get(machine, "hypervisor")) ? " of a virtual machine" : "",
            number(machine, "ram_bytes") / (1 << 30), text(machine, "kernel"),
            text(machine, "compiler"));
    fputs("caches", table->to);
    json_array_foreach(json_object_get(machine, "caches"), i, item)
    {
        double kib = number(item, "bytes") / 1024;
        if (strcmp(text(item, "type"), "Instruction") != 0)
            fprintf(table->to, "%s L%d %.0f %s", i ? "," : "", (int)number(item, "level"),
                    kib < 1024 ? kib : kib / 1024, kib < 1024 ? "KiB" : "MiB");
    }
    fputs("\ncopies", table->to);
    json_array_foreach(json_object_get(machine, "copy"), i, item)
    {
        fprintf(table->to, "%s %.0f MiB at %.0f GB/s", i ? "," : "",
                number(item, "bytes") / (1 << 20), number(item, "gigabytes_per_second"));
    }
    fputs(" (the faster of memcpy and stores past the caches)\n", table->to);
}

static void write_title(const struct table *table, const json_t *document, const json_t *row)
{
    char triangles[NUMBER], vertices[NUMBER];
    const char *what = text(row, "what");
    size_t i;
    const json_t *mesh;
    write_grouped(triangles, (long long)number(row, "triangles"));
    write_grouped(vertices, (long long)number(row, "vertices"));
    fprintf(table->to, "\n%s%c%s on %s%s: %s triangles, %s vertices", table->bold ? "\033[1m" : "",
            what[0] - 'a' + 'A', what + 1, text(row, "mesh"), table->bold ? "\033[0m" : "",
            triangles, vertices);
    json_array_foreach(json_object_get(document, "meshes"), i, mesh)
    {
        if (strcmp(text(mesh, "name"), text(row, "mesh")) == 0)
            fprintf(table->to, ", %s, valence <= %.0f",
                    number(mesh, "boundary_edges") > 0 ? "open" : "closed",
                    number(mesh, "highest_valence"));
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
        if (strcmp(text(row, "operation"), operation) == 0 &&
            strcmp(text(row, "subject"), text(like, "subject")) == 0 &&
            strcmp(text(row, "what"), text(like, "what")) == 0 &&
            strcmp(text(row, "mesh"), text(like, "mesh")) == 0)
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
    } else if (row && strcmp(text(row, "operation"), "bytes") == 0) {
        write_digits(value, number(json_object_get(row, "bytes_per_triangle"), "measured"));
    } else if (row && json_is_object(query)) {
        write_time(value, number(query, "median"));
    } else if (row && json_is_object(json_object_get(row, "ns_per_triangle"))) {
        write_time(value, number(json_object_get(row, "ns_per_triangle"), "median"));
    }
    if (row && (json_is_true(json_object_get(row, "noisy")) ||
                json_is_true(json_object_get(json_object_get(row, "ratio"), "too_noisy")))) {
        mark = "~";
        table->has_noisy = true;
    }
    if (row && strcmp(text(row, "answer"), "different") == 0) {
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
        if (strcmp(text(before, "subject"), text(row, "subject")) == 0 &&
            strcmp(text(before, "what"), text(row, "what")) == 0 &&
            strcmp(text(before, "mesh"), text(row, "mesh")) == 0)
            return false;
    }
    return true;
}

static bool same_table(const json_t *left, const json_t *right)
{
    return strcmp(text(left, "what"), text(right, "what")) == 0 &&
           strcmp(text(left, "mesh"), text(right, "mesh")) == 0;
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
        fprintf(table->to, "  %-*.*s", NAME_WIDTH - 2, NAME_WIDTH - 2, text(row, "title"));
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
    const json_t *ratio = json_object_get(row, "ratio");
    char median[NUMBER], low[NUMBER], high[NUMBER], whole[3 * NUMBER + 16] = "";
    if (json_is_object(ratio)) {
        write_digits(median, number(ratio, "median"));
        write_digits(low, number(ratio, "low"));
        write_digits(high, number(ratio, "high"));
        bool too_noisy = json_is_true(json_object_get(ratio, "too_noisy"));
        snprintf(whole, sizeof whole, "%s [%s, %s]", too_noisy ? "~" : median, low, high);
        table->has_noisy |= too_noisy;
    }
    fprintf(table->to, "%22s %-7s", whole, text(ratio, "to"));
}

static void write_line(struct table *table, const json_t *row, const char *operation)
{
    char warm[NUMBER] = "-", cold[NUMBER] = "-", limit[NUMBER] = "";
    const json_t *times = json_object_get(row, "ns_per_triangle");
    const json_t *fresh = json_object_get(row, "cold_ns_per_triangle");
    const json_t *bound = json_object_get(row, "limit");
    const char *answer = text(row, "answer");
    bool is_kernel = strcmp(text(row, "kind"), "kernel") == 0;
    fprintf(table->to, "  %-16s%-24.23s", operation,
            is_kernel ? text(row, "variant") : text(row, "title"));
    if (json_is_string(json_object_get(row, "error"))) {
        fprintf(table->to, "  %.56s\n", text(row, "error"));
        return;
    }
    if (json_is_object(times))
        write_time(warm, number(times, "median"));
    if (json_is_object(fresh))
        write_time(cold, number(fresh, "median"));
    if (json_is_object(bound))
        snprintf(limit, sizeof limit, "%.0f %%", 100 * number(bound, "fraction"));
    fprintf(table->to, "%8s", warm);
    write_ratio(table, row);
    fprintf(table->to, " %s%9s%7s\n",
            strcmp(answer, "equal") == 0       ? "="
            : strcmp(answer, "different") == 0 ? "!"
                                               : " ",
            cold, limit);
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
            strcmp(text(row, "operation"), text(like, "operation")) != 0)
            continue;
        bool is_kernel = strcmp(text(row, "kind"), "kernel") == 0;
        fprintf(table->to, "%s %s %.3f", begun ? "," : title,
                is_kernel ? text(row, "variant") : text(row, "title"),
                json_number_value(value) / number(row, "triangles"));
        begun = true;
    }
    if (begun)
        fputs("\n", table->to);
}

static void write_list(struct table *table, const json_t *rows, const json_t *first)
{
    size_t i, k;
    const json_t *row, *other;
    fprintf(table->to, "  %-40s%8s%22s %-9s%9s%7s\n", "operation", "ns/tri", "ratio [interval]",
            "to", "cold", "limit");
    json_array_foreach(rows, i, row)
    {
        bool is_first_of_its_kind = same_table(row, first);
        for (k = 0; k < i && is_first_of_its_kind; k++) {
            other = json_array_get(rows, k);
            is_first_of_its_kind = !same_table(other, first) ||
                                   strcmp(text(other, "operation"), text(row, "operation")) != 0;
        }
        if (!is_first_of_its_kind)
            continue;
        const char *operation = text(row, "operation");
        json_array_foreach(rows, k, other)
        {
            if (!same_table(other, first) ||
                strcmp(text(other, "operation"), text(row, "operation")) != 0)
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
        if (strcmp(text(claim, "name"), name) != 0)
            continue;
        if (summary.count++ == 0)
            summary.claimed = number(claim, "claimed");
        summary.varies |= number(claim, "claimed") != summary.claimed;
        summary.holding += json_is_true(json_object_get(claim, "holds"));
    }
    bool is_first = true;
    json_array_foreach(claims, i, claim)
    {
        if (strcmp(text(claim, "name"), name) != 0)
            continue;
        double value = number(claim, "measured") / (summary.varies ? number(claim, "claimed") : 1);
        if (is_first || value < summary.least) {
            summary.least = value;
            summary.least_mesh = text(claim, "mesh");
        }
        if (is_first || value > summary.most) {
            summary.most = value;
            summary.most_mesh = text(claim, "mesh");
        }
        is_first = false;
    }
    return summary;
}

static bool is_first_of_its_name(const json_t *claims, size_t at)
{
    for (size_t i = 0; i < at; i++)
        if (strcmp(text(json_array_get(claims, i), "name"),
                   text(json_array_get(claims, at), "name")) == 0)
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
        struct claim_summary summary = sum_up_claim(claims, text(claim, "name"));
        if (!summary.varies)
            snprintf(claimed, sizeof claimed, "%.4g", summary.claimed);
        snprintf(range, sizeof range, "%.3g %.11s%s%.3g %.11s", summary.least, summary.least_mesh,
                 summary.varies ? " ... of it " : " ... ", summary.most, summary.most_mesh);
        fprintf(table->to, "%c %-43.42s%9s  %-35.35s%3d of %d\n",
                summary.holding == summary.count ? ' ' : '!', text(claim, "claim"),
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
        if (json_is_object(ratio) && number(ratio, "confidence") < least)
            least = number(ratio, "confidence");
    }
    return least;
}

static void write_closing(const struct table *table, const json_t *document)
{
    const json_t *noise = json_object_get(document, "noise");
    double samples = number(noise, "samples");
    if (samples == 0)
        return;
    fprintf(table->to, "\n%.0f samples, %.1f %% of them dropped because the core was slowed\n",
            samples, samples > 0 ? 100 * number(noise, "dropped") / samples : 0.0);
    fprintf(table->to, "intervals: of the sign test over fresh processes, at least %.0f %% sure\n",
            100 * least_confidence(document));
    if (table->has_equal)
        fputs(
            "ratio: time over that of the row named, in the same blocks; = the answers are equal\n"
            "cold: on fresh pages; limit: copying the bytes that must move, over the least time\n",
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
        if (strcmp(text(row, "what"), "representations") == 0) {
            write_matrix(&table, rows, row, true);
            write_matrix(&table, rows, row, false);
        } else {
            write_list(&table, rows, row);
        }
    }
    write_claims(&table, json_object_get(document, "claims"));
    write_closing(&table, document);
}
