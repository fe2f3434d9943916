/* Which mistake an edge table looks like. A hint is given when what is wrong fits a pattern without
 * exception; it is a guess, and never changes a verdict. */
#ifndef GRADERS_LIBRARY_EDGE_HINTS_H
#define GRADERS_LIBRARY_EDGE_HINTS_H

#include "graders/library/edge_set.h"
#include "reference/base/phrase.h"

/* All take the edge set after the answer has been counted into it, and give a whole sentence, or no
 * text when no pattern fits. */
struct phrase edge_hint_missing(const struct mesh_view *view, const struct edge_set *set);
struct phrase edge_hint_duplicate(const struct edge_set *set);
struct phrase edge_hint_extra(const struct mesh_view *view, int32_t a, int32_t b);

/* entry_count, entries: the answer; at: the first entry at fault. */
struct phrase edge_hint_self(const struct mesh_view *view, const int32_t *entries,
                             int64_t entry_count, int64_t at);

#endif
