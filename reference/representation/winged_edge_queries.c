/* The queries of course document 001; see winged_edge_queries.h. */
#include "reference/representation/winged_edge_queries.h"

static void put(int32_t *numbers, int32_t capacity, int32_t place, int32_t number)
{
    if (place < capacity)
        numbers[place] = number;
}

/* Go on to the next side of the face, or to the next that leaves the vertex; false when that is
 * edge `last`, whose row is then not read. */
static bool step(const struct winged_edge_mesh *we, struct winged_side *side, int32_t last)
{
    const struct winged_edge *row = winged_edge_row(we, side->edge);
    int32_t next = row->next[side->way];
    if (next == last)
        return false;
    *side = winged_edge_leaving(we, next, row->vertex[1 - side->way]);
    return true;
}

static bool turn(const struct winged_edge_mesh *we, struct winged_side *side, int32_t last)
{
    const struct winged_edge *row = winged_edge_row(we, side->edge);
    int32_t next = row->previous[side->way];
    if (next == last)
        return false;
    *side = winged_edge_leaving(we, next, row->vertex[side->way]);
    return true;
}

int32_t winged_edge_edges_of_edge(const struct winged_edge_mesh *we, int32_t edge, int32_t *edges,
                                  int32_t capacity)
{
    int32_t count = 0;
    for (int way = 0; way < 2; way++) {
        struct winged_side side = {edge, way};
        while (turn(we, &side, edge))
            put(edges, capacity, count++, side.edge);
    }
    return count;
}

int32_t winged_edge_edges_of_face(const struct winged_edge_mesh *we, int32_t face, int32_t *edges,
                                  int32_t capacity)
{
    struct winged_side first = winged_edge_of_face(we, face), side = first;
    int32_t count = 0;
    do {
        put(edges, capacity, count++, side.edge);
    } while (step(we, &side, first.edge));
    return count;
}

int32_t winged_edge_edges_of_vertex(const struct winged_edge_mesh *we, int32_t vertex,
                                    int32_t *edges, int32_t capacity)
{
    struct winged_side first = winged_edge_of_vertex(we, vertex), side = first;
    int32_t count = 0;
    do {
        put(edges, capacity, count++, side.edge);
    } while (turn(we, &side, first.edge));
    return count;
}

int32_t winged_edge_vertices_of_face(const struct winged_edge_mesh *we, int32_t face,
                                     int32_t *vertices, int32_t capacity)
{
    struct winged_side first = winged_edge_of_face(we, face), side = first;
    int32_t count = 0;
    do {
        put(vertices, capacity, count++, winged_edge_start(we, side));
    } while (step(we, &side, first.edge));
    return count;
}

int32_t winged_edge_faces_of_face(const struct winged_edge_mesh *we, int32_t face, int32_t *faces,
                                  int32_t capacity)
{
    struct winged_side first = winged_edge_of_face(we, face), side = first;
    int32_t count = 0;
    do {
        int32_t across = winged_edge_face(we, winged_edge_twin(side));
        if (across >= 0)
            put(faces, capacity, count++, across);
    } while (step(we, &side, first.edge));
    return count;
}

int32_t winged_edge_faces_of_vertex(const struct winged_edge_mesh *we, int32_t vertex,
                                    int32_t *faces, int32_t capacity)
{
    struct winged_side first = winged_edge_of_vertex(we, vertex), side = first;
    int32_t count = 0;
    do {
        int32_t face = winged_edge_face(we, side);
        if (face >= 0)
            put(faces, capacity, count++, face);
    } while (turn(we, &side, first.edge));
    return count;
}
