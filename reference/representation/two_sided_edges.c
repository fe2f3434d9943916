/* Edges with two vertices and two faces; see two_sided_edges.h. */
#include "reference/representation/two_sided_edges.h"

#include "reference/representation/boundary_chain.h"
#include "reference/representation/edge_numbers.h"
#include "reference/representation/smoother.h"

#include <stdlib.h>

int two_sided_edge_add(struct two_sided_edge *edge, int32_t from, int32_t to, int32_t face,
                       struct error *err)
{
    if (edge->left < 0) {
        *edge = (struct two_sided_edge){from, to, face, -1};
        return 0;
    }
    if (edge->right >= 0)
        return error_set(err, "edge {%d,%d} is in faces %d, %d and %d: it can have two", from, to,
                         edge->left, edge->right, face);
    if (edge->from == from)
        return error_set(err, "edge {%d,%d} runs the same way in faces %d and %d", from, to,
                         edge->left, face);
    edge->right = face;
    return 0;
}

int two_sided_edges_check(const struct two_sided_edges *edges, struct error *err)
{
    for (int32_t e = 0; e < edges->count; e++) {
        const struct two_sided_edge *edge = &edges->table[e];
        if (edge->from < 0 || edge->from >= edges->vertex_count || edge->to < 0 ||
            edge->to >= edges->vertex_count || edge->from == edge->to)
            return error_set(err, "edge %d joins vertices %d and %d of %d", e, edge->from, edge->to,
                             edges->vertex_count);
        if (edge->left < 0 || edge->left >= edges->face_count || edge->right < -1 ||
            edge->right >= edges->face_count || edge->left == edge->right)
            return error_set(err, "edge %d has face %d at its left and %d at its right, of %d", e,
                             edge->left, edge->right, edges->face_count);
    }
    return edge_numbers_check(edges->count ? &edges->table[0].from : NULL,
                              sizeof *edges->table / sizeof(int32_t), edges->count,
                              edges->vertex_count, err);
}

int64_t two_sided_pairs(const struct two_sided_edges *edges, int32_t *pairs)
{
    for (int64_t e = 0; e < edges->count; e++) {
        int32_t u = edges->table[e].from, v = edges->table[e].to;
        pairs[2 * e] = u < v ? u : v;
        pairs[2 * e + 1] = u < v ? v : u;
    }
    return edges->count;
}

int32_t two_sided_boundary(const struct two_sided_edges *edges, int32_t *vertices,
                           int32_t *loop_starts, struct error *err)
{
    int64_t count = 0;
    for (int64_t e = 0; e < edges->count; e++)
        count += edges->table[e].right < 0;
    int32_t *sides = malloc(2 * (size_t)count * sizeof *sides + 1);
    if (!sides)
        return error_set(err, "out of memory: %lld boundary edges", (long long)count);
    count = 0;
    for (int64_t e = 0; e < edges->count; e++)
        if (edges->table[e].right < 0) {
            sides[2 * count] = edges->table[e].from;
            sides[2 * count + 1] = edges->table[e].to;
            count++;
        }
    int32_t loops = boundary_chain(sides, count, edges->vertex_count, vertices, loop_starts, err);
    free(sides);
    return loops;
}

int two_sided_smooth(const struct two_sided_edges *edges, float *positions, struct error *err)
{
    struct smoother smoother;
    if (smoother_init(&smoother, edges->vertex_count, err))
        return -1;
    for (int64_t e = 0; e < edges->count; e++) {
        const struct two_sided_edge *edge = &edges->table[e];
        smoother_add_edge(&smoother, positions, edge->from, edge->to);
        if (edge->right < 0) {
            smoother_fix(&smoother, edge->from);
            smoother_fix(&smoother, edge->to);
        }
    }
    smoother_apply(&smoother, positions);
    smoother_release(&smoother);
    return 0;
}

/* Each face at the vertex has one side that starts there. */
int32_t two_sided_faces_around(const struct two_sided_edges *edges, int32_t vertex, int32_t *faces,
                               int32_t capacity)
{
    int32_t found = 0;
    for (int64_t e = 0; e < edges->count; e++) {
        const struct two_sided_edge *edge = &edges->table[e];
        int32_t face = edge->from == vertex ? edge->left : edge->to == vertex ? edge->right : -1;
        if (face < 0)
            continue;
        if (found < capacity)
            faces[found] = face;
        found++;
    }
    return found;
}

int32_t two_sided_vertices_around(const struct two_sided_edges *edges, int32_t vertex,
                                  int32_t *vertices, int32_t capacity)
{
    int32_t found = 0;
    for (int64_t e = 0; e < edges->count; e++) {
        const struct two_sided_edge *edge = &edges->table[e];
        if (edge->from != vertex && edge->to != vertex)
            continue;
        if (found < capacity)
            vertices[found] = edge->from == vertex ? edge->to : edge->from;
        found++;
    }
    return found;
}

bool two_sided_is_edge(const struct two_sided_edges *edges, int32_t u, int32_t v)
{
    for (int64_t e = 0; e < edges->count; e++) {
        const struct two_sided_edge *edge = &edges->table[e];
        if ((edge->from == u && edge->to == v) || (edge->from == v && edge->to == u))
            return true;
    }
    return false;
}
