/* The goals on the terminal; see table_parts.h. */
#include "bench/compare/table_parts.h"

#include <string.h>

enum { MESH_WIDTH = 25, TIME_WIDTH = 21, POINT_WIDTH = 8, PART_COUNT = 4 };

/* Parts of a goal, and how they are called. */
static const struct {
    const char *key, *name;
} parts[PART_COUNT] = {
    {"warm", "warm"}, {"cold", "cold"}, {"plain_over_vector", "plain"}, {"indices", "indices"}};

static bool is_same_goal(const json_t *left, const json_t *right)
{
    return strcmp(table_text(left, "operation"), table_text(right, "operation")) == 0 &&
           strcmp(table_text(left, "orders"), table_text(right, "orders")) == 0;
}

/* The goal of a part, in any row of the same goal: parts that were not measured are null. */
static double goal_in(const json_t *goals, const json_t *like, const char *key, bool *at_least)
{
    const json_t *row;
    size_t i;
    json_array_foreach(goals, i, row)
    {
        const json_t *part = json_object_get(row, key);
        if (is_same_goal(row, like) && json_is_number(json_object_get(part, "goal"))) {
            *at_least = json_is_true(json_object_get(part, "at_least"));
            return table_number(part, "goal");
        }
    }
    return 0;
}

/* "edges-any: warm >= 20, cold >= 8, plain <= 2.5" */
static void write_group(const struct table *table, const json_t *goals, const json_t *row)
{
    const char *orders = table_text(row, "orders"), *before = ":";
    fprintf(table->to, "  %s%s%s%s", table_text(row, "operation"), *orders ? " (" : "", orders,
            *orders ? ")" : "");
    for (int i = 0; i < PART_COUNT; i++) {
        bool at_least = true;
        double goal = goal_in(goals, row, parts[i].key, &at_least);
        if (goal > 0) {
            fprintf(table->to, "%s %s %s %.4g", before, parts[i].name,
                    at_least ? ">=" : "<=", goal);
            before = ",";
        }
    }
    fputs(*before == ':' ? ": for information\n" : "\n", table->to);
}

/* A ratio with its interval, or its median alone where the column is narrow (the interval is in
 * bench.json), marked where it is not met. */
static void write_part(const struct table *table, const json_t *part, bool is_narrow)
{
    char cell[TABLE_INTERVAL + 2];
    const char *verdict = table_text(part, "verdict"), *why = table_text(part, "why");
    if (strcmp(why, "no peer") == 0)
        snprintf(cell, sizeof cell, "no peer");
    else
        table_interval(cell, part, strcmp(why, "too noisy") == 0);
    if (is_narrow)
        cell[strcspn(cell, " ")] = '\0';
    strcat(cell, strcmp(verdict, "missed") == 0      ? " !"
                 : strcmp(verdict, "undecided") == 0 ? " ?"
                                                     : "");
    fprintf(table->to, "%-*s", is_narrow ? POINT_WIDTH : TIME_WIDTH, cell);
}

static void write_row(const struct table *table, const json_t *row)
{
    const char *verdict = table_text(row, "verdict");
    fprintf(table->to, "    %-*.*s", MESH_WIDTH, MESH_WIDTH - 1, table_text(row, "mesh"));
    for (int i = 0; i < PART_COUNT; i++)
        write_part(table, json_object_get(row, parts[i].key), i >= 2);
    fprintf(table->to, "%s\n", strcmp(verdict, "none") == 0 ? "-" : verdict);
}

void table_goals(const struct table *table, const json_t *goals)
{
    static const char *const verdicts[] = {"met", "missed", "undecided"};
    int counts[3] = {0};
    const json_t *row;
    size_t i;
    if (json_array_size(goals) == 0)
        return;
    fprintf(
        table->to,
        "\n%sGoals%s: the fastest peer's time over ours on one thread, warm and cold; plain C over "
        "vector\n",
        table->bold ? "\033[1m" : "", table->bold ? "\033[0m" : "");
    fprintf(table->to, "    %-*s%-*s%-*s%-*s%-*s%s\n", MESH_WIDTH, "mesh", TIME_WIDTH, "warm",
            TIME_WIDTH, "cold", POINT_WIDTH, "plain", POINT_WIDTH, "indices", "verdict");
    json_array_foreach(goals, i, row)
    {
        if (i == 0 || !is_same_goal(row, json_array_get(goals, i - 1)))
            write_group(table, goals, row);
        write_row(table, row);
        for (int k = 0; k < 3; k++)
            counts[k] += strcmp(table_text(row, "verdict"), verdicts[k]) == 0;
    }
    fprintf(
        table->to,
        "  %d met, %d missed (!), %d undecided (?: the interval contains the goal, too noisy, too "
        "few blocks)\n",
        counts[0], counts[1], counts[2]);
}
