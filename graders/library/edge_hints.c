/* Which mistake an edge table looks like; see edge_hints.h. */
#include "graders/library/edge_hints.h"

#include "graders/library/hints.h"

#include <stdlib.h>

enum { LARGE_VALENCE = 8 };

static const struct phrase NO_HINT = {NULL, NULL};

/* What the rules look at: the context of their predicates, whose elements are edges of the set. */
struct surroundings {
    const struct edge_set *set;
    const struct mesh_view *view;
    int32_t *parent;  /* union-find over the vertices: one tree a component; NULL: not known */
    int32_t *valence; /* edges at each vertex; NULL: not known */
    int32_t first_vertex;
};

/* ----------------------------------------------------------------------------- the surroundings */

static int32_t root_of(int32_t *parent, int32_t v)
{
    while (parent[v] != v) {
        parent[v] = parent[parent[v]];
        v = parent[v];
    }
    return v;
}

/* Without memory the rules that need it do not fit, and that is all. */
static struct surroundings look_around(const struct mesh_view *view, const struct edge_set *set)
{
    size_t room = (size_t)view->vertex_count + 1;
    struct surroundings s = {.set = set,
                             .view = view,
                             .parent = malloc(room * sizeof *s.parent),
                             .valence = calloc(room, sizeof *s.valence),
                             .first_vertex = view->triangle_count > 0 ? view->triangles[0] : 0};
    for (int32_t v = 0; s.parent && v < view->vertex_count; v++)
        s.parent[v] = v;
    for (int64_t e = 0; e < set->count; e++) {
        int32_t low = set->edges[e].low, high = set->edges[e].high;
        if (s.parent)
            s.parent[root_of(s.parent, low)] = root_of(s.parent, high);
        if (s.valence) {
            s.valence[low]++;
            s.valence[high]++;
        }
    }
    return s;
}

static const struct listed_edge *edge_of(const void *context, int64_t edge)
{
    const struct surroundings *s = context;
    return &s->set->edges[edge];
}

/* -------------------------------------------------------------------------------- missing edges */

static bool is_missing(const void *context, int64_t edge)
{
    return edge_of(context, edge)->listed_count == 0;
}

/* Of an edge that the last of several triangles is the first to have. */
static bool in_last_triangle(const void *context, int64_t edge)
{
    const struct surroundings *s = context;
    const struct listed_edge *e = edge_of(context, edge);
    return s->view->triangle_count > 1 && e->triangle == s->view->triangle_count - 1;
}

static bool at_last_vertex(const void *context, int64_t edge)
{
    const struct surroundings *s = context;
    const struct listed_edge *e = edge_of(context, edge);
    return e->high == s->view->vertex_count - 1;
}

static bool at_vertex_zero(const void *context, int64_t edge)
{
    return edge_of(context, edge)->low == 0;
}

static bool degenerate_only(const void *context, int64_t edge)
{
    return edge_of(context, edge)->flags & EDGE_DEGENERATE_ONLY;
}

static bool in_other_component(const void *context, int64_t edge)
{
    const struct surroundings *s = context;
    const struct listed_edge *e = edge_of(context, edge);
    return s->parent && root_of(s->parent, e->low) != root_of(s->parent, s->first_vertex);
}

static bool never_up(const void *context, int64_t edge)
{
    return !(edge_of(context, edge)->flags & EDGE_UP);
}

static bool never_down(const void *context, int64_t edge)
{
    return !(edge_of(context, edge)->flags & EDGE_DOWN);
}

static bool closing_only(const void *context, int64_t edge)
{
    return edge_of(context, edge)->flags & EDGE_CLOSING_ONLY;
}

static bool on_boundary(const void *context, int64_t edge)
{
    return edge_of(context, edge)->side_count == 1;
}

static bool non_manifold(const void *context, int64_t edge)
{
    return edge_of(context, edge)->side_count > 2;
}

static bool at_large_valence(const void *context, int64_t edge)
{
    const struct surroundings *s = context;
    const struct listed_edge *e = edge_of(context, edge);
    return s->valence &&
           (s->valence[e->low] > LARGE_VALENCE || s->valence[e->high] > LARGE_VALENCE);
}

static const struct hint_rule missing_rules[] = {
    {in_last_triangle,
     HINT_ALL_OF_THESE,
     {"Only edges of the last triangle are lost: does the loop stop one too early?",
      "Solo se pierden aristas del último triángulo: ¿acaba el bucle uno antes de tiempo?"}},
    {at_last_vertex,
     HINT_ALL_OF_THESE,
     {"All edges of the last vertex are lost, and only these: does a loop over the vertices stop "
      "one too early?",
      "Se pierden las aristas del último vértice y solo esas: ¿acaba un bucle sobre los vértices "
      "uno antes de tiempo?"}},
    {at_vertex_zero,
     HINT_ALL_OF_THESE,
     {"All edges of vertex 0 are lost, and only these: is 0 taken to mean 'none'?",
      "Se pierden las aristas del vértice 0 y solo esas: ¿se usa el 0 para decir 'ninguno'?"}},
    {degenerate_only,
     HINT_ONLY_THESE,
     {"Only edges of degenerate triangles are lost: (a,a,b) still joins a and b.",
      "Solo se pierden aristas de triángulos degenerados: (a,a,b) también une a con b."}},
    {in_other_component,
     HINT_ONLY_THESE,
     {"All of them lie in other components than triangle 0: a walk over neighbours does not reach "
      "these.",
      "Todas están en otras componentes que el triángulo 0: un recorrido por vecinos no llega "
      "hasta ellas."}},
    {never_up,
     HINT_ALL_OF_THESE,
     {"Lost are exactly the edges that no triangle passes from the smaller to the larger number: "
      "keeping (i,j) only if i < j needs a closed, coherent mesh.",
      "Se pierden justo las aristas que ningún triángulo recorre del número menor al mayor: "
      "guardar (i,j) solo si i < j exige una malla cerrada y coherente."}},
    {never_down,
     HINT_ALL_OF_THESE,
     {"Lost are exactly the edges that no triangle passes from the larger to the smaller number: "
      "keeping (i,j) only if i > j needs a closed, coherent mesh.",
      "Se pierden justo las aristas que ningún triángulo recorre del número mayor al menor: "
      "guardar (i,j) solo si i > j exige una malla cerrada y coherente."}},
    {closing_only,
     HINT_ALL_OF_THESE,
     {"Lost is the side from the third corner back to the first.",
      "Se pierde el lado que va del tercer vértice del triángulo al primero."}},
    {on_boundary,
     HINT_ONLY_THESE,
     {"Boundary edges are lost: an edge with only one triangle counts too.",
      "Se pierden aristas del borde: una arista con un solo triángulo también cuenta."}},
    {non_manifold,
     HINT_ONLY_THESE,
     {"Only edges of more than two triangles are lost.",
      "Solo se pierden aristas de más de dos triángulos."}},
    {at_large_valence,
     HINT_ONLY_THESE,
     {"All of them are at vertices with many neighbours: is a row of fixed length full?",
      "Todas tocan vértices con muchos vecinos: ¿se llena una fila de longitud fija?"}},
};

/* Says that the table is empty, if it is. */
static struct phrase hint_of_empty_table(const struct edge_set *set)
{
    bool all_boundary = true;
    for (int64_t e = 0; e < set->count; e++) {
        if (set->edges[e].listed_count > 0)
            return NO_HINT;
        all_boundary = all_boundary && set->edges[e].side_count == 1;
    }
    if (all_boundary)
        return (struct phrase){"The table is empty: an edge with only one triangle counts too.",
                               "La tabla está vacía: una arista con un solo triángulo también "
                               "cuenta."};
    return (struct phrase){"The table is empty.", "La tabla está vacía."};
}

struct phrase edge_hint_missing(const struct mesh_view *view, const struct edge_set *set)
{
    struct phrase hint = hint_of_empty_table(set);
    struct surroundings s = look_around(view, set);
    if (!hint.en)
        hint = hint_find(missing_rules, sizeof missing_rules / sizeof *missing_rules, &s,
                         set->count, is_missing);
    free(s.parent);
    free(s.valence);
    return hint;
}

/* ------------------------------------------------------------------------------------ duplicates
 */

static bool is_repeated(const void *context, int64_t edge)
{
    return edge_of(context, edge)->listed_count > 1;
}

static bool listed_both_ways(const void *context, int64_t edge)
{
    uint32_t flags = edge_of(context, edge)->flags;
    return flags & EDGE_LISTED_UP && flags & EDGE_LISTED_DOWN;
}

static bool run_one_way(const void *context, int64_t edge)
{
    uint32_t flags = edge_of(context, edge)->flags;
    return !(flags & EDGE_UP && flags & EDGE_DOWN);
}

static const struct hint_rule direction_rules[] = {
    {listed_both_ways,
     HINT_ONLY_THESE,
     {"Each is listed as (i,j) and as (j,i): that is one edge.",
      "Cada una aparece como (i,j) y como (j,i): es una sola arista."}},
};

static const struct hint_rule repeated_rules[] = {
    {run_one_way,
     HINT_ONLY_THESE,
     {"Their triangles name them in the same direction, (i,j) and (i,j): orientation is not "
      "coherent.",
      "Sus triángulos las nombran en el mismo sentido, (i,j) e (i,j): la orientación no es "
      "coherente."}},
    {non_manifold,
     HINT_ONLY_THESE,
     {"All of them have more than two sides of triangles.",
      "Todas son lado de más de dos triángulos."}},
};

/* Whether each edge is listed as often as triangles have it. */
static bool lists_every_side(const struct edge_set *set)
{
    for (int64_t e = 0; e < set->count; e++)
        if (set->edges[e].listed_count != set->edges[e].side_count)
            return false;
    return true;
}

struct phrase edge_hint_duplicate(const struct edge_set *set)
{
    struct surroundings s = {.set = set};
    struct phrase hint = hint_find(direction_rules, 1, &s, set->count, is_repeated);
    if (hint.en)
        return hint;
    if (lists_every_side(set))
        return (struct phrase){
            "Every triangle adds its three edges; an edge that a neighbour added "
            "already must not be added again.",
            "Cada triángulo añade sus tres aristas; la que ya añadió un vecino "
            "no debe añadirse otra vez."};
    return hint_find(repeated_rules, sizeof repeated_rules / sizeof *repeated_rules, &s, set->count,
                     is_repeated);
}

/* -------------------------------------------------------------------------------- wrong entries */

static bool is_used(const struct mesh_view *view, int32_t vertex)
{
    for (int64_t i = 0; i < 3 * (int64_t)view->triangle_count; i++)
        if (view->triangles[i] == vertex)
            return true;
    return false;
}

struct phrase edge_hint_extra(const struct mesh_view *view, int32_t a, int32_t b)
{
    if (view->vertex_count > INT16_MAX)
        return (struct phrase){
            "Does a number overflow? Here vertex numbers need more than 15 bits, and "
            "i * vertex_count + j more than 31.",
            "¿Se desborda un número? Aquí los de vértice ocupan más de 15 bits, e "
            "i * vertex_count + j más de 31."};
    if (!is_used(view, a) || !is_used(view, b))
        return (struct phrase){"One of them is in no triangle at all.",
                               "Uno de ellos no está en ningún triángulo."};
    return NO_HINT;
}

struct phrase edge_hint_self(const struct mesh_view *view, const int32_t *entries,
                             int64_t entry_count, int64_t at)
{
    bool zeros_to_the_end = true;
    for (int64_t i = 2 * at; i < 2 * entry_count; i++)
        zeros_to_the_end = zeros_to_the_end && entries[i] == 0;
    if (zeros_to_the_end)
        return (struct phrase){"From there on all is 0: is the count larger than what was written?",
                               "Desde ahí todo es 0: ¿es el número mayor que lo que se escribió?"};
    for (int64_t t = 0; t < view->triangle_count; t++) {
        const int32_t *v = view->triangles + 3 * t;
        int times =
            (v[0] == entries[2 * at]) + (v[1] == entries[2 * at]) + (v[2] == entries[2 * at]);
        if (times > 1)
            return (struct phrase){"A triangle with a repeated vertex gives no such edge.",
                                   "Un triángulo con un vértice repetido no da esa arista."};
    }
    return NO_HINT;
}
