/* Hints for elements of a mesh; see topology_hints.h. */
#include "graders/library/topology_hints.h"

#include <stddef.h>

enum { LARGE = 8 };

/* ---------------------------------------------------------------------------------------- edges */

static const struct face_edge *edge_of(const void *context, int64_t edge)
{
    const struct face_topology *t = context;
    return &t->edges[edge];
}

bool topology_edge_in_last_face(const void *context, int64_t edge)
{
    const struct face_topology *t = context;
    return t->table.face_count > 1 && topology_edge_face(t, edge, 0) == t->table.face_count - 1;
}

bool topology_edge_at_first(const void *context, int64_t edge)
{
    return edge_of(context, edge)->low == 0;
}

bool topology_edge_at_last(const void *context, int64_t edge)
{
    const struct face_topology *t = context;
    return t->edges[edge].high == t->table.vertex_count - 1;
}

bool topology_edge_elsewhere(const void *context, int64_t edge)
{
    const struct face_topology *t = context;
    return t->component[topology_edge_face(t, edge, 0)] > 0;
}

bool topology_edge_never_up(const void *context, int64_t edge)
{
    return edge_of(context, edge)->up_count == 0;
}

bool topology_edge_never_down(const void *context, int64_t edge)
{
    return edge_of(context, edge)->down_count == 0;
}

bool topology_edge_closing(const void *context, int64_t edge)
{
    const struct face_topology *t = context;
    const struct face_edge *e = &t->edges[edge];
    for (int64_t i = 0; i < topology_side_count(e); i++) {
        int64_t count, side = t->uses[e->first_use + i];
        int64_t first = topology_face(t, t->corner_face[side], &count);
        if (side != first + count - 1)
            return false;
    }
    return true;
}

bool topology_edge_on_boundary(const void *context, int64_t edge)
{
    return topology_side_count(edge_of(context, edge)) == 1;
}

bool topology_edge_inside(const void *context, int64_t edge)
{
    return topology_side_count(edge_of(context, edge)) == 2;
}

bool topology_edge_nonmanifold(const void *context, int64_t edge)
{
    return topology_side_count(edge_of(context, edge)) > 2;
}

bool topology_edge_at_large(const void *context, int64_t edge)
{
    const struct face_edge *e = edge_of(context, edge);
    return topology_vertex_large(context, e->low) || topology_vertex_large(context, e->high);
}

const struct hint_rule topology_edges_lost[TOPOLOGY_EDGES_LOST] = {
    {topology_edge_in_last_face,
     HINT_ALL_OF_THESE,
     {"Only edges of the last face are lost: does the loop stop one too early?",
      "Solo se pierden aristas de la última cara: ¿acaba el bucle uno antes de tiempo?"}},
    {topology_edge_at_last,
     HINT_ALL_OF_THESE,
     {"Just the edges of the last vertex are lost: does a loop over the vertices stop one too "
      "early?",
      "Se pierden justo las aristas del último vértice: ¿acaba un bucle sobre los vértices uno "
      "antes de tiempo?"}},
    {topology_edge_at_first,
     HINT_ALL_OF_THESE,
     {"Just the edges of vertex 0 are lost: is 0 taken to mean 'none'?",
      "Se pierden justo las aristas del vértice 0: ¿se usa el 0 para decir 'ninguno'?"}},
    {topology_edge_elsewhere,
     HINT_ONLY_THESE,
     {"All of them lie in other components than face 0: a walk over neighbours does not reach "
      "these.",
      "Todas están en otras componentes que la cara 0: un recorrido por vecinos no llega hasta "
      "ellas."}},
    {topology_edge_never_up,
     HINT_ALL_OF_THESE,
     {"Lost are just the edges that no face runs from the smaller to the larger number.",
      "Se pierden justo las aristas que ninguna cara recorre del número menor al mayor."}},
    {topology_edge_never_down,
     HINT_ALL_OF_THESE,
     {"Lost are just the edges that no face runs from the larger to the smaller number.",
      "Se pierden justo las aristas que ninguna cara recorre del número mayor al menor."}},
    {topology_edge_closing,
     HINT_ALL_OF_THESE,
     {"Lost is the side from the last corner of a face back to the first.",
      "Se pierde el lado que va del último vértice de una cara al primero."}},
    {topology_edge_on_boundary,
     HINT_ONLY_THESE,
     {"Only boundary edges are lost: these have just one face.",
      "Solo se pierden aristas de borde: tienen una sola cara."}},
    {topology_edge_nonmanifold,
     HINT_ONLY_THESE,
     {"Only edges of more than two faces are lost.",
      "Solo se pierden aristas de más de dos caras."}},
    {topology_edge_at_large,
     HINT_ONLY_THESE,
     {"All of them are at vertices with many neighbours: is a row of fixed length full?",
      "Todas tocan vértices con muchos vecinos: ¿se llena una fila de longitud fija?"}},
    {topology_edge_inside,
     HINT_ALL_OF_THESE,
     {"Lost are just the edges between two faces.",
      "Se pierden justo las aristas que están entre dos caras."}},
};

/* ------------------------------------------------------------------------------------- vertices */

/* NULL for an isolated vertex. */
static const struct face_vertex *vertex_of(const void *context, int64_t vertex)
{
    const struct face_topology *t = context;
    int64_t used = topology_find_vertex(t, (int32_t)vertex);
    return used < 0 ? NULL : &t->vertices[used];
}

bool topology_vertex_first(const void *context, int64_t vertex)
{
    (void)context;
    return vertex == 0;
}

bool topology_vertex_last(const void *context, int64_t vertex)
{
    const struct face_topology *t = context;
    return vertex == t->table.vertex_count - 1;
}

bool topology_vertex_isolated(const void *context, int64_t vertex)
{
    return !vertex_of(context, vertex);
}

bool topology_vertex_on_boundary(const void *context, int64_t vertex)
{
    const struct face_vertex *found = vertex_of(context, vertex);
    return found && found->boundary_count > 0;
}

bool topology_vertex_nonmanifold(const void *context, int64_t vertex)
{
    const struct face_vertex *found = vertex_of(context, vertex);
    return found && !found->is_manifold;
}

bool topology_vertex_elsewhere(const void *context, int64_t vertex)
{
    const struct face_vertex *found = vertex_of(context, vertex);
    return found && found->component > 0;
}

bool topology_vertex_large(const void *context, int64_t vertex)
{
    const struct face_vertex *found = vertex_of(context, vertex);
    return found && found->face_count > LARGE;
}

const struct hint_rule topology_vertices_lost[TOPOLOGY_VERTICES_LOST] = {
    {topology_vertex_last,
     HINT_ALL_OF_THESE,
     {"Only the last vertex is at fault: does a loop stop one too early?",
      "Solo falla el último vértice: ¿acaba un bucle uno antes de tiempo?"}},
    {topology_vertex_first,
     HINT_ALL_OF_THESE,
     {"Only vertex 0 is at fault: is 0 taken to mean 'none'?",
      "Solo falla el vértice 0: ¿se usa el 0 para decir 'ninguno'?"}},
    {topology_vertex_isolated,
     HINT_ONLY_THESE,
     {"Only vertices that no face uses are at fault.",
      "Solo fallan vértices que ninguna cara usa."}},
    {topology_vertex_nonmanifold,
     HINT_ONLY_THESE,
     {"Only vertices are at fault whose faces are not one fan.",
      "Solo fallan vértices cuyas caras no forman un solo abanico."}},
    {topology_vertex_elsewhere,
     HINT_ONLY_THESE,
     {"All of them lie in other components than face 0: a walk over neighbours does not reach "
      "these.",
      "Todos están en otras componentes que la cara 0: un recorrido por vecinos no llega hasta "
      "ellos."}},
    {topology_vertex_on_boundary,
     HINT_ONLY_THESE,
     {"Only vertices on the boundary are at fault.", "Solo fallan vértices del borde."}},
    {topology_vertex_large,
     HINT_ONLY_THESE,
     {"Only vertices with many neighbours are at fault: is a row of fixed length full?",
      "Solo fallan vértices con muchos vecinos: ¿se llena una fila de longitud fija?"}},
};

/* ---------------------------------------------------------------------------------------- faces */

bool topology_face_first(const void *context, int64_t face)
{
    (void)context;
    return face == 0;
}

bool topology_face_last(const void *context, int64_t face)
{
    const struct face_topology *t = context;
    return face == t->table.face_count - 1;
}

bool topology_face_degenerate(const void *context, int64_t face)
{
    const struct face_topology *t = context;
    return t->component[face] >= 0 && t->patch[face] < 0;
}

bool topology_face_elsewhere(const void *context, int64_t face)
{
    const struct face_topology *t = context;
    return t->component[face] > 0;
}

bool topology_face_on_boundary(const void *context, int64_t face)
{
    const struct face_topology *t = context;
    if (t->patch[face] < 0)
        return false;
    int64_t count, first = topology_face(t, face, &count);
    for (int64_t c = first; c < first + count; c++)
        if (topology_edge_on_boundary(t, t->side_edge[c]))
            return true;
    return false;
}

const struct hint_rule topology_faces_lost[TOPOLOGY_FACES_LOST] = {
    {topology_face_last,
     HINT_ALL_OF_THESE,
     {"Only the last face is at fault: does the loop stop one too early?",
      "Solo falla la última cara: ¿acaba el bucle uno antes de tiempo?"}},
    {topology_face_first,
     HINT_ALL_OF_THESE,
     {"Only face 0 is at fault: is 0 taken to mean 'none'?",
      "Solo falla la cara 0: ¿se usa el 0 para decir 'ninguna'?"}},
    {topology_face_degenerate,
     HINT_ONLY_THESE,
     {"Only faces that name a vertex twice are at fault.",
      "Solo fallan caras que nombran un vértice dos veces."}},
    {topology_face_elsewhere,
     HINT_ONLY_THESE,
     {"All of them lie in other components than face 0: a walk over neighbours does not reach "
      "these.",
      "Todas están en otras componentes que la cara 0: un recorrido por vecinos no llega hasta "
      "ellas."}},
    {topology_face_on_boundary,
     HINT_ONLY_THESE,
     {"Only faces with a boundary edge are at fault.",
      "Solo fallan caras con una arista de borde."}},
};

/* ---------------------------------------------------------------------------------------- loops */

bool topology_loop_not_first(const void *context, int64_t loop)
{
    (void)context;
    return loop > 0;
}

bool topology_loop_of_three(const void *context, int64_t loop)
{
    const struct face_topology *t = context;
    return t->loop_first[loop + 1] - t->loop_first[loop] == 3;
}

bool topology_loop_elsewhere(const void *context, int64_t loop)
{
    const struct face_topology *t = context;
    return topology_vertex_elsewhere(t, t->loop_vertices[t->loop_first[loop]]);
}

const struct hint_rule topology_loops_lost[TOPOLOGY_LOOPS_LOST] = {
    {topology_loop_of_three,
     HINT_ALL_OF_THESE,
     {"Only loops of three edges are lost.", "Solo se pierden bucles de tres aristas."}},
    {topology_loop_elsewhere,
     HINT_ONLY_THESE,
     {"All of them lie in other components than face 0.",
      "Todos están en otras componentes que la cara 0."}},
    {topology_loop_not_first,
     HINT_ALL_OF_THESE,
     {"Only the first loop is found.", "Solo se encuentra el primer bucle."}},
};
