/* Every query is a walk: around a face along its edges, or around a vertex from face to face. Each
 * step reads one row, once, and takes from it what is to be listed: so n elements cost n accesses,
 * and one more to find the first edge. Time O(n), no memory. */
#include "adjacency-queries.h"

/* Where a walk stands: an edge and its row. */
struct place {
    int32_t edge;
    struct winged_edge row;
};

static struct place at(int32_t edge)
{
    return (struct place){edge, row_of_edge(edge)};
}

/* The edge after this one around a face. */
static int32_t next_of_face(const struct place *place, int32_t face)
{
    return place->row.cd == face ? place->row.ads : place->row.ais;
}

/* The edge after this one around a vertex, counter-clockwise: it is the one before it in the face
 * that leaves the vertex along this edge. */
static int32_t next_of_vertex(const struct place *place, int32_t vertex)
{
    return place->row.vi == vertex ? place->row.ada : place->row.aia;
}

int32_t edges_of_face(int32_t face, int32_t *out, int32_t capacity)
{
    const int32_t first = edge_of_face(face);
    int32_t count = 0, edge = first;
    do {
        struct place place = at(edge);
        out[count++] = edge;
        edge = next_of_face(&place, face);
    } while (edge != first && count < capacity);
    return count;
}

int32_t vertices_of_face(int32_t face, int32_t *out, int32_t capacity)
{
    const int32_t first = edge_of_face(face);
    int32_t count = 0, edge = first;
    do {
        struct place place = at(edge);
        out[count++] = place.row.cd == face ? place.row.vi : place.row.vf; /* where it begins */
        edge = next_of_face(&place, face);
    } while (edge != first && count < capacity);
    return count;
}

int32_t faces_of_face(int32_t face, int32_t *out, int32_t capacity)
{
    const int32_t first = edge_of_face(face);
    int32_t count = 0, edge = first;
    do {
        struct place place = at(edge);
        out[count++] = place.row.cd == face ? place.row.ci : place.row.cd;
        edge = next_of_face(&place, face);
    } while (edge != first && count < capacity);
    return count;
}

int32_t edges_of_vertex(int32_t vertex, int32_t *out, int32_t capacity)
{
    const int32_t first = edge_of_vertex(vertex);
    int32_t count = 0, edge = first;
    do {
        struct place place = at(edge);
        out[count++] = edge;
        edge = next_of_vertex(&place, vertex);
    } while (edge != first && count < capacity);
    return count;
}

int32_t faces_of_vertex(int32_t vertex, int32_t *out, int32_t capacity)
{
    const int32_t first = edge_of_vertex(vertex);
    int32_t count = 0, edge = first;
    do {
        struct place place = at(edge);
        out[count++] = place.row.vi == vertex ? place.row.cd : place.row.ci; /* to its left */
        edge = next_of_vertex(&place, vertex);
    } while (edge != first && count < capacity);
    return count;
}

int32_t vertices_of_vertex(int32_t vertex, int32_t *out, int32_t capacity)
{
    const int32_t first = edge_of_vertex(vertex);
    int32_t count = 0, edge = first;
    do {
        struct place place = at(edge);
        out[count++] = place.row.vi == vertex ? place.row.vf : place.row.vi;
        edge = next_of_vertex(&place, vertex);
    } while (edge != first && count < capacity);
    return count;
}

int32_t edges_of_edge(int32_t edge, int32_t *out, int32_t capacity)
{
    const struct place middle = at(edge);
    const int32_t ends[2] = {middle.row.vi, middle.row.vf};
    int32_t count = 0;
    for (int end = 0; end < 2; end++) {
        int32_t other = next_of_vertex(&middle, ends[end]);
        while (other != edge && count < capacity) {
            struct place place = at(other);
            out[count++] = other;
            other = next_of_vertex(&place, ends[end]);
        }
    }
    return count;
}
