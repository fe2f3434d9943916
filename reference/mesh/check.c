/* Topology checks; see check.h. */
#include "reference/mesh/check.h"

#include "reference/mesh/groups.h"

#include <stdlib.h>
#include <string.h>

static const struct finding nothing_found = {0, -1};

static void note(struct finding *found, int64_t element)
{
    if (found->count++ == 0)
        found->first = element;
}

struct finding mesh_boundary_edges(const struct edge_list *list)
{
    struct finding found = nothing_found;
    for (int64_t e = 0; e < list->edge_count; e++)
        if (edge_use_count(&list->edges[e]) == 1)
            note(&found, e);
    return found;
}

struct finding mesh_nonmanifold_edges(const struct edge_list *list)
{
    struct finding found = nothing_found;
    for (int64_t e = 0; e < list->edge_count; e++)
        if (edge_use_count(&list->edges[e]) > 2)
            note(&found, e);
    return found;
}

struct finding mesh_incoherent_edges(const struct edge_list *list)
{
    struct finding found = nothing_found;
    for (int64_t e = 0; e < list->edge_count; e++)
        if (edge_use_count(&list->edges[e]) == 2 && list->edges[e].forward_count != 1)
            note(&found, e);
    return found;
}

struct finding mesh_degenerate_triangles(const struct mesh *mesh)
{
    struct finding found = nothing_found;
    for (int64_t t = 0; t < mesh->triangle_count; t++)
        if (triangle_is_degenerate(mesh->triangles + 3 * t))
            note(&found, t);
    return found;
}

/* -- duplicate triangles ---------------------------------------------------------------------- */

/* The corner that is lowest (rank 0), middle (1) or highest (2) in number. */
static int32_t ranked_corner(const struct mesh *mesh, int32_t triangle, int rank)
{
    const int32_t *t = mesh->triangles + 3 * (int64_t)triangle;
    int32_t low = t[0] < t[1] ? t[0] : t[1], high = t[0] < t[1] ? t[1] : t[0];
    if (rank == 0)
        return low < t[2] ? low : t[2];
    if (rank == 2)
        return high > t[2] ? high : t[2];
    return t[2] < low ? low : t[2] > high ? high : t[2];
}

static bool same_corners(const struct mesh *mesh, int32_t s, int32_t t)
{
    for (int rank = 0; rank < 3; rank++)
        if (ranked_corner(mesh, s, rank) != ranked_corner(mesh, t, rank))
            return false;
    return true;
}

/* Stable counting sort of all triangles by one corner; `starts` has vertex_count + 1 entries. */
static void sort_triangles(const struct mesh *mesh, int rank, const int32_t *from, int32_t *to,
                           int32_t *starts)
{
    memset(starts, 0, ((size_t)mesh->vertex_count + 1) * sizeof *starts);
    for (int64_t i = 0; i < mesh->triangle_count; i++)
        starts[ranked_corner(mesh, from[i], rank) + 1]++;
    for (int64_t v = 0; v < mesh->vertex_count; v++)
        starts[v + 1] += starts[v];
    for (int64_t i = 0; i < mesh->triangle_count; i++)
        to[starts[ranked_corner(mesh, from[i], rank)]++] = from[i];
}

int mesh_duplicate_triangles(const struct mesh *mesh, struct finding *found, struct error *err)
{
    *found = nothing_found;
    size_t count = (size_t)mesh->triangle_count;
    int32_t *order = calloc(count + 1, sizeof *order);
    int32_t *other = calloc(count + 1, sizeof *other);
    int32_t *starts = malloc(((size_t)mesh->vertex_count + 1) * sizeof *starts);
    bool ok = order && other && starts;
    if (ok) {
        for (int32_t t = 0; t < mesh->triangle_count; t++)
            order[t] = t;
        sort_triangles(mesh, 2, order, other, starts);
        sort_triangles(mesh, 1, other, order, starts);
        sort_triangles(mesh, 0, order, other, starts);
        for (size_t i = 1; i < count; i++)
            if (same_corners(mesh, other[i - 1], other[i])) {
                found->count++;
                if (found->first < 0 || other[i] < found->first)
                    found->first = other[i];
            }
    }
    free(order);
    free(other);
    free(starts);
    return ok ? 0 : error_set(err, "out of memory: sorting %d triangles", mesh->triangle_count);
}

/* -- vertices --------------------------------------------------------------------------------- */

int mesh_isolated_vertices(const struct mesh *mesh, struct finding *found, struct error *err)
{
    *found = nothing_found;
    uint8_t *is_used = calloc((size_t)mesh->vertex_count + 1, 1);
    if (!is_used)
        return error_set(err, "out of memory: marking %d vertices", mesh->vertex_count);
    for (int64_t corner = 0; corner < 3 * (int64_t)mesh->triangle_count; corner++)
        is_used[mesh->triangles[corner]] = 1;
    for (int64_t v = 0; v < mesh->vertex_count; v++)
        if (!is_used[v])
            note(found, v);
    free(is_used);
    return 0;
}

/* Number (3 * triangle + corner) of the corner at vertex v, in the triangle of the given side. */
static int32_t corner_at(const struct mesh *mesh, int32_t side, int32_t v)
{
    int32_t corner = side - side % 3;
    while (mesh->triangles[corner] != v)
        corner++;
    return corner;
}

/* fan_count[v] starts as the number of triangles at v; each edge that joins two groups of them
 * takes one away. */
static void join_fans(const struct mesh *mesh, const struct edge_list *list, struct groups *corners,
                      int32_t *fan_count)
{
    for (int64_t t = 0; t < mesh->triangle_count; t++)
        if (!triangle_is_degenerate(mesh->triangles + 3 * t))
            for (int corner = 0; corner < 3; corner++)
                fan_count[mesh->triangles[3 * t + corner]]++;
    for (int64_t e = 0; e < list->edge_count; e++) {
        const struct edge *edge = &list->edges[e];
        const int32_t *uses = list->uses + edge->first_use;
        for (int64_t i = 1; i < edge_use_count(edge); i++)
            for (int end = 0; end < 2; end++) {
                int32_t v = end == 0 ? edge->low : edge->high;
                if (groups_join(corners, corner_at(mesh, uses[0], v), corner_at(mesh, uses[i], v)))
                    fan_count[v]--;
            }
    }
}

int mesh_count_fans(const struct mesh *mesh, const struct edge_list *list, int32_t *fan_counts,
                    struct error *err)
{
    struct groups corners;
    if (groups_init(&corners, 3 * (int64_t)mesh->triangle_count, err))
        return -1;
    for (int64_t v = 0; v < mesh->vertex_count; v++)
        fan_counts[v] = 0;
    join_fans(mesh, list, &corners, fan_counts);
    groups_release(&corners);
    for (int64_t e = 0; e < list->edge_count; e++) {
        const struct edge *edge = &list->edges[e];
        for (int end = 0; end < 2 && edge_use_count(edge) > 2; end++) {
            int32_t v = end == 0 ? edge->low : edge->high;
            fan_counts[v] = fan_counts[v] > 2 ? fan_counts[v] : 2;
        }
    }
    return 0;
}

int mesh_nonmanifold_vertices(const struct mesh *mesh, const struct edge_list *list,
                              struct finding *found, struct error *err)
{
    *found = nothing_found;
    int32_t *fan_counts = malloc(((size_t)mesh->vertex_count + 1) * sizeof *fan_counts);
    int result = fan_counts ? mesh_count_fans(mesh, list, fan_counts, err)
                            : error_set(err, "out of memory: counting fans of %d vertices",
                                        mesh->vertex_count);
    for (int64_t v = 0; result == 0 && v < mesh->vertex_count; v++)
        if (fan_counts[v] > 1)
            note(found, v);
    free(fan_counts);
    return result;
}

/* -- the whole -------------------------------------------------------------------------------- */

/* Vertices that hang together by triangles; those without a triangle are no component. */
static int count_components(const struct mesh *mesh, struct topology *out, struct error *err)
{
    struct groups vertices;
    if (groups_init(&vertices, mesh->vertex_count, err))
        return -1;
    out->component_count = mesh->vertex_count - out->isolated.count;
    for (int64_t t = 0; t < mesh->triangle_count; t++) {
        const int32_t *corner = mesh->triangles + 3 * t;
        out->component_count -= groups_join(&vertices, corner[0], corner[1]);
        out->component_count -= groups_join(&vertices, corner[1], corner[2]);
    }
    groups_release(&vertices);
    return 0;
}

/* As many loops as vertices on the boundary, less one for each edge that joins two groups of them.
 */
static int count_boundary_loops(const struct mesh *mesh, const struct edge_list *list,
                                struct topology *out, struct error *err)
{
    struct groups vertices;
    if (groups_init(&vertices, mesh->vertex_count, err))
        return -1;
    uint8_t *is_counted = calloc((size_t)mesh->vertex_count + 1, 1);
    if (is_counted) {
        out->boundary_loop_count = 0;
        for (int64_t e = 0; e < list->edge_count; e++) {
            const struct edge *edge = &list->edges[e];
            if (edge_use_count(edge) != 1)
                continue;
            out->boundary_loop_count += !is_counted[edge->low] + !is_counted[edge->high];
            is_counted[edge->low] = is_counted[edge->high] = 1;
            out->boundary_loop_count -= groups_join(&vertices, edge->low, edge->high);
        }
    }
    groups_release(&vertices);
    if (!is_counted)
        return error_set(err, "out of memory: marking %d vertices", mesh->vertex_count);
    free(is_counted);
    return 0;
}

static int check_orientable(const struct mesh *mesh, const struct edge_list *list,
                            struct topology *out, struct error *err)
{
    struct groups triangles;
    if (groups_init(&triangles, mesh->triangle_count, err))
        return -1;
    out->is_orientable = true;
    for (int64_t e = 0; e < list->edge_count; e++) {
        const struct edge *edge = &list->edges[e];
        const int32_t *uses = list->uses + edge->first_use;
        if (edge_use_count(edge) == 2 &&
            !groups_join_parity(&triangles, uses[0] / 3, uses[1] / 3, edge->forward_count != 1))
            out->is_orientable = false;
    }
    groups_release(&triangles);
    return 0;
}

int mesh_topology_of_edges(const struct mesh *mesh, const struct edge_list *list,
                           struct topology *topology, struct error *err)
{
    struct topology out = {.vertex_count = mesh->vertex_count,
                           .edge_count = list->edge_count,
                           .triangle_count = mesh->triangle_count,
                           .boundary = mesh_boundary_edges(list),
                           .nonmanifold_edge = mesh_nonmanifold_edges(list),
                           .incoherent = mesh_incoherent_edges(list),
                           .degenerate = mesh_degenerate_triangles(mesh)};
    if (mesh_duplicate_triangles(mesh, &out.duplicate, err) ||
        mesh_isolated_vertices(mesh, &out.isolated, err) ||
        mesh_nonmanifold_vertices(mesh, list, &out.nonmanifold_vertex, err) ||
        count_components(mesh, &out, err) || count_boundary_loops(mesh, list, &out, err) ||
        check_orientable(mesh, list, &out, err))
        return -1;
    out.euler_characteristic = out.vertex_count - out.isolated.count - out.edge_count +
                               out.triangle_count - out.degenerate.count;
    *topology = out;
    return 0;
}

int mesh_topology(const struct mesh *mesh, struct topology *topology, struct error *err)
{
    struct edge_list list;
    if (edge_list_init(&list, mesh, err))
        return -1;
    int result = mesh_topology_of_edges(mesh, &list, topology, err);
    edge_list_release(&list);
    return result;
}
