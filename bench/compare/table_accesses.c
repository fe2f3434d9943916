/* The counted accesses of queries on the terminal; see table_parts.h. */
#include "bench/compare/table_parts.h"

#include <string.h>

enum { TITLE_WIDTH = 25, CELL_WIDTH = 15 };

static const struct {
    const char *query, *head;
} queries[] = {{"face-vertices", "vertices of f"},
               {"face-neighbours", "neighbours f"},
               {"faces-around-vertex", "faces at v"},
               {"vertices-around-vertex", "vertices at v"},
               {"is-edge", "edge {u,v}?"}};
enum { QUERIES = sizeof queries / sizeof *queries };

static const json_t *find(const json_t *accesses, const char *subject, const char *query)
{
    size_t i;
    const json_t *row;
    json_array_foreach(accesses, i, row)
    {
        if (strcmp(table_text(row, "subject"), subject) == 0 &&
            strcmp(table_text(row, "query"), query) == 0)
            return row;
    }
    return NULL;
}

static void write_count(char *out, double accesses)
{
    bool is_whole = accesses == (double)(long long)accesses || accesses >= 100;
    snprintf(out, TABLE_NUMBER, "%.*f", is_whole ? 0 : 1, accesses);
}

/* "k 13 13", "!" before it when the claim does not hold. */
static void write_cell(const struct table *table, const json_t *row, const char *by)
{
    char cell[3 * TABLE_NUMBER], counts[2][TABLE_NUMBER];
    const json_t *pair = json_object_get(row, by);
    for (size_t i = 0; i < 2; i++)
        write_count(counts[i], table_number(json_array_get(pair, i), "accesses"));
    snprintf(cell, sizeof cell, "%s%.4s %.9s %.9s",
             json_is_true(json_object_get(row, "holds")) ? "" : "!", table_text(row, "claim"),
             counts[0], counts[1]);
    fprintf(table->to, "%*s", CELL_WIDTH, cell);
}

static void write_part(const struct table *table, const json_t *accesses, const char *by,
                       const char *key, const char *unit)
{
    size_t i;
    const json_t *row, *pair = json_object_get(json_array_get(accesses, 0), by);
    char low[TABLE_NUMBER], high[TABLE_NUMBER], head[2 * TABLE_NUMBER + 32];
    const char *before = "";
    table_grouped(low, (long long)table_number(json_array_get(pair, 0), key));
    table_grouped(high, (long long)table_number(json_array_get(pair, 1), key));
    snprintf(head, sizeof head, "  %s %s, %s", unit, low, high);
    fprintf(table->to, "%-*s", TITLE_WIDTH, head);
    for (int k = 0; k < QUERIES; k++)
        fprintf(table->to, "%*s", CELL_WIDTH, queries[k].head);
    fputs("\n", table->to);
    json_array_foreach(accesses, i, row)
    {
        const char *subject = table_text(row, "subject");
        if (strcmp(subject, before) == 0)
            continue;
        before = subject;
        fprintf(table->to, "  %-*.*s", TITLE_WIDTH - 2, TITLE_WIDTH - 2, table_text(row, "title"));
        for (int k = 0; k < QUERIES; k++)
            write_cell(table, find(accesses, subject, queries[k].query), by);
        fputs("\n", table->to);
    }
}

void table_accesses(const struct table *table, const json_t *accesses)
{
    if (json_array_size(accesses) == 0)
        return;
    fprintf(table->to,
            "\n%sAccesses of a query: what the header claims, and what was counted%s\n"
            "  1 constant, k valence or sides of a face, n all faces or edges, lg s search among "
            "strips;\n  an access reads a row of a table\n",
            table->bold ? "\033[1m" : "", table->bold ? "\033[0m" : "");
    write_part(table, accesses, "by_size", "triangles", "triangles");
    write_part(table, accesses, "by_valence", "valence", "valence");
}
