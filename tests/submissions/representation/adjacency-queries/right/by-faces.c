/* Goes around a vertex face by face: in each face, one edge comes in and the next one goes out. */
#include "adjacency-queries.h"

#include <stdbool.h>

/* An edge, and the face in which a walk stands beside it. */
struct step {
    struct winged_edge row;
    int32_t edge, face;
};

static struct step step_at(int32_t edge, int32_t face)
{
    struct step step = {row_of_edge(edge), edge, face};
    return step;
}

static bool is_forwards(const struct step *step)
{
    return step->row.cd == step->face;
}

static int32_t start_of(const struct step *step)
{
    return is_forwards(step) ? step->row.vi : step->row.vf;
}

static int32_t across(const struct step *step)
{
    return is_forwards(step) ? step->row.ci : step->row.cd;
}

static int32_t go_on(struct step *step)
{
    return step->edge = is_forwards(step) ? step->row.ads : step->row.ais;
}

static int32_t go_back(struct step *step)
{
    return step->edge = is_forwards(step) ? step->row.ada : step->row.aia;
}

int32_t edges_of_face(int32_t face, int32_t *out, int32_t capacity)
{
    int32_t first = edge_of_face(face), count = 0;
    struct step step = {.edge = first};
    do {
        step = step_at(step.edge, face);
        out[count++] = step.edge;
    } while (go_on(&step) != first && count < capacity);
    return count;
}

int32_t vertices_of_face(int32_t face, int32_t *out, int32_t capacity)
{
    int32_t first = edge_of_face(face), count = 0;
    struct step step = {.edge = first};
    do {
        step = step_at(step.edge, face);
        out[count++] = start_of(&step);
    } while (go_on(&step) != first && count < capacity);
    return count;
}

int32_t faces_of_face(int32_t face, int32_t *out, int32_t capacity)
{
    int32_t first = edge_of_face(face), count = 0;
    struct step step = {.edge = first};
    do {
        step = step_at(step.edge, face);
        out[count++] = across(&step);
    } while (go_on(&step) != first && count < capacity);
    return count;
}

/* The face that leaves a vertex along an edge, and the next one around the vertex: across the edge
 * by which this one comes back. */
static struct step leaving(int32_t edge, int32_t vertex)
{
    struct step step = step_at(edge, -1);
    step.face = step.row.vi == vertex ? step.row.cd : step.row.ci;
    return step;
}

int32_t edges_of_vertex(int32_t vertex, int32_t *out, int32_t capacity)
{
    int32_t first = edge_of_vertex(vertex), count = 0;
    struct step step = {.edge = first};
    do {
        step = leaving(step.edge, vertex);
        out[count++] = step.edge;
    } while (go_back(&step) != first && count < capacity);
    return count;
}

int32_t faces_of_vertex(int32_t vertex, int32_t *out, int32_t capacity)
{
    int32_t first = edge_of_vertex(vertex), count = 0;
    struct step step = {.edge = first};
    do {
        step = leaving(step.edge, vertex);
        out[count++] = step.face;
    } while (go_back(&step) != first && count < capacity);
    return count;
}

int32_t vertices_of_vertex(int32_t vertex, int32_t *out, int32_t capacity)
{
    int32_t first = edge_of_vertex(vertex), count = 0;
    struct step step = {.edge = first};
    do {
        step = leaving(step.edge, vertex);
        out[count++] = is_forwards(&step) ? step.row.vf : step.row.vi;
    } while (go_back(&step) != first && count < capacity);
    return count;
}

int32_t edges_of_edge(int32_t edge, int32_t *out, int32_t capacity)
{
    struct winged_edge row = row_of_edge(edge);
    int32_t count = 0;
    for (int32_t vertex = row.vi;; vertex = row.vf) {
        struct step step = {.edge = vertex == row.vi ? row.ada : row.aia};
        while (step.edge != edge && count < capacity) {
            step = leaving(step.edge, vertex);
            out[count++] = step.edge;
            go_back(&step);
        }
        if (vertex == row.vf)
            return count;
    }
}
