/* Judging a table of edges; see edge_table.h. */
#include "graders/library/edge_table.h"

#include "graders/library/edge_hints.h"

#include <inttypes.h>

enum { ENTRY_BYTES = 2 * sizeof(int32_t), ENTRIES_A_TRIANGLE = 6 };

/* The answer, and what is the matter with it. Entries and edges at fault are the first; -1: none.
 */
struct findings {
    const int32_t *entries;
    int64_t entry_count;
    int64_t out_of_range, self, repeated, extra;
    int64_t out_of_range_count, self_count, repeated_count, extra_count, missing_count;
    const struct listed_edge *missing; /* the one whose first triangle comes first */
};

static int64_t most_entries(const struct mesh_view *view)
{
    return (int64_t)ENTRIES_A_TRIANGLE * view->triangle_count;
}

size_t edge_table_answer_bound(struct span input)
{
    struct mesh_view view = mesh_case_read(input);
    return 2 * sizeof(int64_t) + (size_t)most_entries(&view) * ENTRY_BYTES;
}

static bool in_range(int32_t vertex, const struct mesh_view *view)
{
    return vertex >= 0 && vertex < view->vertex_count;
}

static void note(int64_t *first, int64_t *count, int64_t entry)
{
    if (*first < 0)
        *first = entry;
    ++*count;
}

static void count_entry(const struct mesh_view *view, const struct edge_set *set,
                        struct findings *f, int64_t entry)
{
    int32_t a = f->entries[2 * entry], b = f->entries[2 * entry + 1];
    if (!in_range(a, view) || !in_range(b, view)) {
        note(&f->out_of_range, &f->out_of_range_count, entry);
        return;
    }
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

static struct findings examine(const struct mesh_view *view, const struct edge_set *set,
                               const int32_t *entries, int64_t entry_count)
{
    struct findings f = {.entries = entries,
                         .entry_count = entry_count,
                         .out_of_range = -1,
                         .self = -1,
                         .repeated = -1,
                         .extra = -1};
    for (int64_t entry = 0; entry < entry_count; entry++)
        count_entry(view, set, &f, entry);
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

static void reject_range(const struct mesh_view *view, const struct findings *f,
                         struct judgement *out)
{
    const int32_t *entry = f->entries + 2 * f->out_of_range;
    struct hint hint = edge_hint_range(view, entry);
    judge_name_element(out, "edge %" PRId64 " (%d,%d)", f->out_of_range, entry[0], entry[1]);
    judge_reject(out, "index-out-of-range",
                 "edge %" PRId64 " is (%d,%d), but vertices are numbered 0 to %d. Out of range: "
                 "%" PRId64 " of %" PRId64 " entries.%s%.0s",
                 "la arista %" PRId64 " es (%d,%d), pero los vértices se numeran de 0 a %d. Fuera "
                 "de rango: %" PRId64 " de %" PRId64 " entradas.%.0s%s",
                 f->out_of_range, entry[0], entry[1], view->vertex_count - 1, f->out_of_range_count,
                 f->entry_count, hint.english, hint.spanish);
}

static void reject_self(const struct mesh_view *view, const struct findings *f,
                        struct judgement *out)
{
    int32_t v = f->entries[2 * f->self];
    struct hint hint = edge_hint_self(view, f->entries, f->entry_count, f->self);
    judge_name_element(out, "edge %" PRId64 " (%d,%d)", f->self, v, v);
    judge_reject(out, "self-edge",
                 "edge %" PRId64 " (%d,%d) joins a vertex to itself; the two ends of an edge are "
                 "different. Such entries: %" PRId64 ".%s%.0s",
                 "la arista %" PRId64 " (%d,%d) une un vértice consigo mismo; los extremos de una "
                 "arista son distintos. Entradas así: %" PRId64 ".%.0s%s",
                 f->self, v, v, f->self_count, hint.english, hint.spanish);
}

static void reject_duplicate(const struct edge_set *set, const struct findings *f,
                             struct judgement *out)
{
    int32_t a = f->entries[2 * f->repeated], b = f->entries[2 * f->repeated + 1];
    int64_t first = edge_set_find(set, a, b)->first_entry;
    struct hint hint = edge_hint_duplicate(set);
    judge_name_element(out, "edge %" PRId64 " (%d,%d)", f->repeated, a, b);
    judge_reject(out, "duplicate-edge",
                 "edge %" PRId64 " (%d,%d) is listed twice (also as entry %" PRId64
                 "). Entries that repeat an earlier one: %" PRId64 ".%s%.0s",
                 "la arista %" PRId64 " (%d,%d) aparece dos veces (también como entrada %" PRId64
                 "). Entradas que repiten una anterior: %" PRId64 ".%.0s%s",
                 f->repeated, a, b, first, f->repeated_count, hint.english, hint.spanish);
}

static void reject_extra(const struct mesh_view *view, const struct findings *f,
                         struct judgement *out)
{
    int32_t a = f->entries[2 * f->extra], b = f->entries[2 * f->extra + 1];
    struct hint hint = edge_hint_extra(view, a, b);
    judge_name_element(out, "edge %" PRId64 " (%d,%d)", f->extra, a, b);
    judge_reject(out, "extra-edge",
                 "edge %" PRId64 " (%d,%d) is no edge of the mesh: no triangle joins these two "
                 "vertices. Such entries: %" PRId64 " of %" PRId64 ".%s%.0s",
                 "la arista %" PRId64 " (%d,%d) no es de la malla: ningún triángulo une esos dos "
                 "vértices. Entradas así: %" PRId64 " de %" PRId64 ".%.0s%s",
                 f->extra, a, b, f->extra_count, f->entry_count, hint.english, hint.spanish);
}

static void reject_missing(const struct mesh_view *view, const struct edge_set *set,
                           const struct findings *f, struct judgement *out)
{
    const struct listed_edge *edge = f->missing;
    struct hint hint = edge_hint_missing(view, set);
    judge_name_element(out, "edge {%d,%d}", edge->low, edge->high);
    judge_reject(out, "missing-edge",
                 "edge {%d,%d} of triangle %d is missing. Missing in all: %" PRId64 " of %" PRId64
                 " edges.%s%.0s",
                 "falta la arista {%d,%d} del triángulo %d. Faltan en total: %" PRId64
                 " de %" PRId64 " aristas.%.0s%s",
                 edge->low, edge->high, edge->triangle, f->missing_count, set->count, hint.english,
                 hint.spanish);
}

/* ------------------------------------------------------------------------------------ the scene */

/* Marks an edge of the mesh that is not listed just once. */
static void mark_edge(struct scene *scene, const struct listed_edge *edge)
{
    scene_mark_edge(scene, edge->listed_count == 0 ? MARK_MISSING : MARK_DUPLICATE, edge->low,
                    edge->high);
}

/* Marks an entry of the answer that is no edge of the mesh. */
static void mark_entry(const struct mesh_view *view, const struct edge_set *set,
                       const struct findings *f, int64_t entry, struct scene *scene)
{
    int32_t a = f->entries[2 * entry], b = f->entries[2 * entry + 1];
    if (!in_range(a, view) || !in_range(b, view))
        return;
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
    if (f->out_of_range_count)
        return (struct named){NULL, -1};
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
    if (mesh_case_show(view, scene, err))
        return -1;
    scene->ok_count = 0;
    struct named named = named_of(set, f);
    if (named.edge)
        mark_edge(scene, named.edge);
    if (named.entry >= 0)
        mark_entry(view, set, f, named.entry, scene);
    for (int64_t e = 0; e < set->count; e++) {
        const struct listed_edge *edge = &set->edges[e];
        if (edge->listed_count == 1)
            scene->ok_count++;
        else if (edge != named.edge)
            mark_edge(scene, edge);
    }
    for (int64_t entry = 0; entry < f->entry_count; entry++)
        if (entry != named.entry)
            mark_entry(view, set, f, entry, scene);
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
    struct findings f = examine(view, &set, entries, entry_count);
    if (f.out_of_range_count)
        reject_range(view, &f, out);
    else if (f.self_count)
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

static void reject_count(const struct mesh_view *view, int64_t count, struct judgement *out)
{
    if (count < 0)
        judge_reject(out, "impossible-count",
                     "the function returned %" PRId64 " edges; a count is 0 or more, and only "
                     "OUT_OF_MEMORY (-1) says that memory ran out",
                     "la función devolvió %" PRId64 " aristas; un número de aristas es 0 o más, y "
                     "solo OUT_OF_MEMORY (-1) indica que se agotó la memoria",
                     count);
    else
        judge_reject(out, "impossible-count",
                     "the function returned %" PRId64 " edges; %d triangles have at most %" PRId64,
                     "la función devolvió %" PRId64 " aristas; %d triángulos tienen como mucho "
                     "%" PRId64,
                     count, view->triangle_count, 3 * (int64_t)view->triangle_count);
}

int edge_table_judge(struct span input, struct span answer, const struct usage *usage,
                     struct judgement *out, struct error *err)
{
    (void)usage;
    struct mesh_view view = mesh_case_read(input);
    struct reader reader = reader_of(answer.bytes, answer.count);
    int64_t count;
    const int32_t *entries = read_table(&reader, &count, ENTRY_BYTES);
    out->scene.ok_count = -1;
    if (reader.failed)
        judge_reject(out, "malformed-answer", "the answer is not a table of edges",
                     "la respuesta no es una tabla de aristas");
    else if (count < 0 || count > most_entries(&view))
        reject_count(&view, count, out);
    else if (!entries)
        judge_reject(out, "no-table", "the function returned %" PRId64 " edges, but *edges is NULL",
                     "la función devolvió %" PRId64 " aristas, pero *edges es NULL", count);
    else
        return judge_entries(&view, entries, count, out, err);
    return 0;
}
