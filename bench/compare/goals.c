/* The goals and their verdicts; see goals.h. */
#include "bench/compare/goals.h"

#include "bench/measure/interval.h"

#include <stdbool.h>
#include <string.h>

#define EDGES_REASON                                                                               \
    "an edge table needs no structure beside it; libraries build one, and cold calls pay for "     \
    "pages on both sides"
#define NORMALS_REASON                                                                             \
    "a sweep over the triangles; in scrambled order memory's latency holds for all"
#define READERS_REASON "reading is to be no reason to choose another program"
#define STRIPS_REASON                                                                              \
    "meshoptimizer is what renderers use: strips are worth it when no longer and no slower"

const struct goal goals_table[] = {
    {"edges-closed", NULL, "", 20, 8, 2.5, 0, NULL, EDGES_REASON},
    {"edges-any", NULL, "", 20, 8, 2.5, 0, NULL, EDGES_REASON},
    {"twins", NULL, "", 4, 3, 2.5, 0, NULL,
     "sides must be matched whatever the structure; libraries do the rest of it too"},
    {"area", "scrambled", "scrambled order", 3, 0, 2.5, 0, NULL, NORMALS_REASON},
    {"area", NULL, "generated or cache order", 5, 0, 2.5, 0, NULL, NORMALS_REASON},
    {"vertex-normals", "scrambled", "scrambled order", 3, 0, 2.5, 0, NULL, NORMALS_REASON},
    {"vertex-normals", NULL, "generated or cache order", 5, 0, 2.5, 0, NULL, NORMALS_REASON},
    {"face-normals", NULL, "", 0, 0, 2.5, 0, NULL, "for information: no ratio was asked for"},
    {"stripify", NULL, "with the order that strips need", 1, 0, 2.5, 1.01, "meshoptimizer",
     STRIPS_REASON},
    {"strips-in-order", NULL, "of a mesh in cache order, without ordering", 1, 0, 0, 1.01,
     "meshoptimizer", STRIPS_REASON},
    {"read-ply-binary", NULL, "", 1, 0, 0, 0, NULL, READERS_REASON},
    {"read-ply-ascii", NULL, "", 1, 0, 0, 0, NULL, READERS_REASON},
    {"read-obj", NULL, "", 1, 0, 0, 0, NULL, READERS_REASON},
    {"read-off", NULL, "", 1, 0, 0, 0, NULL, READERS_REASON},
    {0},
};

const struct goal *goals_find(const char *operation, const char *order)
{
    for (const struct goal *goal = goals_table; goal->operation; goal++)
        if (strcmp(goal->operation, operation) == 0 &&
            (!goal->order || strcmp(goal->order, order) == 0))
            return goal;
    return NULL;
}

/* ---- rows ---- */

static const char *text(const json_t *object, const char *key)
{
    const char *found = json_string_value(json_object_get(object, key));
    return found ? found : "";
}

static double number(const json_t *object, const char *key)
{
    return json_number_value(json_object_get(object, key));
}

/* Whether both rows are of one operation on one mesh. */
static bool stand_together(const json_t *left, const json_t *right)
{
    return strcmp(text(left, "what"), text(right, "what")) == 0 &&
           strcmp(text(left, "mesh"), text(right, "mesh")) == 0 &&
           strcmp(text(left, "operation"), text(right, "operation")) == 0;
}

static bool is_ours(const json_t *row)
{
    const char *kind = text(row, "kind");
    return (strcmp(kind, "kernel") == 0 || strcmp(kind, "reader") == 0) &&
           json_integer_value(json_object_get(row, "threads")) == 1 &&
           json_is_object(json_object_get(row, "ns_per_triangle"));
}

/* Our variant on one thread that peers are held against: the last, as in rows.c. */
static const json_t *find_ours(const json_t *rows, const json_t *like)
{
    const json_t *row, *found = NULL;
    size_t i;
    json_array_foreach(rows, i, row)
    {
        if (is_ours(row) && stand_together(row, like))
            found = row;
    }
    return found;
}

/* The peer with the least ratio to ours under `key` and no wrong answer; NULL: none. */
static const json_t *find_peer(const json_t *rows, const json_t *ours, const char *subject,
                               const char *key)
{
    const json_t *row, *found = NULL;
    size_t i;
    json_array_foreach(rows, i, row)
    {
        if (strcmp(text(row, "kind"), "peer") != 0 || !stand_together(row, ours) ||
            (subject && strcmp(text(row, "subject"), subject) != 0) ||
            !json_is_object(json_object_get(row, key)) ||
            strcmp(text(row, "answer"), "different") == 0)
            continue;
        if (!found || number(json_object_get(row, key), "median") <
                          number(json_object_get(found, key), "median"))
            found = row;
    }
    return found;
}

/* ---- parts ---- */

/* Why an interval cannot tell, or NULL. */
static const char *doubt(const json_t *ratio)
{
    return number(ratio, "confidence") < 0.95 ? "too few blocks" : NULL;
}

/* A part with its verdict: median, low and high are to be at least `goal`, or at most. A wide
 * interval decides, too, when all of it lies on one side. With goal 0 there is no verdict. */
static json_t *judge(double goal, bool at_least, double median, double low, double high,
                     const char *why)
{
    bool all = at_least ? low >= goal : high <= goal, none = at_least ? high < goal : low > goal;
    const char *verdict = goal == 0 ? "none" : why ? "undecided" : all ? "met" : "missed";
    if (!why && goal > 0 && !all && !none) {
        const struct interval interval = {.median = median, .low = low, .high = high};
        verdict = "undecided";
        why = interval_too_noisy(&interval) ? "too noisy" : "the interval contains the goal";
    }
    return json_pack("{s:o, s:b, s:f, s:f, s:f, s:s, s:s?}", "goal",
                     goal > 0 ? json_real(goal) : json_null(), "at_least", at_least, "median",
                     median, "low", low, "high", high, "verdict", verdict, "why", why);
}

static json_t *no_peer(double goal, bool at_least)
{
    return json_pack("{s:f, s:b, s:n, s:n, s:n, s:s, s:s, s:n}", "goal", goal, "at_least", at_least,
                     "median", "low", "high", "verdict", "undecided", "why", "no peer", "peer");
}

static json_t *judge_time(const json_t *rows, const json_t *ours, const struct goal *goal,
                          const char *key, double least)
{
    const json_t *peer = find_peer(rows, ours, goal->peer, key);
    if (!peer)
        return least > 0 ? no_peer(least, true) : json_null();
    const json_t *ratio = json_object_get(peer, key);
    json_t *part = judge(least, true, number(ratio, "median"), number(ratio, "low"),
                         number(ratio, "high"), doubt(ratio));
    json_object_set(part, "peer", json_object_get(peer, "title"));
    return part;
}

/* Plain over vector: one over our variant's ratio to the plain one. */
static json_t *judge_plain(const json_t *ours, double most)
{
    const json_t *ratio = json_object_get(ours, "ratio");
    if (most == 0 || strcmp(text(ratio, "to"), "plain") != 0)
        return json_null();
    return judge(most, false, 1 / number(ratio, "median"), 1 / number(ratio, "high"),
                 1 / number(ratio, "low"), doubt(ratio));
}

/* Counts repeat exactly: their interval is a point. */
static json_t *judge_indices(const json_t *rows, const json_t *ours, const struct goal *goal)
{
    const json_t *peer = find_peer(rows, ours, goal->peer, "ratio");
    double mine = number(json_object_get(ours, "facts"), "indices");
    double theirs = number(json_object_get(peer, "facts"), "indices");
    if (goal->indices == 0)
        return json_null();
    if (!(mine > 0 && theirs > 0))
        return no_peer(goal->indices, false);
    json_t *part = judge(goal->indices, false, mine / theirs, mine / theirs, mine / theirs, NULL);
    json_object_set(part, "peer", json_object_get(peer, "title"));
    return part;
}

/* ---- the whole ---- */

static const char *verdict_of(json_t *const *parts, size_t count)
{
    const char *verdict = "none";
    for (size_t i = 0; i < count; i++) {
        const char *one = text(parts[i], "verdict");
        if (strcmp(one, "missed") == 0)
            return "missed";
        if (strcmp(one, "undecided") == 0 ||
            (strcmp(one, "met") == 0 && strcmp(verdict, "none") == 0))
            verdict = strcmp(one, "met") == 0 ? "met" : "undecided";
    }
    return verdict;
}

static json_t *goal_row(const json_t *rows, const json_t *ours, const struct goal *goal)
{
    enum { PARTS = 4 };
    json_t *parts[PARTS] = {judge_time(rows, ours, goal, "ratio", goal->warm),
                            judge_time(rows, ours, goal, "cold_ratio", goal->cold),
                            judge_plain(ours, goal->plain), judge_indices(rows, ours, goal)};
    const char *verdict = verdict_of(parts, PARTS);
    return json_pack("{s:O, s:O, s:O, s:O, s:O, s:s, s:s, s:s, s:o, s:o, s:o, s:o}", "what",
                     json_object_get(ours, "what"), "operation", json_object_get(ours, "operation"),
                     "mesh", json_object_get(ours, "mesh"), "order", json_object_get(ours, "order"),
                     "variant", json_object_get(ours, "variant"), "orders", goal->orders, "reason",
                     goal->reason, "verdict", verdict, "warm", parts[0], "cold", parts[1],
                     "plain_over_vector", parts[2], "indices", parts[3]);
}

json_t *goals_of(const json_t *rows)
{
    json_t *goals = json_array();
    const json_t *row;
    size_t i;
    for (const struct goal *goal = goals_table; goal->operation; goal++)
        json_array_foreach(rows, i, row)
        {
            if (goals_find(text(row, "operation"), text(row, "order")) == goal && is_ours(row) &&
                find_ours(rows, row) == row)
                json_array_append_new(goals, goal_row(rows, row, goal));
        }
    return goals;
}
