/* Comparing labellings up to the names of the labels: the component of each triangle, the new
 * number of each vertex (map), the patch of each face.
 *
 *     struct partition_fault fault;
 *     if (partition_compare(component, right, triangle_count, component_count, &fault, err))
 *         return -1;
 *     const struct cause *cause = partition_fault_cause(&fault);
 *     if (cause == &partition_joined)
 *         ... things fault.joined_with and fault.joined have one label and must not ...
 *     partition_fault_release(&fault);
 *
 * Of each kind the first thing at fault is told; a pair is that thing and the first one before it
 * with which it disagrees. */
#ifndef GRADERS_LIBRARY_PARTITION_H
#define GRADERS_LIBRARY_PARTITION_H

#include "reference/base/error.h"
#include "reference/base/phrase.h"

#include <stdbool.h>
#include <stdint.h>

enum {
    PARTITION_NONE = -1,     /* the label of a thing that belongs to no group */
    PARTITION_ANY_NAMES = -1 /* as label_count: labels may be any numbers from 0 */
};

enum partition_mark {
    PARTITION_FINE,
    PARTITION_OUT_OF_RANGE, /* the label is negative (but not NONE), or label_count or more */
    PARTITION_UNLABELLED,   /* NONE, but the thing belongs to a group */
    PARTITION_LABELLED,     /* a label, but the thing belongs to none */
    PARTITION_JOINED,       /* the label is that of a thing of another group */
    PARTITION_APART         /* the label differs from that of a thing of the same group */
};

/* First thing of a kind (-1: none), and how many things are marked so. A thing that is joined with
 * some and apart from others is marked as joined, but counts as both. */
struct partition_fault {
    int64_t out_of_range, out_of_range_count;
    int64_t unlabelled, unlabelled_count;
    int64_t labelled, labelled_count;
    int64_t joined_with, joined, joined_count; /* joined_with < joined */
    int64_t apart_from, apart, apart_count;    /* apart_from < apart */
    int64_t gap, gap_count;                    /* the smallest label that nothing has; -1: none */
    int64_t group_count;                       /* groups of the right labelling */
    uint8_t *marks;                            /* enum partition_mark of every thing */
};

extern const struct cause partition_out_of_range, partition_unlabelled, partition_labelled,
    partition_joined, partition_apart, partition_gap;

/* Compares labels with right ones.
 *
 * answer        a label for each thing; may hold anything
 * right         negative: the thing belongs to no group, and its label must be PARTITION_NONE
 * count         0 ... INT32_MAX; the tables may be NULL when it is 0
 * label_count   labels are 0 ... label_count - 1, each used by some thing; PARTITION_ANY_NAMES: any
 *               numbers from 0, with or without gaps. It may be the count that the answer claims:
 *               compare that with fault->group_count first
 * fault         on success the caller owns it (partition_fault_release)
 * returns       0, or -1 and *err (out of memory, or an argument out of its range)
 * cost          linear */
int partition_compare(const int32_t *answer, const int32_t *right, int64_t count,
                      int64_t label_count, struct partition_fault *fault,
                      struct error *err) MUST_CHECK;

/* The cause to tell first: out of range, unlabelled, labelled, joined, apart, gap; NULL: nothing is
 * wrong. */
const struct cause *partition_fault_cause(const struct partition_fault *fault);

/* Frees the marks. The zero value may be released, and releasing twice does no harm. */
void partition_fault_release(struct partition_fault *fault);

#endif
