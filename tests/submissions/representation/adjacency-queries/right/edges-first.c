/* Lists the edges first, clockwise around vertices, and then turns each into what is asked for. */
#include "adjacency-queries.h"

int32_t edges_of_face(int32_t face, int32_t *out, int32_t capacity)
{
    int32_t count = 0;
    for (int32_t edge = edge_of_face(face); count < capacity;) {
        struct winged_edge row = row_of_edge(edge);
        out[count++] = edge;
        edge = row.cd == face ? row.ads : row.ais;
        if (edge == out[0])
            break;
    }
    return count;
}

int32_t edges_of_vertex(int32_t vertex, int32_t *out, int32_t capacity)
{
    int32_t count = 0;
    for (int32_t edge = edge_of_vertex(vertex); count < capacity;) {
        struct winged_edge row = row_of_edge(edge);
        out[count++] = edge;
        edge = row.vi == vertex ? row.ais : row.ads; /* after it in the face that comes in by it */
        if (edge == out[0])
            break;
    }
    return count;
}

int32_t vertices_of_face(int32_t face, int32_t *out, int32_t capacity)
{
    int32_t count = edges_of_face(face, out, capacity);
    for (int32_t i = 0; i < count; i++) {
        struct winged_edge row = row_of_edge(out[i]);
        out[i] = row.ci == face ? row.vi : row.vf; /* where it ends */
    }
    return count;
}

int32_t faces_of_face(int32_t face, int32_t *out, int32_t capacity)
{
    int32_t count = edges_of_face(face, out, capacity);
    for (int32_t i = 0; i < count; i++) {
        struct winged_edge row = row_of_edge(out[i]);
        out[i] = row.cd + row.ci - face;
    }
    return count;
}

int32_t faces_of_vertex(int32_t vertex, int32_t *out, int32_t capacity)
{
    int32_t count = edges_of_vertex(vertex, out, capacity);
    for (int32_t i = 0; i < count; i++) {
        struct winged_edge row = row_of_edge(out[i]);
        out[i] = row.vf == vertex ? row.cd : row.ci; /* to its right, as seen from the vertex */
    }
    return count;
}

int32_t vertices_of_vertex(int32_t vertex, int32_t *out, int32_t capacity)
{
    int32_t count = edges_of_vertex(vertex, out, capacity);
    for (int32_t i = 0; i < count; i++) {
        struct winged_edge row = row_of_edge(out[i]);
        out[i] = row.vi + row.vf - vertex;
    }
    return count;
}

/* The edges of both ends, without the edge itself. */
int32_t edges_of_edge(int32_t edge, int32_t *out, int32_t capacity)
{
    struct winged_edge row = row_of_edge(edge);
    int32_t count = edges_of_vertex(row.vi, out, capacity), kept = 0;
    count += edges_of_vertex(row.vf, out + count, capacity - count);
    for (int32_t i = 0; i < count; i++)
        if (out[i] != edge)
            out[kept++] = out[i];
    return kept;
}
