/* Sides of edges, as half edges have them: a side is an edge and the way in which it is run. */
#include "adjacency-queries.h"

/* One way of running an edge; `from` is where it begins. */
struct side {
    int32_t edge, from, to, left, right, next, turn; /* next of its face, next around `from` */
};

static struct side side_from(int32_t edge, int32_t vertex)
{
    struct winged_edge row = row_of_edge(edge);
    if (row.vi == vertex)
        return (struct side){edge, row.vi, row.vf, row.cd, row.ci, row.ads, row.ada};
    return (struct side){edge, row.vf, row.vi, row.ci, row.cd, row.ais, row.aia};
}

static struct side side_in(int32_t edge, int32_t face)
{
    struct winged_edge row = row_of_edge(edge);
    if (row.cd == face)
        return (struct side){edge, row.vi, row.vf, row.cd, row.ci, row.ads, row.ada};
    return (struct side){edge, row.vf, row.vi, row.ci, row.cd, row.ais, row.aia};
}

enum what { THE_EDGE, ITS_START, ITS_END, ITS_LEFT, ITS_RIGHT };

static int32_t pick(const struct side *side, enum what what)
{
    const int32_t all[] = {side->edge, side->from, side->to, side->left, side->right};
    return all[what];
}

static int32_t around_face(int32_t face, enum what what, int32_t *out)
{
    struct side first = side_in(edge_of_face(face), face), side = first;
    int32_t count = 0;
    for (;;) {
        out[count++] = pick(&side, what);
        if (side.next == first.edge)
            return count;
        side = side_from(side.next, side.to);
    }
}

static int32_t around_vertex(int32_t vertex, int32_t edge, enum what what, int32_t *out)
{
    struct side first = side_from(edge, vertex), side = first;
    int32_t count = 0;
    for (;;) {
        out[count++] = pick(&side, what);
        if (side.turn == first.edge)
            return count;
        side = side_from(side.turn, vertex);
    }
}

int32_t edges_of_face(int32_t face, int32_t *out, int32_t capacity)
{
    (void)capacity;
    return around_face(face, THE_EDGE, out);
}

int32_t vertices_of_face(int32_t face, int32_t *out, int32_t capacity)
{
    (void)capacity;
    return around_face(face, ITS_START, out);
}

int32_t faces_of_face(int32_t face, int32_t *out, int32_t capacity)
{
    (void)capacity;
    return around_face(face, ITS_RIGHT, out);
}

int32_t edges_of_vertex(int32_t vertex, int32_t *out, int32_t capacity)
{
    (void)capacity;
    return around_vertex(vertex, edge_of_vertex(vertex), THE_EDGE, out);
}

int32_t faces_of_vertex(int32_t vertex, int32_t *out, int32_t capacity)
{
    (void)capacity;
    return around_vertex(vertex, edge_of_vertex(vertex), ITS_LEFT, out);
}

int32_t vertices_of_vertex(int32_t vertex, int32_t *out, int32_t capacity)
{
    (void)capacity;
    return around_vertex(vertex, edge_of_vertex(vertex), ITS_END, out);
}

int32_t edges_of_edge(int32_t edge, int32_t *out, int32_t capacity)
{
    struct winged_edge row = row_of_edge(edge);
    int32_t count = around_vertex(row.vi, edge, THE_EDGE, out);
    (void)capacity;
    /* Each walk begins with the edge itself, whose place its last edge takes. */
    out[0] = out[--count];
    int32_t more = around_vertex(row.vf, edge, THE_EDGE, out + count);
    out[count] = out[count + --more];
    return count + more;
}
