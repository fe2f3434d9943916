/* Which mistake an edge table looks like; see edge_hints.h. */
#include "graders/library/edge_hints.h"

#include <stdlib.h>

enum { LARGE_VALENCE = 8 };

static const struct hint NO_HINT = {"", ""};

/* What the patterns of missing edges look at, beside the edge. */
struct surroundings {
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

/* Without memory the patterns that need it do not fit, and that is all. */
static struct surroundings look_around(const struct mesh_view *view, const struct edge_set *set)
{
    size_t room = (size_t)view->vertex_count + 1;
    struct surroundings s = {.view = view,
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

/* -------------------------------------------------------------------------------- missing edges */

/* Of an edge that the last of several triangles is the first to have. */
static bool in_last_triangle(const struct listed_edge *e, const struct surroundings *s)
{
    return s->view->triangle_count > 1 && e->triangle == s->view->triangle_count - 1;
}

static bool at_last_vertex(const struct listed_edge *e, const struct surroundings *s)
{
    return e->high == s->view->vertex_count - 1;
}

static bool at_vertex_zero(const struct listed_edge *e, const struct surroundings *s)
{
    (void)s;
    return e->low == 0;
}

static bool degenerate_only(const struct listed_edge *e, const struct surroundings *s)
{
    (void)s;
    return e->flags & EDGE_DEGENERATE_ONLY;
}

static bool in_other_component(const struct listed_edge *e, const struct surroundings *s)
{
    return s->parent && root_of(s->parent, e->low) != root_of(s->parent, s->first_vertex);
}

static bool never_up(const struct listed_edge *e, const struct surroundings *s)
{
    (void)s;
    return !(e->flags & EDGE_UP);
}

static bool never_down(const struct listed_edge *e, const struct surroundings *s)
{
    (void)s;
    return !(e->flags & EDGE_DOWN);
}

static bool closing_only(const struct listed_edge *e, const struct surroundings *s)
{
    (void)s;
    return e->flags & EDGE_CLOSING_ONLY;
}

static bool on_boundary(const struct listed_edge *e, const struct surroundings *s)
{
    (void)s;
    return e->side_count == 1;
}

static bool non_manifold(const struct listed_edge *e, const struct surroundings *s)
{
    (void)s;
    return e->side_count > 2;
}

static bool at_large_valence(const struct listed_edge *e, const struct surroundings *s)
{
    return s->valence &&
           (s->valence[e->low] > LARGE_VALENCE || s->valence[e->high] > LARGE_VALENCE);
}

/* Patterns from the narrowest to the widest: the first that holds for every missing edge is told.
 */
struct pattern {
    bool (*holds)(const struct listed_edge *edge, const struct surroundings *s);
    bool must_be_all; /* and for no other edge of the mesh */
    struct hint hint;
};

static const struct pattern missing_patterns[] = {
    {in_last_triangle,
     true,
     {" Only edges of the last triangle are lost: does the loop stop one too early?",
      " Solo se pierden aristas del último triángulo: ¿acaba el bucle uno antes de tiempo?"}},
    {at_last_vertex,
     true,
     {" All edges of the last vertex are lost, and only these: does a loop over the vertices stop "
      "one too early?",
      " Se pierden las aristas del último vértice y solo esas: ¿acaba un bucle sobre los vértices "
      "uno antes de tiempo?"}},
    {at_vertex_zero,
     true,
     {" All edges of vertex 0 are lost, and only these: is 0 taken to mean 'none'?",
      " Se pierden las aristas del vértice 0 y solo esas: ¿se usa el 0 para decir 'ninguno'?"}},
    {degenerate_only,
     false,
     {" Only edges of degenerate triangles are lost: (a,a,b) still joins a and b.",
      " Solo se pierden aristas de triángulos degenerados: (a,a,b) también une a con b."}},
    {in_other_component,
     false,
     {" All of them lie in other components than triangle 0: a walk over neighbours does not reach "
      "these.",
      " Todas están en otras componentes que el triángulo 0: un recorrido por vecinos no llega "
      "hasta ellas."}},
    {never_up,
     true,
     {" Lost are exactly the edges that no triangle passes from the smaller to the larger number: "
      "keeping (i,j) only if i < j needs a closed, coherent mesh.",
      " Se pierden justo las aristas que ningún triángulo recorre del número menor al mayor: "
      "guardar (i,j) solo si i < j exige una malla cerrada y coherente."}},
    {never_down,
     true,
     {" Lost are exactly the edges that no triangle passes from the larger to the smaller number: "
      "keeping (i,j) only if i > j needs a closed, coherent mesh.",
      " Se pierden justo las aristas que ningún triángulo recorre del número mayor al menor: "
      "guardar (i,j) solo si i > j exige una malla cerrada y coherente."}},
    {closing_only,
     true,
     {" Lost is the side from the third corner back to the first.",
      " Se pierde el lado que va del tercer vértice del triángulo al primero."}},
    {on_boundary,
     false,
     {" Boundary edges are lost: an edge with only one triangle counts too.",
      " Se pierden aristas del borde: una arista con un solo triángulo también cuenta."}},
    {non_manifold,
     false,
     {" Only edges of more than two triangles are lost.",
      " Solo se pierden aristas de más de dos triángulos."}},
    {at_large_valence,
     false,
     {" All of them are at vertices with many neighbours: is a row of fixed length full?",
      " Todas tocan vértices con muchos vecinos: ¿se llena una fila de longitud fija?"}},
};

static bool fits(const struct pattern *pattern, const struct edge_set *set,
                 const struct surroundings *s)
{
    for (int64_t e = 0; e < set->count; e++) {
        const struct listed_edge *edge = &set->edges[e];
        bool missing = edge->listed_count == 0;
        if ((missing || pattern->must_be_all) && pattern->holds(edge, s) != missing)
            return false;
    }
    return true;
}

/* Says that the table is empty, if it is. */
static struct hint hint_of_empty_table(const struct edge_set *set)
{
    bool all_boundary = true;
    for (int64_t e = 0; e < set->count; e++) {
        if (set->edges[e].listed_count > 0)
            return NO_HINT;
        all_boundary = all_boundary && set->edges[e].side_count == 1;
    }
    if (all_boundary)
        return (struct hint){" The table is empty: an edge with only one triangle counts too.",
                             " La tabla está vacía: una arista con un solo triángulo también "
                             "cuenta."};
    return (struct hint){" The table is empty.", " La tabla está vacía."};
}

struct hint edge_hint_missing(const struct mesh_view *view, const struct edge_set *set)
{
    struct hint hint = hint_of_empty_table(set);
    struct surroundings s = look_around(view, set);
    size_t count = sizeof missing_patterns / sizeof *missing_patterns;
    for (size_t i = 0; i < count && !hint.english[0]; i++)
        if (fits(&missing_patterns[i], set, &s))
            hint = missing_patterns[i].hint;
    free(s.parent);
    free(s.valence);
    return hint;
}

/* ------------------------------------------------------------------------------------ duplicates
 */

struct hint edge_hint_duplicate(const struct edge_set *set)
{
    bool every_side = true, both_ways = true, same_way = true, above_two = true;
    for (int64_t e = 0; e < set->count; e++) {
        const struct listed_edge *edge = &set->edges[e];
        every_side = every_side && edge->listed_count == edge->side_count;
        if (edge->listed_count < 2)
            continue;
        both_ways = both_ways && edge->flags & EDGE_LISTED_UP && edge->flags & EDGE_LISTED_DOWN;
        same_way = same_way && !(edge->flags & EDGE_UP && edge->flags & EDGE_DOWN);
        above_two = above_two && edge->side_count > 2;
    }
    if (both_ways)
        return (struct hint){" Each is listed as (i,j) and as (j,i): that is one edge.",
                             " Cada una aparece como (i,j) y como (j,i): es una sola arista."};
    if (every_side)
        return (struct hint){" Every triangle adds its three edges; an edge that a neighbour "
                             "added already must not be added again.",
                             " Cada triángulo añade sus tres aristas; la que ya añadió un vecino "
                             "no debe añadirse otra vez."};
    if (same_way)
        return (struct hint){" Their triangles name them in the same direction, (i,j) and (i,j): "
                             "orientation is not coherent.",
                             " Sus triángulos las nombran en el mismo sentido, (i,j) e (i,j): la "
                             "orientación no es coherente."};
    if (above_two)
        return (struct hint){" All of them have more than two sides of triangles.",
                             " Todas son lado de más de dos triángulos."};
    return NO_HINT;
}

/* -------------------------------------------------------------------------------- wrong entries */

static bool is_used(const struct mesh_view *view, int32_t vertex)
{
    for (int64_t i = 0; i < 3 * (int64_t)view->triangle_count; i++)
        if (view->triangles[i] == vertex)
            return true;
    return false;
}

struct hint edge_hint_extra(const struct mesh_view *view, int32_t a, int32_t b)
{
    if (view->vertex_count > INT16_MAX)
        return (struct hint){
            " Does a number overflow? Here vertex numbers need more than 15 bits, and "
            "i * vertex_count + j more than 31.",
            " ¿Se desborda un número? Aquí los de vértice ocupan más de 15 bits, e "
            "i * vertex_count + j más de 31."};
    if (!is_used(view, a) || !is_used(view, b))
        return (struct hint){" One of them is in no triangle at all.",
                             " Uno de ellos no está en ningún triángulo."};
    return NO_HINT;
}

struct hint edge_hint_self(const struct mesh_view *view, const int32_t *entries,
                           int64_t entry_count, int64_t at)
{
    bool zeros_to_the_end = true;
    for (int64_t i = 2 * at; i < 2 * entry_count; i++)
        zeros_to_the_end = zeros_to_the_end && entries[i] == 0;
    if (zeros_to_the_end)
        return (struct hint){" From there on all is 0: is the count larger than what was written?",
                             " Desde ahí todo es 0: ¿es el número mayor que lo que se escribió?"};
    for (int64_t t = 0; t < view->triangle_count; t++) {
        const int32_t *v = view->triangles + 3 * t;
        int times =
            (v[0] == entries[2 * at]) + (v[1] == entries[2 * at]) + (v[2] == entries[2 * at]);
        if (times > 1)
            return (struct hint){" A triangle with a repeated vertex gives no such edge.",
                                 " Un triángulo con un vértice repetido no da esa arista."};
    }
    return NO_HINT;
}

struct hint edge_hint_range(const struct mesh_view *view, const int32_t *entry)
{
    if (view->vertex_count > INT16_MAX)
        return edge_hint_extra(view, 0, 0);
    if (entry[0] == -1 || entry[1] == -1)
        return (struct hint){" Is -1 a mark of the program for 'none'?",
                             " ¿Es -1 una marca del programa para decir 'ninguno'?"};
    if (entry[0] == view->vertex_count || entry[1] == view->vertex_count)
        return (struct hint){" Are vertices counted from 1?", " ¿Se cuentan los vértices desde 1?"};
    return NO_HINT;
}
