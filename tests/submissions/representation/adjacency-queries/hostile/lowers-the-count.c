/* Finds the runner's count of accesses in the memory behind its own variables, by what changes with
 * each access, and takes back every second one. callgrind counts the calls as well.
 * expect: flagged */
#include "adjacency-queries.h"

/* Where a walk stands: an edge and its row. */
struct place {
    int32_t edge;
    struct winged_edge row;
};

enum { REACH = 40000, CANDIDATES = 2000, MANY = 64, FIXED_ADDRESSES = 1 << 28 };
static int64_t anchor[2];
static volatile int64_t *counter;

/* The counter is the word nearby that is small, and higher by three after three accesses. Only in the
 * program that is counted, whose addresses are low: the sanitizers' would see it. */
static void find_counter(int32_t edge)
{
    static volatile int64_t *small[CANDIDATES];
    static int64_t before[CANDIDATES];
    uintptr_t here = (uintptr_t)anchor;
    int count = 0;
    for (int i = 0; here < FIXED_ADDRESSES && i < REACH && count < CANDIDATES; i++) {
        volatile int64_t *word = (volatile int64_t *)(here - 8 * (uintptr_t)i);
        if (*word < 1 || *word > MANY)
            continue;
        before[count] = *word;
        small[count++] = word;
    }
    for (int i = 0; i < 3; i++)
        row_of_edge(edge);
    for (int i = 0; i < count; i++)
        if (*small[i] == before[i] + 3)
            counter = small[i];
    if (counter)
        *counter -= 3;
}

static struct place at(int32_t edge)
{
    static int odd, tried;
    if (!tried++)
        find_counter(edge);
    if (counter && (odd ^= 1))
        --*counter;
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
