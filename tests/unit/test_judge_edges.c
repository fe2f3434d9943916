/* The judges of the edge tables: known submissions, and answers of every kind against an oracle
 * that compares with a matrix of all pairs. */
#include "graders/library/judge.h"
#include "reference/base/random.h"
#include "tests/unit/submissions.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

extern const struct judge judge_edge_table_any, judge_edge_table_closed;

enum { VERTEX_LIMIT = 9, TRIANGLE_LIMIT = 14, ENTRY_LIMIT = 6 * TRIANGLE_LIMIT + 4, ROUNDS = 4000 };

/* --------------------------------------------------------------------------------------- oracle */

struct edge_answer {
    int32_t ends[2 * ENTRY_LIMIT];
    int64_t count;
};

struct trial {
    struct random rng;
    struct writer input;
    int32_t vertex_count;
    bool joined[VERTEX_LIMIT][VERTEX_LIMIT];
    struct edge_answer right;
};

static int32_t below(struct trial *t, int32_t bound)
{
    return (int32_t)random_below(&t->rng, (uint64_t)bound);
}

static void swap(int32_t *a, int32_t *b)
{
    int32_t kept = *a;
    *a = *b;
    *b = kept;
}

/* Random triangles on few vertices: all that can happen to an edge happens. */
static void trial_begin(struct trial *t, uint64_t seed)
{
    struct mesh mesh;
    random_init(&t->rng, seed);
    t->vertex_count = 1 + below(t, VERTEX_LIMIT);
    assert_int_equal(mesh_init(&mesh, t->vertex_count, below(t, TRIANGLE_LIMIT), NULL), 0);
    memset(t->joined, 0, sizeof t->joined);
    for (int32_t i = 0; i < 3 * mesh.triangle_count; i++)
        mesh.triangles[i] = below(t, t->vertex_count);
    for (int32_t i = 0; i < 3 * mesh.triangle_count; i++) {
        int32_t a = mesh.triangles[i], b = mesh.triangles[i % 3 == 2 ? i - 2 : i + 1];
        t->joined[a][b] = t->joined[b][a] = a != b;
    }
    t->input = writer_growing();
    assert_int_equal(mesh_input_write(&mesh, true, &t->input, NULL), 0);
    mesh_release(&mesh);
    t->right.count = 0;
    for (int32_t a = 0; a < t->vertex_count; a++)
        for (int32_t b = 0; b < a; b++)
            if (t->joined[a][b]) {
                t->right.ends[2 * t->right.count] = a;
                t->right.ends[2 * t->right.count++ + 1] = b;
            }
}

static bool oracle_accepts(const struct trial *t, const struct edge_answer *answer)
{
    bool met[VERTEX_LIMIT][VERTEX_LIMIT] = {0};
    for (int64_t e = 0; e < answer->count; e++) {
        int32_t a = answer->ends[2 * e], b = answer->ends[2 * e + 1];
        if (a < 0 || b < 0 || a >= t->vertex_count || b >= t->vertex_count)
            return false;
        if (!t->joined[a][b] || met[a][b])
            return false;
        met[a][b] = met[b][a] = true;
    }
    return answer->count == t->right.count;
}

/* -------------------------------------------------------------------------------------- answers */

/* The first mark of a scene is the edge that the verdict names, unless it has ends out of range. */
static void check_first_mark(const struct judgement *judgement)
{
    int32_t a, b;
    long long entry;
    bool known = sscanf(judgement->element.en, "edge {%d,%d}", &a, &b) == 2 ||
                 sscanf(judgement->element.en, "edge %lld (%d,%d)", &entry, &a, &b) == 3;
    if (!known || strcmp(judgement->cause, "index-out-of-range") == 0)
        return;
    assert_true(judgement->scene.kept_mark_count > 0);
    const int32_t *ends = judgement->scene.marks[0].vertex;
    assert_true((ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a));
}

/* The bytes are copied to memory of just that size, so that a sanitizer sees a read beyond. */
static bool judge_bytes(const struct judge *judge, const struct writer *input, const void *bytes,
                        size_t count, struct judgement *judgement)
{
    struct error err = {0};
    unsigned char *copy = malloc(count ? count : 1);
    assert_non_null(copy);
    if (count)
        memcpy(copy, bytes, count);
    *judgement = (struct judgement){0};
    struct span in = {input->bytes, input->count}, out = {copy, count};
    assert_int_equal(judge_answer(judge, in, out, NULL, judgement, &err), 0);
    free(copy);
    if (!judgement->accepted) {
        assert_true(judgement->cause[0] && judgement->message.en[0] && judgement->message.es[0] &&
                    judgement->cause_name.en[0] && judgement->cause_name.es[0]);
        assert_true(strlen(judgement->message.en) + 1 < sizeof judgement->message.en);
        assert_true(strlen(judgement->message.es) + 1 < sizeof judgement->message.es);
        check_first_mark(judgement);
    }
    json_t *scene = scene_to_json(&judgement->scene);
    assert_non_null(scene);
    json_decref(scene);
    scene_release(&judgement->scene);
    return judgement->accepted;
}

/* As the runner writes it. */
static void write_edges(struct writer *packet, const int32_t *ends, int64_t count)
{
    write_int(packet, count);
    write_table(packet, ends, count, 2 * sizeof *ends);
}

static bool judge_edges(const struct judge *judge, const struct trial *t,
                        const struct edge_answer *answer, struct judgement *judgement)
{
    struct writer packet = writer_growing();
    write_edges(&packet, answer->ends, answer->count);
    bool accepted = judge_bytes(judge, &t->input, packet.bytes, packet.count, judgement);
    writer_release(&packet);
    return accepted;
}

static void shuffle(struct trial *t, struct edge_answer *answer)
{
    for (int64_t e = 0; e < answer->count; e++) {
        int64_t other = below(t, (int32_t)answer->count);
        swap(&answer->ends[2 * e], &answer->ends[2 * other]);
        swap(&answer->ends[2 * e + 1], &answer->ends[2 * other + 1]);
        if (below(t, 2))
            swap(&answer->ends[2 * e], &answer->ends[2 * e + 1]);
    }
}

static void mutate(struct trial *t, struct edge_answer *answer)
{
    static const int32_t odd_values[] = {-1, INT32_MIN, INT32_MAX, 0, VERTEX_LIMIT, 65536};
    int64_t at = answer->count > 0 ? below(t, (int32_t)answer->count) : 0;
    int32_t *entry = answer->ends + 2 * at, *end = answer->ends + 2 * answer->count;
    bool has_room = answer->count < ENTRY_LIMIT;
    switch (below(t, 6)) {
    case 0: /* an entry goes */
        if (answer->count > 0) {
            memmove(entry, entry + 2, sizeof *entry * (size_t)(end - entry - 2));
            answer->count--;
        }
        break;
    case 1: /* one comes again, perhaps reversed */
        if (answer->count > 0 && has_room) {
            int turned = below(t, 2);
            end[0] = entry[turned];
            end[1] = entry[1 - turned];
            answer->count++;
        }
        break;
    case 2: /* some pair comes */
        if (has_room) {
            end[0] = below(t, t->vertex_count);
            end[1] = below(t, t->vertex_count);
            answer->count++;
        }
        break;
    case 3: /* one end changes */
        if (answer->count > 0)
            entry[below(t, 2)] = below(t, t->vertex_count);
        break;
    case 4: /* ... to something that no vertex has */
        if (answer->count > 0)
            entry[below(t, 2)] = odd_values[below(t, 6)];
        break;
    default: /* nothing: right answers stay right */
        break;
    }
}

/* ---------------------------------------------------------------------------------------- tests */

static void right_tables_are_accepted_in_any_order(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < ROUNDS; seed++) {
        struct trial t;
        struct judgement judgement;
        trial_begin(&t, seed);
        shuffle(&t, &t.right);
        assert_true(judge_edges(&judge_edge_table_any, &t, &t.right, &judgement));
        writer_release(&t.input);
    }
}

static void changed_tables_are_judged_like_the_oracle(void **state)
{
    (void)state;
    int accepted = 0;
    for (uint64_t seed = 0; seed < ROUNDS; seed++) {
        struct trial t;
        struct judgement judgement;
        trial_begin(&t, seed);
        struct edge_answer answer = t.right;
        shuffle(&t, &answer);
        for (int changes = 1 + below(&t, 3); changes > 0; changes--)
            mutate(&t, &answer);
        bool expected = oracle_accepts(&t, &answer);
        assert_int_equal(judge_edges(&judge_edge_table_any, &t, &answer, &judgement), expected);
        accepted += expected;
        writer_release(&t.input);
    }
    assert_in_range(accepted, ROUNDS / 20, ROUNDS / 2); /* both verdicts were tried */
}

static void any_bytes_are_survived(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < ROUNDS; seed++) {
        struct trial t;
        struct judgement judgement;
        trial_begin(&t, seed);
        if (t.right.count == 0) {
            writer_release(&t.input);
            continue;
        }
        struct writer packet = writer_growing();
        write_edges(&packet, t.right.ends, t.right.count);
        size_t kept = (size_t)below(&t, (int32_t)packet.count); /* cut short: never right */
        assert_false(judge_bytes(&judge_edge_table_any, &t.input, packet.bytes, kept, &judgement));
        for (size_t i = 0; i < packet.count; i++)
            if (below(&t, 4) == 0)
                packet.bytes[i] = (unsigned char)below(&t, 256);
        judge_bytes(&judge_edge_table_any, &t.input, packet.bytes, packet.count, &judgement);
        writer_release(&packet);
        writer_release(&t.input);
    }
}

static void check_cause(const struct edge_answer *answer, const char *cause, const char *element,
                        const char *in_message)
{
    const struct judge_case fan = {.name = "fan", .mesh = {SHAPE_FAN, .count = 3}};
    struct trial t;
    struct judgement judgement;
    t.input = writer_growing();
    assert_int_equal(judge_make(&judge_edge_table_any, &fan, NULL, &t.input, NULL), 0);
    judge_edges(&judge_edge_table_any, &t, answer, &judgement);
    assert_string_equal(judgement.cause, cause);
    assert_string_equal(judgement.element.en, element);
    if (!strstr(judgement.message.en, in_message))
        fail_msg("\"%s\" does not say \"%s\"", judgement.message.en, in_message);
    writer_release(&t.input);
}

/* Triangles (0,1,2), (0,2,3), (0,3,4): edges 01 02 03 04 12 23 34. */
static void the_first_element_at_fault_is_named(void **state)
{
    (void)state;
    struct edge_answer twice = {{0, 1, 2, 0, 0, 3, 4, 0, 1, 2, 2, 3, 3, 4, 3, 2, 1, 0}, 9};
    check_cause(&twice, "duplicate-edge", "edge 7 (3,2)",
                "edge 7 (3,2) is listed twice (also as entry 5)");
    struct edge_answer extra = {{0, 1, 0, 2, 1, 3, 0, 3, 0, 4, 1, 2, 2, 3, 3, 4}, 8};
    check_cause(&extra, "extra-edge", "edge 2 (1,3)", "edge 2 (1,3) is no edge of the mesh");
    struct edge_answer missing = {{0, 1, 0, 2, 1, 2, 0, 3, 0, 4, 3, 4}, 6};
    check_cause(&missing, "missing-edge", "edge {2,3}", "edge {2,3} of triangle 1 is missing");
    struct edge_answer boundary = {{0, 2, 0, 3}, 2};
    check_cause(&boundary, "missing-edge", "edge {0,1}", "Boundary edges are lost");
    struct edge_answer self = {{0, 1, 2, 2}, 2};
    check_cause(&self, "self-edge", "edge 1 (2,2)", "joins a vertex to itself");
    struct edge_answer range = {{0, 1, 2, 5}, 2};
    check_cause(&range, "index-out-of-range", "edge 1 (2,5)", "counting from 1");
    struct edge_answer sides = {{0, 1, 1, 2, 2, 0, 0, 2, 2, 3, 3, 0, 0, 3, 3, 4, 4, 0}, 9};
    check_cause(&sides, "duplicate-edge", "edge 3 (0,2)", "listed as (i,j) and as (j,i)");
    struct edge_answer empty = {{0}, 0};
    check_cause(&empty, "missing-edge", "edge {0,1}", "The table is empty");
}

static void an_empty_table_of_boundary_edges_is_explained(void **state)
{
    (void)state;
    const struct judge_case one = {.name = "one", .mesh = {SHAPE_ONE_TRIANGLE}};
    struct writer input = writer_growing();
    struct judgement judgement;
    int64_t packet[3] = {0, 0, 0};
    assert_int_equal(judge_make(&judge_edge_table_any, &one, NULL, &input, NULL), 0);
    assert_false(judge_bytes(&judge_edge_table_any, &input, packet, sizeof packet, &judgement));
    assert_non_null(strstr(judgement.message.en, "an edge with only one triangle counts too"));
    writer_release(&input);
}

/* A missing edge tells of the last triangle only when it has a triangle to stand beside. */
static void an_edge_of_the_only_triangle_says_nothing_of_the_last(void **state)
{
    (void)state;
    const struct judge_case one = {.name = "one", .mesh = {SHAPE_ONE_TRIANGLE}};
    struct writer input = writer_growing(), packet = writer_growing();
    struct judgement judgement;
    const int32_t two[] = {0, 1, 1, 2};
    assert_int_equal(judge_make(&judge_edge_table_any, &one, NULL, &input, NULL), 0);
    write_edges(&packet, two, 2);
    assert_false(
        judge_bytes(&judge_edge_table_any, &input, packet.bytes, packet.count, &judgement));
    assert_non_null(strstr(judgement.message.en, "edge {0,2} of triangle 0 is missing"));
    assert_null(strstr(judgement.message.en, "last triangle"));
    writer_release(&packet);
    writer_release(&input);
    /* Edge {3,4} alone, of the fan's last triangle; its other edge, {0,4}, is there. */
    struct edge_answer boundary = {{0, 1, 0, 2, 1, 2, 0, 3, 2, 3, 0, 4}, 6};
    check_cause(&boundary, "missing-edge", "edge {3,4}",
                "1 of 7 edges is missing. Boundary edges are lost");
    struct edge_answer last = {{0, 1, 0, 2, 1, 2, 0, 3, 2, 3}, 5};
    check_cause(&last, "missing-edge", "edge {0,4}", "Only edges of the last triangle are lost");
}

static void wild_counts_are_claims(void **state)
{
    (void)state;
    static const int64_t counts[] = {-1, -2, INT64_MIN, INT64_MAX, INT32_MAX, 1000, 5};
    const struct judge_case fan = {.name = "fan", .mesh = {SHAPE_FAN, .count = 3}};
    struct writer input = writer_growing();
    struct judgement judgement;
    assert_int_equal(judge_make(&judge_edge_table_any, &fan, NULL, &input, NULL), 0);
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        int64_t packet[3] = {counts[i], counts[i], 0};
        assert_false(judge_bytes(&judge_edge_table_any, &input, packet, sizeof packet, &judgement));
        assert_string_equal(judgement.cause, counts[i] == 5 ? "no-table" : "impossible-count");
    }
    writer_release(&input);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(right_tables_are_accepted_in_any_order),
        cmocka_unit_test(changed_tables_are_judged_like_the_oracle),
        cmocka_unit_test(any_bytes_are_survived),
        cmocka_unit_test(the_first_element_at_fault_is_named),
        cmocka_unit_test(an_empty_table_of_boundary_edges_is_explained),
        cmocka_unit_test(an_edge_of_the_only_triangle_says_nothing_of_the_last),
        cmocka_unit_test(wild_counts_are_claims),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
