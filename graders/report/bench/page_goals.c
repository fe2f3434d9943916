/* The table of goals; see page.h. What a goal is: bench/compare/goals.h. */
#include "graders/report/bench/page.h"

#include <math.h>
#include <string.h>

static const char *words_of_goal(const char *verdict)
{
    return strcmp(verdict, "met") == 0         ? "✓ met"
           : strcmp(verdict, "missed") == 0    ? "✗ missed"
           : strcmp(verdict, "undecided") == 0 ? "undecided"
                                               : "–";
}

static const char *verdict_class(const char *verdict)
{
    return strcmp(verdict, "met") == 0 ? "holds" : strcmp(verdict, "missed") == 0 ? "fails" : NULL;
}

/* "21.0 (20.0 – 22.0)"; "0.96" where the interval is a point; "" without a number. */
static void interval_words(const json_t *part, char *text, size_t capacity)
{
    double median = study_number(part, "median");
    double low = study_number(part, "low"), high = study_number(part, "high");
    if (isnan(median))
        snprintf(text, capacity, "%s", "");
    else if (low < high)
        snprintf(text, capacity, "%.3g (%.3g – %.3g)", median, low, high);
    else
        snprintf(text, capacity, "%.3g", median);
}

/* The number, below it the goal and against whom, and why it is undecided. */
static void part_cell(struct html *page, const json_t *part)
{
    char numbers[80];
    double goal = study_number(part, "goal");
    const char *peer = study_text(part, "peer"), *why = study_text(part, "why");
    html_open(page, "td");
    if (json_is_object(part)) {
        interval_words(part, numbers, sizeof numbers);
        const char *class_name = verdict_class(study_text(part, "verdict"));
        html_leaf(page, "span", class_name, numbers);
        html_open(page, "small");
        if (!isnan(goal))
            html_format(page, json_is_true(json_object_get(part, "at_least")) ? "≥ %.4g" : "≤ %.4g",
                        goal);
        if (*peer)
            html_format(page, isnan(goal) ? "%s" : ", %s", peer);
        if (*why)
            html_format(page, "; %s", why);
        html_close(page, "small");
    }
    html_close(page, "td");
}

static void goal_row(struct html *page, const json_t *goal)
{
    static const char *const parts[] = {"warm", "cold", "plain_over_vector", "indices"};
    char mesh[120];
    const char *verdict = study_text(goal, "verdict"), *orders = study_text(goal, "orders");
    study_mesh_words(study_text(goal, "mesh"), mesh, sizeof mesh);
    html_open(page, "tr");
    html_open(page, "th");
    html_attribute(page, "scope", "row");
    html_text(page, study_operation(study_text(goal, "operation")));
    if (*orders)
        html_leaf(page, "small", NULL, orders);
    html_close(page, "th");
    table_cell(page, NULL, mesh);
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        part_cell(page, json_object_get(goal, parts[i]));
    table_cell(page, verdict_class(verdict), words_of_goal(verdict));
    html_close(page, "tr");
}

static size_t count_of(const json_t *goals, const char *verdict)
{
    size_t i, count = 0;
    const json_t *goal;
    json_array_foreach(goals, i, goal)
    {
        count += strcmp(study_text(goal, "verdict"), verdict) == 0;
    }
    return count;
}

/* Why each goal is what it is, each reason once. */
static void write_reasons(struct html *page, const json_t *goals)
{
    size_t i;
    const json_t *goal;
    const char *last = "";
    html_open(page, "details");
    html_leaf(page, "summary", NULL, "Why these goals");
    html_open(page, "ul");
    json_array_foreach(goals, i, goal)
    {
        const char *operation = study_text(goal, "operation");
        if (strcmp(operation, last) == 0)
            continue;
        last = operation;
        html_open(page, "li");
        html_format(page, "%s", study_operation(operation));
        html_format(page, ": %s.", study_text(goal, "reason"));
        html_close(page, "li");
    }
    html_close(page, "ul");
    html_close(page, "details");
}

void page_goals(struct html *page, struct bench_page *context)
{
    static const char *const names[] = {"operation",         "mesh",    "warm",   "cold",
                                        "plain over vector", "indices", "verdict"};
    const json_t *goals = json_object_get(context->study->document, "goals"), *goal;
    size_t i;
    if (json_array_size(goals) == 0)
        return;
    html_open(page, "section");
    html_attribute(page, "id", "goals");
    html_leaf(page, "h2", NULL, "Goals");
    html_open(page, "p");
    html_format(page, "Of %zu goals %zu are met", json_array_size(goals), count_of(goals, "met"));
    html_format(page, ", %zu missed and %zu undecided: ", count_of(goals, "missed"),
                count_of(goals, "undecided"));
    html_text(page, "the interval contains the goal, is too wide or of too few blocks, or no other "
                    "library took part.");
    html_close(page, "p");
    table_open(page, context,
               "The time of the fastest peer over that of our fastest variant on one thread, warm "
               "and cold, with intervals; the plain variant's time over the vector one's; strips' "
               "indices over the peer's. Below each, what is asked and of whom.");
    table_head(page, names, sizeof names / sizeof *names);
    html_open(page, "tbody");
    json_array_foreach(goals, i, goal)
    {
        goal_row(page, goal);
    }
    html_close(page, "tbody");
    table_close(page);
    write_reasons(page, goals);
    html_close(page, "section");
}
