/* Judging a table of edges; see edge_table.h. */
#include "graders/library/edge_table.h"

#include "graders/library/edge_hints.h"

#include <inttypes.h>

static const struct phrase edge_noun = {"edge", "arista"};
static const struct cause self_edge = {"self-edge", {"degenerate edge", "arista degenerada"}};
static const struct cause duplicate_edge = {"duplicate-edge",
                                            {"duplicate edge", "arista duplicada"}};
static const struct cause extra_edge = {"extra-edge", {"extra edge", "arista de más"}};
static const struct cause missing_edge = {"missing-edge", {"missing edge", "falta una arista"}};

/* The answer, and what is the matter with it. Entries and edges at fault are the first; -1: none.
 */
struct findings {
    const int32_t *entries;
    int64_t entry_count;
    int64_t self, repeated, extra;
    int64_t self_count, repeated_count, extra_count, missing_count;
    const struct listed_edge *missing; /* the one whose first triangle comes first */
};

static void note(int64_t *first, int64_t *count, int64_t entry)
{
    if (*first < 0)
        *first = entry;
    ++*count;
}

static void count_entry(const struct edge_set *set, struct findings *f, int64_t entry)
{
    int32_t a = f->entries[2 * entry], b = f->entries[2 * entry + 1];
    if (a == b) {
        note(&f->self, &f->self_count, entry);
        return;
    }
    struct listed_edge *edge = edge_set_find(set, a, b);
    if (!edge) {
        note(&f->extra, &f->extra_count, entry);
        return;
    }
    edge->flags |= a < b ? EDGE_LISTED_UP : EDGE_LISTED_DOWN;
    if (edge->listed_count++ == 0)
        edge->first_entry = entry;
    else
        note(&f->repeated, &f->repeated_count, entry);
}

static struct findings examine(const struct edge_set *set, const int32_t *entries,
                               int64_t entry_count)
{
    struct findings f = {
        .entries = entries, .entry_count = entry_count, .self = -1, .repeated = -1, .extra = -1};
    for (int64_t entry = 0; entry < entry_count; entry++)
        count_entry(set, &f, entry);
    for (int64_t e = 0; e < set->count; e++) {
        const struct listed_edge *edge = &set->edges[e];
        if (edge->listed_count > 0)
            continue;
        f.missing_count++;
        if (!f.missing || edge->triangle < f.missing->triangle)
            f.missing = edge;
    }
    return f;
}

/* ------------------------------------------------------------------------------------ the words */

static void reject_self(const struct mesh_view *view, const struct findings *f,
                        struct judgement *out)
{
    int32_t v = f->entries[2 * f->self];
    judge_name_one(out, edge_noun, "%" PRId64 " (%d,%d)", f->self, v, v);
    judge_reject(out, &self_edge,
                 "edge %" PRId64 " (%d,%d) joins a vertex to itself; the two ends of an edge are "
                 "different. Such entries: %" PRId64 ".",
                 "la arista %" PRId64 " (%d,%d) une un vértice consigo mismo; los extremos de una "
                 "arista son distintos. Entradas así: %" PRId64 ".",
                 f->self, v, v, f->self_count);
    judge_hint(out, edge_hint_self(view, f->entries, f->entry_count, f->self));
}

static void reject_duplicate(const struct edge_set *set, const struct findings *f,
                             struct judgement *out)
{
    int32_t a = f->entries[2 * f->repeated], b = f->entries[2 * f->repeated + 1];
    int64_t first = edge_set_find(set, a, b)->first_entry;
    judge_name_one(out, edge_noun, "%" PRId64 " (%d,%d)", f->repeated, a, b);
    judge_reject(out, &duplicate_edge,
                 "edge %" PRId64 " (%d,%d) is listed twice (also as entry %" PRId64
                 "). Entries that repeat an earlier one: %" PRId64 ".",
                 "la arista %" PRId64 " (%d,%d) aparece dos veces (también como entrada %" PRId64
                 "). Entradas que repiten una anterior: %" PRId64 ".",
                 f->repeated, a, b, first, f->repeated_count);
    judge_hint(out, edge_hint_duplicate(set));
}

static void reject_extra(const struct mesh_view *view, const struct findings *f,
                         struct judgement *out)
{
    int32_t a = f->entries[2 * f->extra], b = f->entries[2 * f->extra + 1];
    judge_name_one(out, edge_noun, "%" PRId64 " (%d,%d)", f->extra, a, b);
    judge_reject(out, &extra_edge,
                 "edge %" PRId64 " (%d,%d) is no edge of the mesh: no triangle joins these two "
                 "vertices. Such entries: %" PRId64 " of %" PRId64 ".",
                 "la arista %" PRId64 " (%d,%d) no es de la malla: ningún triángulo une esos dos "
                 "vértices. Entradas así: %" PRId64 " de %" PRId64 ".",
                 f->extra, a, b, f->extra_count, f->entry_count);
    judge_hint(out, edge_hint_extra(view, a, b));
}

static void reject_missing(const struct mesh_view *view, const struct edge_set *set,
                           const struct findings *f, struct judgement *out)
{
    const struct listed_edge *edge = f->missing;
    judge_name_one(out, edge_noun, "{%d,%d}", edge->low, edge->high);
    judge_reject(out, &missing_edge, "edge {%d,%d} of triangle %d is missing.",
                 "falta la arista {%d,%d} del triángulo %d.", edge->low, edge->high,
                 edge->triangle);
    bool one = f->missing_count == 1;
    judge_en(out, " %" PRId64 " of %" PRId64 " edges %s missing.", f->missing_count, set->count,
             one ? "is" : "are");
    judge_es(out, " %s %" PRId64 " de %" PRId64 " aristas.", one ? "Falta" : "Faltan",
             f->missing_count, set->count);
    judge_hint(out, edge_hint_missing(view, set));
}

/* ------------------------------------------------------------------------------------ the scene */

/* Marks an edge of the mesh that is not listed just once. */
static void mark_edge(struct scene *scene, const struct listed_edge *edge)
{
    scene_mark_edge(scene, edge->listed_count == 0 ? MARK_MISSING : MARK_DUPLICATE, edge->low,
                    edge->high);
}

/* Marks an entry of the answer that is no edge of the mesh. */
static void mark_entry(const struct edge_set *set, const struct findings *f, int64_t entry,
                       struct scene *scene)
{
    int32_t a = f->entries[2 * entry], b = f->entries[2 * entry + 1];
    if (a == b)
        scene_mark_edge(scene, MARK_DEGENERATE, a, b);
    else if (!edge_set_find(set, a, b))
        scene_mark_edge(scene, MARK_EXTRA, a, b);
}

/* What the verdict names: an edge of the mesh, or an entry of the answer, or neither (NULL, -1). */
struct named {
    const struct listed_edge *edge;
    int64_t entry;
};

/* The faults in the order in which judge_entries looks for them. */
static struct named named_of(const struct edge_set *set, const struct findings *f)
{
    if (f->self_count)
        return (struct named){NULL, f->self};
    if (f->repeated_count) {
        const int32_t *entry = f->entries + 2 * f->repeated;
        return (struct named){edge_set_find(set, entry[0], entry[1]), -1};
    }
    return (struct named){f->extra_count ? NULL : f->missing, f->extra_count ? f->extra : -1};
}

static int show(const struct mesh_view *view, const struct edge_set *set, const struct findings *f,
                struct judgement *out, struct error *err)
{
    struct scene *scene = &out->scene;
    if (!view->positions)
        return 0;
    if (mesh_input_show(view, scene, err))
        return -1;
    scene->ok_count = 0;
    struct named named = named_of(set, f);
    if (named.edge)
        mark_edge(scene, named.edge);
    if (named.entry >= 0)
        mark_entry(set, f, named.entry, scene);
    for (int64_t e = 0; e < set->count; e++) {
        const struct listed_edge *edge = &set->edges[e];
        if (edge->listed_count == 1)
            scene->ok_count++;
        else if (edge != named.edge)
            mark_edge(scene, edge);
    }
    for (int64_t entry = 0; entry < f->entry_count; entry++)
        if (entry != named.entry)
            mark_entry(set, f, entry, scene);
    for (int64_t e = 0; e < set->count; e++)
        if (set->edges[e].side_count == 1)
            scene_mark_edge(scene, MARK_BOUNDARY, set->edges[e].low, set->edges[e].high);
    return 0;
}

/* -------------------------------------------------------------------------------------- judging */

static int judge_entries(const struct mesh_view *view, const int32_t *entries, int64_t entry_count,
                         struct judgement *out, struct error *err)
{
    struct edge_set set;
    if (edge_set_make(view, &set, err))
        return -1;
    struct findings f = examine(&set, entries, entry_count);
    if (f.self_count)
        reject_self(view, &f, out);
    else if (f.repeated_count)
        reject_duplicate(&set, &f, out);
    else if (f.extra_count)
        reject_extra(view, &f, out);
    else if (f.missing_count)
        reject_missing(view, &set, &f, out);
    else
        judge_accept(out);
    int failed = out->accepted ? 0 : show(view, &set, &f, out, err);
    edge_set_release(&set);
    return failed;
}

int edge_table_judge(const struct task *task, struct judgement *out, struct error *err)
{
    const struct answer_table *edges = &task->answer.table[0];
    return judge_entries(&task->mesh, edges->cells, edges->count, out, err);
}
