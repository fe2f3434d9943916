/* Comparing labellings up to names; see partition.h. */
#include "graders/library/partition.h"

#include "graders/library/sorting.h"

#include <inttypes.h>
#include <stdlib.h>

const struct cause partition_out_of_range = {"label-out-of-range",
                                             {"label out of range", "etiqueta fuera de rango"}};
const struct cause partition_unlabelled = {"no-label", {"no label", "falta una etiqueta"}};
const struct cause partition_labelled = {"needless-label",
                                         {"needless label", "sobra una etiqueta"}};
const struct cause partition_joined = {"wrongly-joined",
                                       {"joined, but must be apart", "juntos sin deber estarlo"}};
const struct cause partition_apart = {
    "wrongly-apart", {"apart, but must be together", "separados sin deber estarlo"}};
const struct cause partition_gap = {"unused-label", {"unused label", "etiqueta sin usar"}};

const struct cause *partition_fault_cause(const struct partition_fault *fault)
{
    if (fault->out_of_range_count)
        return &partition_out_of_range;
    if (fault->unlabelled_count)
        return &partition_unlabelled;
    if (fault->labelled_count)
        return &partition_labelled;
    if (fault->joined_count)
        return &partition_joined;
    if (fault->apart_count)
        return &partition_apart;
    return fault->gap_count ? &partition_gap : NULL;
}

void partition_fault_release(struct partition_fault *fault)
{
    free(fault->marks);
    *fault = (struct partition_fault){0};
}

static void note(struct partition_fault *fault, int64_t thing, enum partition_mark mark,
                 int64_t *first, int64_t *count)
{
    fault->marks[thing] = (uint8_t)mark;
    if ((*count)++ == 0)
        *first = thing;
}

/* Marks what can be told from a single label. */
static void look_at_labels(const int32_t *answer, const int32_t *right, int64_t count,
                           int64_t label_count, struct partition_fault *fault)
{
    for (int64_t i = 0; i < count; i++) {
        bool in_range = label_count < 0 || answer[i] < label_count;
        if (answer[i] < PARTITION_NONE || !in_range)
            note(fault, i, PARTITION_OUT_OF_RANGE, &fault->out_of_range,
                 &fault->out_of_range_count);
        else if (answer[i] == PARTITION_NONE && right[i] >= 0)
            note(fault, i, PARTITION_UNLABELLED, &fault->unlabelled, &fault->unlabelled_count);
        else if (answer[i] != PARTITION_NONE && right[i] < 0)
            note(fault, i, PARTITION_LABELLED, &fault->labelled, &fault->labelled_count);
    }
}

/* For each thing that has a good label, the first thing with the same label: leader[i]; -1 for
 * others. Returns how many labels there are. */
static int64_t find_leaders(const int32_t *labels, const uint8_t *marks, int64_t count,
                            int32_t *leader, uint64_t *words, uint64_t *spare)
{
    int64_t word_count = 0, label_count = 0;
    for (int64_t i = 0; i < count; i++) {
        leader[i] = -1;
        if (labels[i] >= 0 && (!marks || marks[i] == PARTITION_FINE))
            words[word_count++] = (uint64_t)(uint32_t)labels[i] << 32 | (uint64_t)i;
    }
    sort_words(words, spare, word_count);
    int32_t first = -1;
    for (int64_t i = 0; i < word_count; i++) {
        int32_t thing = (int32_t)(words[i] & UINT32_MAX);
        if (i == 0 || words[i] >> 32 != words[i - 1] >> 32) {
            first = thing;
            label_count++;
        }
        leader[thing] = first;
    }
    return label_count;
}

/* A thing disagrees with the first of its label, or with the first of its group, when these belong
 * to others. Things that are not fine are left out of both. */
static void look_at_pairs(const int32_t *right, int64_t count, const int32_t *label_leader,
                          const int32_t *group_leader, struct partition_fault *fault)
{
    for (int64_t i = 0; i < count; i++) {
        if (label_leader[i] < 0)
            continue;
        bool is_apart = label_leader[group_leader[i]] != label_leader[i];
        if (is_apart) {
            if (fault->apart_count == 0)
                fault->apart_from = group_leader[i];
            note(fault, i, PARTITION_APART, &fault->apart, &fault->apart_count);
        }
        if (right[label_leader[i]] != right[i]) {
            if (fault->joined_count == 0)
                fault->joined_with = label_leader[i];
            note(fault, i, PARTITION_JOINED, &fault->joined, &fault->joined_count);
        }
    }
}

/* The labels 0 ... label_count - 1 that nothing has. `words` holds the labels in use, sorted; more
 * than count labels cannot all be used. */
static void look_at_gaps(const uint64_t *words, int64_t word_count, int64_t used_count,
                         int64_t label_count, struct partition_fault *fault)
{
    if (label_count < 0)
        return;
    fault->gap_count = label_count > used_count ? label_count - used_count : 0;
    int64_t next = 0;
    for (int64_t i = 0; i < word_count && (int64_t)(words[i] >> 32) <= next; i++)
        if ((int64_t)(words[i] >> 32) == next)
            next++;
    if (fault->gap_count > 0)
        fault->gap = next;
}

static void compare_labels(const int32_t *answer, const int32_t *right, int64_t count,
                           int64_t label_count, int32_t *leaders, uint64_t *words,
                           struct partition_fault *fault)
{
    int32_t *label_leader = leaders, *group_leader = leaders + count;
    uint64_t *spare = words + count;
    look_at_labels(answer, right, count, label_count, fault);
    fault->group_count = find_leaders(right, NULL, count, group_leader, words, spare);
    find_leaders(right, fault->marks, count, group_leader, words, spare);
    int64_t used = find_leaders(answer, fault->marks, count, label_leader, words, spare);
    int64_t word_count = 0;
    for (int64_t i = 0; i < count; i++)
        word_count += label_leader[i] >= 0;
    look_at_gaps(words, word_count, used, label_count, fault);
    look_at_pairs(right, count, label_leader, group_leader, fault);
}

int partition_compare(const int32_t *answer, const int32_t *right, int64_t count,
                      int64_t label_count, struct partition_fault *fault, struct error *err)
{
    *fault = (struct partition_fault){.out_of_range = -1,
                                      .unlabelled = -1,
                                      .labelled = -1,
                                      .joined_with = -1,
                                      .joined = -1,
                                      .apart_from = -1,
                                      .apart = -1,
                                      .gap = -1};
    if (count < 0 || count > INT32_MAX || (count > 0 && (!answer || !right)))
        return error_set(err, "labels of %" PRId64 " things cannot be compared", count);
    size_t room = 2 * (size_t)count + 1;
    int32_t *leaders = calloc(room, sizeof *leaders);
    uint64_t *words = calloc(room, sizeof *words);
    fault->marks = calloc((size_t)count + 1, 1);
    bool has_memory = leaders && words && fault->marks;
    if (has_memory)
        compare_labels(answer, right, count, label_count, leaders, words, fault);
    else
        partition_fault_release(fault);
    free(leaders);
    free(words);
    return has_memory ? 0 : error_set(err, "out of memory: comparing %" PRId64 " labels", count);
}
