/* Matching rows; see set_fault.h. */
#include "graders/library/set_fault.h"

#include "graders/library/sorting.h"

#include <inttypes.h>
#include <stdlib.h>

const struct cause set_missing = {"missing-entry", {"missing entry", "falta una entrada"}};
const struct cause set_extra = {"extra-entry", {"extra entry", "sobra una entrada"}};
const struct cause set_repeated = {"repeated-entry", {"repeated entry", "entrada repetida"}};
const struct cause set_reversed = {"reversed-entry", {"reversed entry", "entrada al revés"}};

bool set_fault_found(const struct set_fault *fault)
{
    return set_fault_cause(fault) != NULL;
}

const struct cause *set_fault_cause(const struct set_fault *fault)
{
    if (fault->repeated_count)
        return &set_repeated;
    if (fault->extra_count)
        return &set_extra;
    if (fault->reversed_count)
        return &set_reversed;
    return fault->missing_count ? &set_missing : NULL;
}

void set_fault_release(struct set_fault *fault)
{
    free(fault->entry_marks);
    free(fault->right_marks);
    *fault = (struct set_fault){0};
}

int set_rows_init(struct set_rows *rows, int64_t entry_count, int64_t right_count,
                  int64_t value_count, struct error *err)
{
    *rows = (struct set_rows){.entry_count = entry_count, .right_count = right_count};
    int64_t row_count;
    if (entry_count < 0 || right_count < 0 || value_count < 0 ||
        __builtin_add_overflow(entry_count, right_count, &row_count) || row_count == INT64_MAX)
        return error_set(err,
                         "%" PRId64 " entries and %" PRId64 " right rows cannot be compared: "
                         "check the counts of the answer first",
                         entry_count, right_count);
    rows->values = calloc((size_t)value_count + 1, sizeof *rows->values);
    rows->first = calloc((size_t)row_count + 1, sizeof *rows->first);
    if (rows->values && rows->first)
        return 0;
    set_rows_release(rows);
    return error_set(err, "out of memory: comparing %" PRId64 " rows", row_count);
}

void set_rows_release(struct set_rows *rows)
{
    free(rows->values);
    free(rows->first);
    *rows = (struct set_rows){0};
}

static int compare_rows(int64_t a, int64_t b, const void *context)
{
    const struct set_rows *rows = context;
    int64_t length = rows->first[a + 1] - rows->first[a];
    int64_t other_length = rows->first[b + 1] - rows->first[b];
    if (length != other_length)
        return length < other_length ? -1 : 1;
    const int32_t *values = rows->values + rows->first[a];
    const int32_t *others = rows->values + rows->first[b];
    for (int64_t i = 0; i < length; i++)
        if (values[i] != others[i])
            return values[i] < others[i] ? -1 : 1;
    return 0;
}

/* Entries and right rows that are all equal, each kind by its number; together in `order`. */
struct group {
    const int64_t *entries, *right;
    int64_t entry_count, right_count;
};

/* The group that starts at order[start]. */
static struct group group_at(const struct set_rows *rows, const int64_t *order, int64_t count,
                             int64_t start)
{
    struct group group = {.entries = order + start};
    int64_t end = start;
    while (end < count && compare_rows(order[start], order[end], rows) == 0)
        group.entry_count += order[end++] < rows->entry_count;
    group.right = group.entries + group.entry_count;
    group.right_count = end - start - group.entry_count;
    return group;
}

static int64_t matched_count(const struct group *group)
{
    return group->entry_count < group->right_count ? group->entry_count : group->right_count;
}

static void mark_group(const struct set_rows *rows, const struct group *group,
                       struct set_fault *fault)
{
    int64_t matched = matched_count(group);
    for (int64_t i = matched; i < group->entry_count; i++)
        fault->entry_marks[group->entries[i]] = group->right_count ? SET_REPEATED : SET_EXTRA;
    for (int64_t i = matched; i < group->right_count; i++)
        fault->right_marks[group->right[i] - rows->entry_count] = SET_MISSING;
    bool has_repeated = group->right_count > 0 && matched < group->entry_count;
    if (has_repeated && (fault->repeated < 0 || group->entries[matched] < fault->repeated)) {
        fault->repeated = group->entries[matched];
        fault->repeated_of = group->entries[0];
    }
}

/* A group of extra entries, turned, and missing rows. */
static void mark_reversed(const struct set_rows *rows, const struct group *group,
                          struct set_fault *fault)
{
    int64_t matched = matched_count(group);
    for (int64_t i = 0; i < matched; i++) {
        int64_t right = group->right[i] - rows->entry_count;
        fault->entry_marks[group->entries[i]] = SET_REVERSED;
        fault->right_marks[right] = SET_REVERSED;
        if (fault->reversed < 0 || group->entries[i] < fault->reversed) {
            fault->reversed = group->entries[i];
            fault->reversed_right = right;
        }
    }
}

/* Sorts the rows in `order` and marks each group of equal ones. */
static void mark_groups(const struct set_rows *rows, int64_t *order, int64_t *spare, int64_t count,
                        void (*mark)(const struct set_rows *, const struct group *,
                                     struct set_fault *),
                        struct set_fault *fault)
{
    sort_order(order, spare, count, compare_rows, rows);
    for (int64_t i = 0; i < count;) {
        struct group group = group_at(rows, order, count, i);
        mark(rows, &group, fault);
        i += group.entry_count + group.right_count;
    }
}

/* The rows at fault but for repeated ones, those of the answer turned. Returns how many. */
static int64_t collect_turned(struct set_rows *rows, const struct set_fault *fault,
                              void (*turn)(int32_t *, int64_t), int64_t *order)
{
    int64_t count = 0;
    for (int64_t i = 0; i < rows->entry_count; i++)
        if (fault->entry_marks[i] == SET_EXTRA) {
            turn(rows->values + rows->first[i], rows->first[i + 1] - rows->first[i]);
            order[count++] = i;
        }
    for (int64_t i = 0; i < rows->right_count; i++)
        if (fault->right_marks[i] == SET_MISSING)
            order[count++] = rows->entry_count + i;
    return count;
}

/* How many have a mark; *first becomes the first of them. */
static int64_t count_marks(const uint8_t *marks, int64_t count, enum set_mark mark, int64_t *first)
{
    int64_t found = 0;
    *first = -1;
    for (int64_t i = 0; i < count; i++)
        if (marks[i] == mark && found++ == 0)
            *first = i;
    return found;
}

static void count_faults(const struct set_rows *rows, struct set_fault *fault)
{
    int64_t first;
    fault->missing_count =
        count_marks(fault->right_marks, rows->right_count, SET_MISSING, &fault->missing);
    fault->extra_count =
        count_marks(fault->entry_marks, rows->entry_count, SET_EXTRA, &fault->extra);
    fault->repeated_count =
        count_marks(fault->entry_marks, rows->entry_count, SET_REPEATED, &first);
    fault->reversed_count =
        count_marks(fault->entry_marks, rows->entry_count, SET_REVERSED, &first);
}

int set_rows_match(struct set_rows *rows, void (*turn)(int32_t *row, int64_t length),
                   struct set_fault *fault, struct error *err)
{
    int64_t count = rows->entry_count + rows->right_count;
    int64_t *order = calloc((size_t)count + 1, sizeof *order);
    int64_t *spare = calloc((size_t)count + 1, sizeof *spare);
    *fault = (struct set_fault){.missing = -1,
                                .extra = -1,
                                .repeated = -1,
                                .repeated_of = -1,
                                .reversed = -1,
                                .reversed_right = -1,
                                .entry_marks = calloc((size_t)rows->entry_count + 1, 1),
                                .right_marks = calloc((size_t)rows->right_count + 1, 1)};
    bool has_memory = order && spare && fault->entry_marks && fault->right_marks;
    if (has_memory) {
        for (int64_t i = 0; i < count; i++)
            order[i] = i;
        mark_groups(rows, order, spare, count, mark_group, fault);
        if (turn) {
            count = collect_turned(rows, fault, turn, order);
            mark_groups(rows, order, spare, count, mark_reversed, fault);
        }
        count_faults(rows, fault);
    } else {
        set_fault_release(fault);
    }
    free(order);
    free(spare);
    return has_memory ? 0 : error_set(err, "out of memory: comparing %" PRId64 " rows", count);
}
