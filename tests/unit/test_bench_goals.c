/* The goals of a made-up run: met, missed and undecided, each for a reason that is known. */
#include "bench/compare/goals.h"
#include "bench/compare/table_parts.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define MESH "torus-100k-generated"

static json_t *ratio_of(const char *to, double low, double median, double high, int too_noisy)
{
    return json_pack("{s:s, s:f, s:f, s:f, s:f, s:b}", "to", to, "median", median, "low", low,
                     "high", high, "confidence", 0.96875, "too_noisy", too_noisy);
}

/* A row whose ratios the caller adds; kinds as in bench.json. */
static json_t *add(json_t *rows, const char *kind, const char *subject, const char *operation,
                   const char *order)
{
    bool is_reader = strncmp(operation, "read", 4) == 0;
    json_t *row = json_pack(
        "{s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:i, s:{s:f}, s:s, s:{}}", "what",
        is_reader ? "readers" : "kernels", "kind", kind, "subject", subject, "title", subject,
        "variant", strcmp(kind, "kernel") == 0 ? subject : "", "operation", operation, "mesh", MESH,
        "order", order, "threads", 1, "ns_per_triangle", "median", 1.0, "answer", "equal", "facts");
    json_array_append_new(rows, row);
    return row;
}

/* Ours as plain and avx2, which takes 1/2 of plain's time, and a peer with these warm ratios. */
static json_t *add_three(json_t *rows, const char *operation, const char *order, double low,
                         double median, double high)
{
    add(rows, "kernel", "plain", operation, order);
    json_t *fast = add(rows, "kernel", "avx2", operation, order);
    json_object_set_new(fast, "ratio", ratio_of("plain", 0.48, 0.5, 0.52, 0));
    json_t *peer = add(rows, "peer", "Peer", operation, order);
    json_object_set_new(peer, "ratio", ratio_of("avx2", low, median, high, 0));
    return peer;
}

/* The only goal of these rows, which are released. */
static json_t *only_goal(json_t *rows)
{
    json_t *goals = goals_of(rows);
    assert_int_equal(json_array_size(goals), 1);
    json_t *goal = json_incref(json_array_get(goals, 0));
    json_decref(goals);
    json_decref(rows);
    return goal;
}

/* Verdict of a part and why, which is NULL where nothing is to be said. */
static void assert_part(const json_t *goal, const char *key, const char *verdict, const char *why)
{
    const json_t *part = json_object_get(goal, key);
    assert_string_equal(json_string_value(json_object_get(part, "verdict")), verdict);
    const char *found = json_string_value(json_object_get(part, "why"));
    if (why)
        assert_string_equal(found, why);
    else
        assert_null(found);
}

static void assert_verdict(const json_t *goal, const char *verdict)
{
    assert_string_equal(json_string_value(json_object_get(goal, "verdict")), verdict);
}

static void a_goal_is_met_when_the_whole_interval_keeps_it(void **state)
{
    (void)state;
    json_t *rows = json_array(), *peer = add_three(rows, "edges-any", "generated", 20, 21, 22);
    json_object_set_new(peer, "cold_ratio", ratio_of("avx2", 8, 9, 10, 0));
    json_t *goal = only_goal(rows);
    assert_part(goal, "warm", "met", NULL);
    assert_part(goal, "cold", "met", NULL);
    assert_part(goal, "plain_over_vector", "met", NULL);
    const json_t *plain = json_object_get(goal, "plain_over_vector");
    assert_true(fabs(json_number_value(json_object_get(plain, "median")) - 2) < 1e-9);
    assert_true(fabs(json_number_value(json_object_get(plain, "low")) - 1 / 0.52) < 1e-9);
    assert_true(json_is_null(json_object_get(goal, "indices")));
    assert_string_equal(json_string_value(json_object_get(goal, "variant")), "avx2");
    assert_verdict(goal, "met");
    json_decref(goal);
}

static void a_goal_is_missed_when_the_whole_interval_breaks_it(void **state)
{
    (void)state;
    json_t *rows = json_array(), *peer = add_three(rows, "edges-closed", "cache", 25, 26, 27);
    json_object_set_new(peer, "cold_ratio", ratio_of("avx2", 7.0, 7.5, 7.9, 0));
    json_t *goal = only_goal(rows);
    assert_part(goal, "warm", "met", NULL);
    assert_part(goal, "cold", "missed", NULL);
    assert_verdict(goal, "missed");
    json_decref(goal);
}

static void plain_may_take_two_and_a_half_times_as_long(void **state)
{
    (void)state;
    json_t *rows = json_array();
    add_three(rows, "face-normals", "generated", 1, 2, 3);
    json_object_set_new(json_array_get(rows, 1), "ratio", ratio_of("plain", 0.3, 0.32, 0.35, 0));
    json_t *goal = only_goal(rows);
    assert_part(goal, "warm", "none", NULL); /* for information */
    assert_part(goal, "plain_over_vector", "missed", NULL);
    assert_verdict(goal, "missed");
    json_decref(goal);
}

static void a_goal_is_undecided_for_four_reasons(void **state)
{
    (void)state;
    json_t *rows = json_array(), *peer = add_three(rows, "twins", "generated", 3.9, 4.1, 4.3);
    json_object_set_new(peer, "cold_ratio", ratio_of("avx2", 2, 6, 9, 1));
    json_t *goal = only_goal(rows);
    assert_part(goal, "warm", "undecided", "the interval contains the goal");
    assert_part(goal, "cold", "undecided", "too noisy");
    assert_verdict(goal, "undecided");
    json_decref(goal);

    rows = json_array();
    peer = add_three(rows, "twins", "generated", 6, 7, 8);
    json_object_set_new(json_object_get(peer, "ratio"), "confidence", json_real(0.5));
    goal = only_goal(rows);
    assert_part(goal, "warm", "undecided", "too few blocks");
    assert_part(goal, "cold", "undecided", "no peer"); /* no cold time of one */
    json_decref(goal);
}

/* 12 to 20 is noisy, and yet surely more than 4. */
static void a_wide_interval_decides_when_it_lies_on_one_side(void **state)
{
    (void)state;
    json_t *rows = json_array(), *peer = add_three(rows, "twins", "generated", 6, 7, 8);
    json_object_set_new(peer, "ratio", ratio_of("avx2", 12, 15, 20, 1));
    json_object_set_new(peer, "cold_ratio", ratio_of("avx2", 1, 2, 2.9, 1));
    json_t *goal = only_goal(rows);
    assert_part(goal, "warm", "met", NULL);
    assert_part(goal, "cold", "missed", NULL);
    json_decref(goal);
}

static void a_wrong_answer_is_no_peer(void **state)
{
    (void)state;
    json_t *rows = json_array(), *peer = add_three(rows, "area", "generated", 1, 1, 1);
    json_object_set_new(peer, "answer", json_string("different"));
    json_t *goal = only_goal(rows);
    assert_part(goal, "warm", "undecided", "no peer");
    json_decref(goal);
}

static void the_fastest_peer_counts(void **state)
{
    (void)state;
    json_t *rows = json_array();
    add_three(rows, "area", "scrambled", 30, 31, 32);
    json_t *fast = add(rows, "peer", "Fast", "area", "scrambled");
    json_object_set_new(fast, "ratio", ratio_of("avx2", 3.5, 4, 4.5, 0));
    json_t *goal = only_goal(rows);
    const json_t *warm = json_object_get(goal, "warm");
    assert_string_equal(json_string_value(json_object_get(warm, "peer")), "Fast");
    assert_true(json_number_value(json_object_get(warm, "goal")) == 3); /* 5 in other orders */
    assert_verdict(goal, "met");
    json_decref(goal);
}

static void strips_are_held_against_meshoptimizer_alone(void **state)
{
    static const struct {
        int indices;
        const char *verdict;
    } cases[] = {{1010, "met"}, {1011, "missed"}};
    (void)state;
    for (size_t i = 0; i < 2; i++) {
        json_t *rows = json_array();
        json_t *slow = add_three(rows, "stripify", "generated", 0.5, 0.5, 0.5);
        json_object_set_new(json_array_get(rows, 1), "facts",
                            json_pack("{s:i}", "indices", cases[i].indices));
        json_t *peer = add(rows, "peer", "meshoptimizer", "stripify", "generated");
        json_object_set_new(peer, "ratio", ratio_of("avx2", 1.0, 1.1, 1.2, 0));
        json_object_set_new(peer, "facts", json_pack("{s:i}", "indices", 1000));
        json_object_set_new(slow, "facts", json_pack("{s:i}", "indices", 10));
        json_t *goal = only_goal(rows);
        assert_part(goal, "warm", "met", NULL);
        assert_part(goal, "indices", cases[i].verdict, NULL);
        assert_verdict(goal, cases[i].verdict);
        json_decref(goal);
    }
}

static void readers_are_no_slower(void **state)
{
    (void)state;
    json_t *rows = json_array();
    add(rows, "reader", "meshgrade", "read-off", "generated");
    json_t *peer = add(rows, "peer", "Peer", "read-off", "generated");
    json_object_set_new(peer, "ratio", ratio_of("meshgrade", 0.7, 0.8, 0.9, 0));
    json_t *goal = only_goal(rows);
    assert_part(goal, "warm", "missed", NULL);
    json_decref(goal);
}

static void the_table_tells_all(void **state)
{
    char *text = NULL;
    size_t length;
    (void)state;
    json_t *rows = json_array(), *peer = add_three(rows, "edges-any", "generated", 20, 21, 22);
    json_object_set_new(peer, "cold_ratio", ratio_of("avx2", 7.0, 7.5, 7.9, 0));
    add_three(rows, "twins", "generated", 3.9, 4.1, 4.3);
    add_three(rows, "area", "generated", 5, 6, 7);
    json_t *goals = goals_of(rows);
    struct table table = {.to = open_memstream(&text, &length)};
    table_goals(&table, goals);
    fclose(table.to);
    for (const char *line = text; *line; line = strchr(line, '\n') + 1)
        assert_true(strchr(line, '\n') - line <= 100);
    assert_non_null(strstr(text, "edges-any: warm >= 20, cold >= 8, plain <= 2.5\n"));
    assert_non_null(
        strstr(text, "21.0 [20.0, 22.0]    7.50 [7.00, 7.90] !  2.00    -       missed\n"));
    assert_non_null(
        strstr(text, "4.10 [3.90, 4.30] ?  no peer ?            2.00    -       undecided\n"));
    assert_non_null(strstr(text, "  area (generated or cache order): "));
    assert_non_null(strstr(text, "  1 met, 1 missed (!), 1 undecided (?: "));
    free(text);
    json_decref(goals);
    json_decref(rows);
}

static void every_goal_has_a_reason(void **state)
{
    (void)state;
    for (const struct goal *goal = goals_table; goal->operation; goal++) {
        assert_true(strlen(goal->reason) > 20);
        const struct goal *found = goals_find(goal->operation, goal->order ? goal->order : "cache");
        assert_ptr_equal(found, goal); /* no entry hides another */
    }
    assert_null(goals_find("vertex-cache", "generated"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_goal_is_met_when_the_whole_interval_keeps_it),
        cmocka_unit_test(a_goal_is_missed_when_the_whole_interval_breaks_it),
        cmocka_unit_test(plain_may_take_two_and_a_half_times_as_long),
        cmocka_unit_test(a_goal_is_undecided_for_four_reasons),
        cmocka_unit_test(a_wide_interval_decides_when_it_lies_on_one_side),
        cmocka_unit_test(a_wrong_answer_is_no_peer),
        cmocka_unit_test(the_fastest_peer_counts),
        cmocka_unit_test(strips_are_held_against_meshoptimizer_alone),
        cmocka_unit_test(readers_are_no_slower),
        cmocka_unit_test(the_table_tells_all),
        cmocka_unit_test(every_goal_has_a_reason),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
