/* Comparing sets of cyclic sequences; see cycles.h. */
#include "graders/library/cycles.h"

#include "graders/library/sorting.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

/* -------------------------------------------------------------------------------- single cycles */

int64_t cyclic_least(const int32_t *row, int64_t n)
{
    int64_t best = 0, other = 1, same = 0; /* both candidates agree over `same` numbers */
    while (other < n && best < n && same < n) {
        int32_t a = row[(best + same) % n], b = row[(other + same) % n];
        if (a == b) {
            same++;
            continue;
        }
        if (a > b)
            best += same + 1;
        else
            other += same + 1;
        if (best == other)
            other++;
        same = 0;
    }
    return best < other ? best : other;
}

void cyclic_reverse(int32_t *row, int64_t n)
{
    for (int64_t i = 0, j = n - 1; i < j; i++, j--) {
        int32_t value = row[i];
        row[i] = row[j];
        row[j] = value;
    }
}

int64_t cyclic_canonical(int32_t *row, int64_t n)
{
    int64_t least = cyclic_least(row, n);
    cyclic_reverse(row, least);
    cyclic_reverse(row + least, n - least);
    cyclic_reverse(row, n);
    return least;
}

bool cyclic_equal(const int32_t *a, const int32_t *b, int64_t n, int64_t *shift)
{
    int64_t least_a = cyclic_least(a, n), least_b = cyclic_least(b, n);
    for (int64_t i = 0; i < n; i++)
        if (a[(least_a + i) % n] != b[(least_b + i) % n])
            return false;
    if (shift)
        *shift = n > 0 ? (least_b - least_a + n) % n : 0;
    return true;
}

static void reverse_cycle(int32_t *row, int64_t n)
{
    cyclic_reverse(row, n);
    cyclic_canonical(row, n);
}

/* ---------------------------------------------------------------------------------- whole tables
 */

/* The first offset that cannot be, or -1. */
static int64_t malformed_offset(const struct cycle_rows *rows)
{
    if (rows->count == 0)
        return -1;
    for (int64_t r = 0; r <= rows->count; r++) {
        int32_t least = r == 0 ? 0 : rows->first[r - 1];
        if (rows->first[r] < least || rows->first[r] > rows->value_count)
            return r;
    }
    return -1;
}

static int64_t row_length(const struct cycle_rows *rows, int64_t r)
{
    return (int64_t)rows->first[r + 1] - rows->first[r];
}

static const int32_t *row_values(const struct cycle_rows *rows, int64_t r)
{
    return rows->values + rows->first[r];
}

static int64_t total_length(const struct cycle_rows *rows)
{
    return rows->count > 0 ? (int64_t)rows->first[rows->count] - rows->first[0] : 0;
}

/* Copies rows behind those that are there already, each in its form. */
static void append_rows(struct set_rows *to, int64_t at, const struct cycle_rows *from,
                        bool is_cyclic)
{
    for (int64_t r = 0; r < from->count; r++, at++) {
        int64_t length = row_length(from, r);
        to->first[at + 1] = to->first[at] + length;
        if (length > 0)
            memcpy(to->values + to->first[at], row_values(from, r),
                   (size_t)length * sizeof *to->values);
        if (is_cyclic)
            cyclic_canonical(to->values + to->first[at], length);
    }
}

/* ------------------------------------------------------------------------- the nearest right row
 */

/* One row, followed around, or to its end. */
struct walk {
    const int32_t *values;
    int64_t length, start;
    bool is_cyclic;
};

static int32_t walk_at(const struct walk *walk, int64_t step)
{
    return walk->length > 0 ? walk->values[(walk->start + step) % walk->length] : 0;
}

static int64_t step_count(const struct walk *walk)
{
    return walk->is_cyclic || walk->length == 0 ? walk->length : walk->length - 1;
}

/* The step from a number to the next one of its row, as one number. */
static uint64_t step_word(const struct walk *walk, int64_t i)
{
    return (uint64_t)(uint32_t)walk->values[i] << 32 |
           (uint32_t)walk->values[(i + 1) % walk->length];
}

/* The place of the first word that is not below the given one. */
static int64_t lower_bound(const uint64_t *words, int64_t count, uint64_t word)
{
    int64_t first = 0, last = count;
    while (first < last) {
        int64_t middle = first + (last - first) / 2;
        if (words[middle] < word)
            first = middle + 1;
        else
            last = middle;
    }
    return first;
}

/* The missing row that has the most steps of the given one; the first of several. */
static int64_t nearest_row(const struct walk *entry, const struct cycle_rows *right,
                           const uint8_t *right_marks, uint64_t *words, uint64_t *spare)
{
    int64_t word_count = step_count(entry), nearest = -1, most = -1;
    for (int64_t i = 0; i < word_count; i++)
        words[i] = step_word(entry, i);
    sort_words(words, spare, word_count);
    for (int64_t r = 0; r < right->count; r++) {
        if (right_marks[r] != SET_MISSING)
            continue;
        struct walk row = {row_values(right, r), row_length(right, r), 0, entry->is_cyclic};
        int64_t common = 0;
        for (int64_t i = 0; i < step_count(&row); i++) {
            uint64_t word = step_word(&row, i);
            int64_t at = lower_bound(words, word_count, word);
            common += at < word_count && words[at] == word;
        }
        if (common > most) {
            most = common;
            nearest = r;
        }
    }
    return nearest;
}

/* The places in a row of what stands there, by number: word = number, place. */
static void index_places(const struct walk *row, uint64_t *words, uint64_t *spare)
{
    for (int64_t i = 0; i < row->length; i++)
        words[i] = (uint64_t)(uint32_t)row->values[i] << 32 | (uint64_t)i;
    sort_words(words, spare, row->length);
}

/* The first place of a number, or -1. */
static int64_t place_of(const uint64_t *words, int64_t count, int32_t value)
{
    uint64_t word = (uint64_t)(uint32_t)value << 32;
    int64_t at = lower_bound(words, count, word);
    return at < count && words[at] >> 32 == word >> 32 ? (int64_t)(words[at] & UINT32_MAX) : -1;
}

/* Whether the step from place i of a leads where the same step leads in b. */
static bool agrees(const struct walk *a, const struct walk *b, const uint64_t *places, int64_t i)
{
    int64_t at = place_of(places, b->length, a->values[i]);
    int64_t next = place_of(places, b->length, a->values[(i + 1) % a->length]);
    return at >= 0 && next == (at + 1) % b->length;
}

/* Starts both cycles where their longest common stretch begins. Returns whether they have any
 * number in common. */
static bool align(struct walk *a, struct walk *b, uint64_t *places, uint64_t *spare)
{
    index_places(b, places, spare);
    int64_t best_start = 0, best_run = 0, run = 0;
    for (int64_t i = 0; i < 2 * a->length && run < a->length; i++) {
        run = agrees(a, b, places, i % a->length) ? run + 1 : 0;
        if (run > best_run) {
            best_run = run;
            best_start = i + 1 - run;
        }
    }
    a->start = best_start % (a->length > 0 ? a->length : 1);
    while (best_run == 0 && a->start < a->length &&
           place_of(places, b->length, a->values[a->start]) < 0)
        a->start++;
    if (a->start == a->length)
        return false;
    b->start = place_of(places, b->length, a->values[a->start]);
    return true;
}

/* Follows both rows until they differ or one is complete. They are not equal, so that one of these
 * happens: cycles may agree all around when one runs round several times. */
static void follow(const struct walk *a, const struct walk *b, struct cycle_step *step)
{
    int64_t longest = a->length > b->length ? a->length : b->length;
    int64_t shortest = a->length < b->length ? a->length : b->length;
    int64_t end = a->is_cyclic && shortest > 0 ? longest : shortest;
    int64_t k = 0;
    while (k < end && walk_at(a, k) == walk_at(b, k))
        k++;
    if (k == end) {
        k = shortest;
        step->end = a->length < b->length ? CYCLE_ANSWER_ENDS : CYCLE_ANSWER_GOES_ON;
    }
    bool is_over = step->end == CYCLE_ANSWER_ENDS;
    step->place = a->length == 0 ? 0 : (a->start + k + a->length - is_over) % a->length;
    step->has_before = k > 0;
    if (k > 0)
        step->before = walk_at(a, k - 1);
    if (!is_over)
        step->found = walk_at(a, k);
    if (step->end != CYCLE_ANSWER_GOES_ON)
        step->wanted = walk_at(b, k);
}

static int find_step(const struct cycle_rows *answer, const struct cycle_rows *right,
                     bool is_cyclic, struct cycle_fault *fault, struct error *err)
{
    int64_t entry = fault->set.extra;
    if (entry < 0 || fault->set.missing < 0)
        return 0;
    size_t room = (size_t)(total_length(right) + row_length(answer, entry)) + 1;
    uint64_t *words = calloc(room, sizeof *words);
    uint64_t *spare = calloc(room, sizeof *spare);
    if (words && spare) {
        struct walk a = {row_values(answer, entry), row_length(answer, entry), 0, is_cyclic};
        int64_t nearest = nearest_row(&a, right, fault->set.right_marks, words, spare);
        struct walk b = {row_values(right, nearest), row_length(right, nearest), 0, is_cyclic};
        fault->step.entry = entry;
        fault->step.right = nearest;
        if (!is_cyclic || a.length == 0 || b.length == 0 || align(&a, &b, words, spare))
            follow(&a, &b, &fault->step);
        else
            fault->step.end = CYCLE_NOTHING_SHARED;
    }
    bool has_memory = words && spare;
    free(words);
    free(spare);
    return has_memory ? 0 : error_set(err, "out of memory: following a row of the answer");
}

/* ------------------------------------------------------------------------------------ comparing */

static int compare(const struct cycle_rows *answer, const struct cycle_rows *right, bool is_cyclic,
                   struct cycle_fault *fault, struct error *err)
{
    *fault = (struct cycle_fault){.malformed = -1, .step = {.entry = -1, .right = -1}};
    if (answer->count < 0 || right->count < 0 || (answer->count > 0 && !answer->first) ||
        (right->count > 0 && !right->first))
        return error_set(err, "rows without a table of offsets: look at that before comparing");
    if (malformed_offset(right) >= 0)
        return error_set(err, "offset %" PRId64 " of the right rows is malformed",
                         malformed_offset(right));
    fault->malformed = malformed_offset(answer);
    if (fault->malformed >= 0)
        return 0;
    struct set_rows rows;
    if (set_rows_init(&rows, answer->count, right->count,
                      total_length(answer) + total_length(right), err))
        return -1;
    append_rows(&rows, 0, answer, is_cyclic);
    append_rows(&rows, answer->count, right, is_cyclic);
    int failed =
        set_rows_match(&rows, is_cyclic ? reverse_cycle : cyclic_reverse, &fault->set, err);
    set_rows_release(&rows);
    if (!failed && find_step(answer, right, is_cyclic, fault, err)) {
        cycle_fault_release(fault);
        failed = -1;
    }
    return failed;
}

int cycles_compare(const struct cycle_rows *answer, const struct cycle_rows *right,
                   struct cycle_fault *fault, struct error *err)
{
    return compare(answer, right, true, fault, err);
}

int sequences_compare(const struct cycle_rows *answer, const struct cycle_rows *right,
                      struct cycle_fault *fault, struct error *err)
{
    return compare(answer, right, false, fault, err);
}

void cycle_fault_release(struct cycle_fault *fault)
{
    set_fault_release(&fault->set);
}

void cycle_step_say(const struct cycle_step *step, struct message *message)
{
    message_clear(message);
    if (step->entry < 0)
        return;
    if (step->end == CYCLE_NOTHING_SHARED)
        message_say(message, "It has nothing in common with what is missing.",
                    "No tiene nada en común con lo que falta.");
    else if (step->end == CYCLE_ANSWER_ENDS && !step->has_before)
        message_say(message, "It is empty.", "Está vacía.");
    else if (step->end == CYCLE_ANSWER_ENDS)
        message_say(message, "It ends after %" PRId32 "; right is %" PRId32 " next.",
                    "Acaba después de %" PRId32 "; lo correcto es seguir con %" PRId32 ".",
                    step->before, step->wanted);
    else if (step->end == CYCLE_ANSWER_GOES_ON && !step->has_before)
        message_say(message, "It begins with %" PRId32 "; right is nothing at all.",
                    "Empieza con %" PRId32 "; lo correcto es no tener nada.", step->found);
    else if (step->end == CYCLE_ANSWER_GOES_ON)
        message_say(message, "It should end after %" PRId32 ", but goes on with %" PRId32 ".",
                    "Debería acabar después de %" PRId32 ", pero sigue con %" PRId32 ".",
                    step->before, step->found);
    else if (!step->has_before)
        message_say(message, "It begins with %" PRId32 "; right is %" PRId32 ".",
                    "Empieza con %" PRId32 "; lo correcto es %" PRId32 ".", step->found,
                    step->wanted);
    else
        message_say(message, "After %" PRId32 " comes %" PRId32 "; right is %" PRId32 ".",
                    "Después de %" PRId32 " viene %" PRId32 "; lo correcto es %" PRId32 ".",
                    step->before, step->found, step->wanted);
}
