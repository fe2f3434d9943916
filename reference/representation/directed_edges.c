/* Directed edges: building, checking, and back; see directed_edges.h. */
#include "reference/representation/directed_edges.h"

#include "reference/representation/sides.h"

#include <stdlib.h>
#include <string.h>

void directed_edges_release(struct directed_edge_mesh *de)
{
    free(de->positions);
    free(de->vertex_edge);
    free(de->edges);
    *de = (struct directed_edge_mesh){0};
}

static int allocate(struct directed_edge_mesh *de, const struct mesh *mesh, struct error *err)
{
    size_t vertex_count = (size_t)mesh->vertex_count;
    size_t edge_count = 3 * (size_t)mesh->triangle_count;
    *de = (struct directed_edge_mesh){.positions = malloc(12 * vertex_count + 1),
                                      .vertex_edge = malloc(4 * vertex_count + 1),
                                      .edges = malloc(edge_count * sizeof *de->edges + 1),
                                      .vertex_count = mesh->vertex_count,
                                      .triangle_count = mesh->triangle_count};
    if (de->positions && de->vertex_edge && de->edges)
        return 0;
    directed_edges_release(de);
    error_set(err, "out of memory: directed edges of %d triangles", mesh->triangle_count);
    return -1;
}

static void fill_edges(struct directed_edge_mesh *de, const struct mesh *mesh, const int32_t *twin)
{
    for (int32_t e = 0; e < 3 * mesh->triangle_count; e++) {
        int32_t end = mesh->triangles[directed_edge_next(e)];
        de->edges[e] = (struct directed_edge){mesh->triangles[e],
                                              twin[e] >= 0 ? twin[e] : ~de->vertex_edge[end]};
    }
}

int directed_edges_build(struct directed_edge_mesh *de, const struct mesh *mesh, struct error *err)
{
    if (allocate(de, mesh, err))
        return -1;
    struct polygons polygons = polygons_of_mesh(mesh);
    int32_t *twin = malloc(12 * (size_t)mesh->triangle_count + 1);
    if (!twin || sides_match(&polygons, twin, err) ||
        sides_fans(&polygons, twin, de->vertex_edge, err)) {
        if (!twin)
            error_set(err, "out of memory: directed edges of %d triangles", mesh->triangle_count);
        free(twin);
        directed_edges_release(de);
        return -1;
    }
    fill_edges(de, mesh, twin);
    free(twin);
    if (mesh->vertex_count)
        memcpy(de->positions, mesh->positions, 12 * (size_t)mesh->vertex_count);
    return 0;
}

/* -- checking ------------------------------------------------------------------------------- */

static int32_t end_of(const struct directed_edge_mesh *de, int32_t edge)
{
    return de->edges[directed_edge_next(edge)].vertex;
}

static int check_boundary_edge(const struct directed_edge_mesh *de, int32_t e, struct error *err)
{
    int32_t next = ~de->edges[e].neighbour;
    if (next >= 3 * de->triangle_count || de->edges[next].neighbour >= 0 ||
        de->edges[next].vertex != end_of(de, e) || next != de->vertex_edge[de->edges[next].vertex])
        return error_set(err, "edge %d leads to %d, which is not the next of its boundary loop", e,
                         next);
    return 0;
}

static int check_edge(const struct directed_edge_mesh *de, int32_t e, struct error *err)
{
    int32_t v = de->edges[e].vertex, n = de->edges[e].neighbour;
    if (v == end_of(de, e))
        return error_set(err, "triangle %d is degenerate: it names vertex %d twice", e / 3, v);
    if (n < 0)
        return check_boundary_edge(de, e, err);
    if (n >= 3 * de->triangle_count || n == e || de->edges[n].neighbour != e)
        return error_set(err, "edge %d is not the neighbour of its neighbour %d", e, n);
    if (de->edges[n].vertex != end_of(de, e) || end_of(de, n) != v)
        return error_set(err, "edges %d and %d are neighbours but join different vertices", e, n);
    return 0;
}

/* Counts the edges that turning from the vertex's own edge meets; -1 when they are no fan. */
static int32_t fan_length(const struct directed_edge_mesh *de, int32_t vertex)
{
    int32_t first = de->vertex_edge[vertex], e = first, length = 0;
    do {
        if (de->edges[e].vertex != vertex || ++length > 3 * de->triangle_count)
            return -1;
        e = directed_edge_turn_left(de, e);
    } while (e >= 0 && e != first);
    return e < 0 && !directed_edge_on_boundary(de, vertex) ? -1 : length;
}

static int check_fans(const struct directed_edge_mesh *de, int32_t *valence, struct error *err)
{
    for (int32_t e = 0; e < 3 * de->triangle_count; e++)
        valence[de->edges[e].vertex]++;
    for (int32_t v = 0; v < de->vertex_count; v++) {
        int32_t e = de->vertex_edge[v];
        if (e == -1)
            continue;
        if (e < 0 || e >= 3 * de->triangle_count || de->edges[e].vertex != v)
            return error_set(err, "vertex %d has edge %d, which does not leave it", v, e);
        if (fan_length(de, v) != valence[v])
            return error_set(err, "vertex %d: turning from edge %d does not meet its %d triangles",
                             v, e, valence[v]);
    }
    return 0;
}

int directed_edges_check(const struct directed_edge_mesh *de, struct error *err)
{
    for (int32_t e = 0; e < 3 * de->triangle_count; e++) {
        int32_t v = de->edges[e].vertex;
        if (v < 0 || v >= de->vertex_count || de->vertex_edge[v] < 0)
            return error_set(err, "edge %d starts at %d, which is no vertex in use", e, v);
    }
    for (int32_t e = 0; e < 3 * de->triangle_count; e++)
        if (check_edge(de, e, err))
            return -1;
    int32_t *valence = calloc((size_t)de->vertex_count + 1, sizeof *valence);
    if (!valence)
        return error_set(err, "out of memory: checking %d vertices", de->vertex_count);
    int result = check_fans(de, valence, err);
    free(valence);
    return result;
}

int directed_edges_to_mesh(const struct directed_edge_mesh *de, struct mesh *mesh,
                           struct error *err)
{
    if (mesh_init(mesh, de->vertex_count, de->triangle_count, err))
        return -1;
    if (de->vertex_count)
        memcpy(mesh->positions, de->positions, 12 * (size_t)de->vertex_count);
    for (int32_t e = 0; e < 3 * de->triangle_count; e++)
        mesh->triangles[e] = de->edges[e].vertex;
    return 0;
}
