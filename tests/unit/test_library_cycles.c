/* Sets of cycles: what is told, the first step that differs, and random rows against slow ones. */
#include "graders/library/cycles.h"
#include "reference/base/random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MOST_ROWS = 6, MOST_LENGTH = 7, ROOM = MOST_ROWS * MOST_LENGTH };

struct table {
    int32_t first[MOST_ROWS + 1], values[ROOM];
    int count;
};

static struct cycle_rows rows_of(const struct table *t)
{
    return (struct cycle_rows){t->first, t->values, t->count, t->first[t->count]};
}

static void add_row(struct table *t, int length, const int32_t *values)
{
    int32_t at = t->first[t->count];
    for (int i = 0; i < length; i++)
        t->values[at + i] = values[i];
    t->first[++t->count] = at + length;
}

#define ADD(t, ...)                                                                                \
    add_row(t, (int)(sizeof(int32_t[]){__VA_ARGS__} / sizeof(int32_t)), (int32_t[]){__VA_ARGS__})

static struct cycle_fault compare(const struct table *answer, const struct table *right)
{
    struct cycle_rows a = rows_of(answer), b = rows_of(right);
    struct cycle_fault fault;
    assert_int_equal(cycles_compare(&a, &b, &fault, NULL), 0);
    assert_int_equal(fault.malformed, -1);
    return fault;
}

static void loops_are_told_apart(void **state)
{
    (void)state;
    struct table right = {0}, answer = {0};
    ADD(&right, 0, 1, 2, 3);
    ADD(&right, 4, 5, 6);
    ADD(&right, 7, 8, 9);
    ADD(&answer, 6, 4, 5);
    ADD(&answer, 9, 8, 7);
    ADD(&answer, 5, 6, 4);
    ADD(&answer, 2, 3, 1);
    struct cycle_fault fault = compare(&answer, &right);
    assert_int_equal(fault.set.repeated, 2);
    assert_int_equal(fault.set.repeated_of, 0);
    assert_int_equal(fault.set.reversed, 1);
    assert_int_equal(fault.set.reversed_right, 2);
    assert_int_equal(fault.set.extra, 3);
    assert_int_equal(fault.set.missing, 0);
    assert_int_equal(fault.step.entry, 3);
    assert_int_equal(fault.step.right, 0);
    struct message message;
    cycle_step_say(&fault.step, &message);
    assert_string_equal(message.en, "After 3 comes 1; right is 0.");
    assert_string_equal(message.es, "Después de 3 viene 1; lo correcto es 0.");
    cycle_fault_release(&fault);
}

static void assert_step_said(struct table *answer, struct table *right, const char *text)
{
    struct cycle_fault fault = compare(answer, right);
    struct message message;
    cycle_step_say(&fault.step, &message);
    assert_string_equal(message.en, text);
    cycle_fault_release(&fault);
}

static void each_way_to_differ_has_words(void **state)
{
    (void)state;
    struct table right = {0}, twice = {0}, other = {0}, none = {0}, added = {0};
    ADD(&right, 1, 2, 3, 4);
    ADD(&twice, 2, 3, 4, 1, 2, 3, 4, 1);
    assert_step_said(&twice, &right, "It should end after 1, but goes on with 2.");
    assert_step_said(&right, &twice, "It ends after 1; right is 2 next.");
    ADD(&other, 7, 8, 9);
    assert_step_said(&other, &right, "It has nothing in common with what is missing.");
    none.count = 1;
    assert_step_said(&none, &right, "It is empty.");
    assert_step_said(&right, &none, "It begins with 1; right is nothing at all.");
    ADD(&added, 3, 4, 9, 1, 2);
    assert_step_said(&added, &right, "After 4 comes 9; right is 1.");
}

static void sequences_begin_where_they_begin(void **state)
{
    (void)state;
    struct table right = {0}, answer = {0};
    ADD(&right, 1, 2, 3);
    ADD(&right, 5, 6);
    ADD(&answer, 2, 3, 1);
    ADD(&answer, 6, 5);
    struct cycle_rows a = rows_of(&answer), b = rows_of(&right);
    struct cycle_fault fault;
    assert_int_equal(sequences_compare(&a, &b, &fault, NULL), 0);
    assert_int_equal(fault.set.extra, 0);
    assert_int_equal(fault.set.reversed, 1);
    struct message message;
    cycle_step_say(&fault.step, &message);
    assert_string_equal(message.en, "It begins with 2; right is 1.");
    cycle_fault_release(&fault);
    answer = (struct table){0};
    ADD(&answer, 1, 2);
    ADD(&answer, 5, 6);
    assert_int_equal(sequences_compare(&a, &b, &fault, NULL), 0);
    assert_int_equal(fault.step.end, CYCLE_ANSWER_ENDS);
    assert_int_equal(fault.step.wanted, 3);
    cycle_fault_release(&fault);
}

static void single_cycles(void **state)
{
    (void)state;
    int32_t row[] = {3, 1, 2, 1, 1}, other[] = {1, 1, 3, 1, 2}, wrong[] = {1, 1, 3, 2, 1};
    int64_t shift;
    assert_true(cyclic_equal(row, other, 5, &shift));
    assert_int_equal(shift, 2);
    assert_false(cyclic_equal(row, wrong, 5, NULL));
    assert_true(cyclic_equal(NULL, NULL, 0, &shift));
    assert_int_equal(cyclic_canonical(row, 5), 3);
    const int32_t least[] = {1, 1, 3, 1, 2};
    assert_memory_equal(row, least, sizeof least);
    assert_int_equal(cyclic_least(NULL, 0), 0);
}

static void malformed_offsets_are_named(void **state)
{
    (void)state;
    static const struct {
        int32_t first[4];
        int64_t at;
    } bad[] = {{{-1, 2, 4, 6}, 0}, {{0, 4, 3, 6}, 2},         {{0, 3, 6, 7}, 3},
               {{0, 9, 3, 6}, 1},  {{0, INT32_MIN, 3, 6}, 1}, {{INT32_MAX, 2, 3, 6}, 0}};
    const int32_t values[6] = {0, 1, 2, 3, 4, 5}, fine[] = {0, 3, 6};
    struct cycle_rows right = {fine, values, 2, 6};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct cycle_rows answer = {bad[i].first, values, 3, 6};
        struct cycle_fault fault;
        assert_int_equal(cycles_compare(&answer, &right, &fault, NULL), 0);
        assert_int_equal(fault.malformed, bad[i].at);
        cycle_fault_release(&fault);
        struct error err = {0};
        assert_int_equal(cycles_compare(&right, &answer, &fault, &err), -1);
        assert_non_null(strstr(err.text, "malformed"));
    }
    struct cycle_rows negative = {fine, values, -3, 6}, none = {NULL, NULL, 0, 0};
    struct cycle_fault fault;
    assert_int_equal(cycles_compare(&negative, &right, &fault, NULL), -1);
    assert_int_equal(cycles_compare(&none, &right, &fault, NULL), 0);
    assert_int_equal(fault.set.missing_count, 2);
    cycle_fault_release(&fault);
}

/* ------------------------------------------------------------------------------ the slow oracle */

static int length_of(const struct table *t, int r)
{
    return t->first[r + 1] - t->first[r];
}

static const int32_t *values_of(const struct table *t, int r)
{
    return t->values + t->first[r];
}

/* Whether two rows are one cycle, b read backwards or not. */
static bool same(const struct table *t, int a, const struct table *u, int b, bool backwards)
{
    int n = length_of(t, a);
    if (n != length_of(u, b))
        return false;
    for (int shift = 0; shift < n || shift == 0; shift++) {
        int i = 0;
        while (i < n &&
               values_of(t, a)[i] == values_of(u, b)[(shift + (backwards ? n - 1 - i : i)) % n])
            i++;
        if (i == n)
            return true;
    }
    return false;
}

static void mark_slowly(const struct table *answer, const struct table *right, uint8_t *entries,
                        uint8_t *rights)
{
    memset(rights, SET_MISSING, MOST_ROWS);
    for (int backwards = 0; backwards < 2; backwards++)
        for (int i = 0; i < answer->count; i++) {
            if (backwards && entries[i] != SET_EXTRA)
                continue;
            int r = 0;
            bool is_known = false;
            for (; r < right->count; r++) {
                bool is_same = same(answer, i, right, r, backwards);
                is_known = is_known || is_same;
                if (is_same && rights[r] == SET_MISSING)
                    break;
            }
            if (r < right->count)
                entries[i] = rights[r] = backwards ? SET_REVERSED : SET_FINE;
            else if (!backwards)
                entries[i] = is_known ? SET_REPEATED : SET_EXTRA;
        }
}

static struct table random_table(struct random *rng, uint64_t values)
{
    struct table t = {0};
    int count = (int)random_below(rng, MOST_ROWS + 1);
    while (t.count < count) {
        int32_t row[MOST_LENGTH];
        for (int i = 0; i < MOST_LENGTH; i++)
            row[i] = (int32_t)random_below(rng, values);
        add_row(&t, (int)random_below(rng, 5), row);
    }
    return t;
}

static void random_rows_are_told_as_slowly(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 21);
    for (int trial = 0; trial < 30000; trial++) {
        uint64_t values = 1 + random_below(&rng, 4);
        struct table answer = random_table(&rng, values), right = random_table(&rng, values);
        uint8_t entries[MOST_ROWS] = {0}, rights[MOST_ROWS];
        mark_slowly(&answer, &right, entries, rights);
        struct cycle_fault fault = compare(&answer, &right);
        assert_memory_equal(fault.set.entry_marks, entries, (size_t)answer.count);
        assert_memory_equal(fault.set.right_marks, rights, (size_t)right.count);
        bool has_step = fault.set.extra >= 0 && fault.set.missing >= 0;
        assert_int_equal(fault.step.entry, has_step ? fault.set.extra : -1);
        struct message message;
        cycle_step_say(&fault.step, &message);
        assert_int_equal(message.en[0] != '\0', has_step);
        cycle_fault_release(&fault);
    }
}

/* The longest stretch that two cycles of different numbers have in common, in numbers. */
static int longest_stretch(const struct table *t, int a, const struct table *u, int b)
{
    int longest = 0, n = length_of(t, a), m = length_of(u, b);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++) {
            int k = 0;
            while (k < n && k < m && values_of(t, a)[(i + k) % n] == values_of(u, b)[(j + k) % m])
                k++;
            longest = k > longest ? k : longest;
        }
    return longest;
}

static int place_of(const struct table *t, int r, int32_t value)
{
    for (int i = 0; i < length_of(t, r); i++)
        if (values_of(t, r)[i] == value)
            return i;
    return -1;
}

static int common_steps(const struct table *t, int a, const struct table *u, int b)
{
    int common = 0, n = length_of(t, a), m = length_of(u, b);
    for (int i = 0; i < n; i++) {
        int at = place_of(u, b, values_of(t, a)[i]);
        common += at >= 0 && values_of(u, b)[(at + 1) % m] == values_of(t, a)[(i + 1) % n];
    }
    return common;
}

/* A row is cut out of the right ones and one number of it added, lost or changed. */
static void the_step_follows_the_longest_stretch(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 22);
    for (int trial = 0; trial < 20000; trial++) {
        struct table right = {0}, answer = {0};
        for (int r = 0; r < 4; r++) {
            int32_t row[10];
            random_permutation(&rng, row, 10);
            add_row(&right, 3 + (int)random_below(&rng, 4), row);
        }
        int32_t row[10];
        random_permutation(&rng, row, 10);
        add_row(&answer, 3 + (int)random_below(&rng, 4), row);
        struct cycle_fault fault = compare(&answer, &right);
        const struct cycle_step *step = &fault.step;
        if (step->entry < 0) {
            cycle_fault_release(&fault);
            continue;
        }
        int best = 0;
        for (int r = 1; r < 4; r++)
            if (common_steps(&answer, 0, &right, r) > common_steps(&answer, 0, &right, best))
                best = r;
        assert_int_equal(step->right, best);
        int n = length_of(&answer, 0), m = length_of(&right, best);
        int longest = longest_stretch(&answer, 0, &right, best);
        if (longest == 0) {
            assert_int_equal(step->end, CYCLE_NOTHING_SHARED);
        } else {
            assert_int_equal(step->end, CYCLE_STEP_DIFFERS);
            assert_int_not_equal(step->found, step->wanted);
            assert_int_equal(step->found, values_of(&answer, 0)[step->place]);
            assert_int_equal(step->before, values_of(&answer, 0)[(step->place + n - 1) % n]);
            int at = place_of(&right, best, step->before), run = 0;
            assert_int_equal(step->wanted, values_of(&right, best)[(at + 1) % m]);
            while (values_of(&answer, 0)[(step->place + 2 * n - 1 - run) % n] ==
                   values_of(&right, best)[(at + 2 * m - run) % m])
                run++;
            assert_true(run >= longest);
        }
        cycle_fault_release(&fault);
    }
}

static void canonical_rows_are_least(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 23);
    for (int trial = 0; trial < 50000; trial++) {
        int32_t row[8], turned[8];
        int n = 1 + (int)random_below(&rng, 8);
        uint64_t values = 1 + random_below(&rng, 3);
        for (int i = 0; i < n; i++)
            row[i] = (int32_t)random_below(&rng, values) - 1;
        int best = 0;
        for (int i = 1; i < n; i++) {
            int k = 0;
            while (k < n && row[(i + k) % n] == row[(best + k) % n])
                k++;
            if (k < n && row[(i + k) % n] < row[(best + k) % n])
                best = i;
        }
        assert_int_equal(cyclic_least(row, n), best);
        memcpy(turned, row, sizeof row);
        cyclic_canonical(turned, n);
        for (int i = 0; i < n; i++)
            assert_int_equal(turned[i], row[(best + i) % n]);
        int64_t shift;
        assert_true(cyclic_equal(row, turned, n, &shift));
        for (int i = 0; i < n; i++)
            assert_int_equal(row[i], turned[(i + shift) % n]);
    }
}

/* A long row of equal numbers and one other: quadratic methods would not end. */
static void long_rows_are_no_trouble(void **state)
{
    (void)state;
    enum { COUNT = 300000 };
    int32_t *a = calloc(COUNT, sizeof *a), *b = calloc(COUNT, sizeof *b);
    assert_true(a && b);
    a[COUNT - 1] = b[7] = -1;
    const int32_t first[] = {0, COUNT};
    struct cycle_rows answer = {first, a, 1, COUNT}, right = {first, b, 1, COUNT};
    struct cycle_fault fault;
    assert_int_equal(cycles_compare(&answer, &right, &fault, NULL), 0);
    assert_false(set_fault_found(&fault.set));
    cycle_fault_release(&fault);
    a[5] = -2;
    assert_int_equal(cycles_compare(&answer, &right, &fault, NULL), 0);
    assert_int_equal(fault.set.extra, 0);
    cycle_fault_release(&fault);
    free(a);
    free(b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loops_are_told_apart),
        cmocka_unit_test(each_way_to_differ_has_words),
        cmocka_unit_test(sequences_begin_where_they_begin),
        cmocka_unit_test(single_cycles),
        cmocka_unit_test(malformed_offsets_are_named),
        cmocka_unit_test(random_rows_are_told_as_slowly),
        cmocka_unit_test(the_step_follows_the_longest_stretch),
        cmocka_unit_test(canonical_rows_are_least),
        cmocka_unit_test(long_rows_are_no_trouble),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
