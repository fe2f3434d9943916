/* Hints as tables: which mistake wrong elements look like. An element is whatever a caller counts:
 * vertices, edges, faces, loops, rows of an answer.
 *
 *     static bool is_last(const void *context, int64_t edge) {...}
 *
 *     static const struct hint_rule rules[] = {
 *         {is_last, HINT_ALL_OF_THESE, {"All edges of the last vertex are lost, and only these:
 * ...", "Se pierden las aristas del último vértice y solo esas..."}}, {is_boundary,
 * HINT_ONLY_THESE, {"Boundary edges are lost: ...", "..."}}}; judge_hint(out, hint_find(rules, 2,
 * &surroundings, edge_count, is_missing));
 *
 * A hint is given when what is wrong fits without exception. It is a guess, and never changes a
 * verdict. Rules stand from the narrowest to the widest: the first that fits is told. Ready-made
 * predicates for what a mesh has: topology_hints.h. */
#ifndef GRADERS_LIBRARY_HINTS_H
#define GRADERS_LIBRARY_HINTS_H

#include "reference/base/phrase.h"

#include <stdbool.h>
#include <stdint.h>

/* Something that holds for an element or not; context is the caller's. */
typedef bool hint_predicate(const void *context, int64_t element);

enum hint_scope {
    HINT_ONLY_THESE,  /* every wrong element is one of these */
    HINT_ALL_OF_THESE /* and every one of these is wrong */
};

struct hint_rule {
    hint_predicate *holds;
    enum hint_scope scope;
    struct phrase hint; /* a sentence */
};

/* The hint of the first rule that fits; no text (NULL, NULL) when none does, or nothing is wrong.
 * Elements are 0 ... element_count - 1. Linear, times the rules. */
struct phrase hint_find(const struct hint_rule *rules, int rule_count, const void *context,
                        int64_t element_count, hint_predicate *is_wrong);

/* The same where marks say what is wrong: elements with this mark are, as in set_fault.h. */
struct phrase hint_find_marked(const struct hint_rule *rules, int rule_count, const void *context,
                               int64_t element_count, const uint8_t *marks, uint8_t wrong);

#endif
