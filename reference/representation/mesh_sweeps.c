/* Sweeps over an indexed mesh; see mesh_sweeps.h. */
#include "reference/representation/mesh_sweeps.h"

#include "reference/mesh/check.h"
#include "reference/representation/boundary_chain.h"
#include "reference/representation/smoother.h"
#include "reference/representation/triangle_sweeps.h"

#include <stdlib.h>
#include <string.h>

int64_t mesh_edges(const struct mesh *mesh, int32_t *pairs, struct error *err)
{
    struct edge_list list;
    if (edge_list_init(&list, mesh, err))
        return -1;
    int64_t count = list.edge_count;
    for (int64_t e = 0; e < count; e++) {
        pairs[2 * e] = list.edges[e].low;
        pairs[2 * e + 1] = list.edges[e].high;
    }
    edge_list_release(&list);
    return count;
}

/* The sides on boundary edges, from and to; returns how many. */
static int64_t collect_boundary(const struct mesh *mesh, const struct edge_list *list,
                                int32_t *sides)
{
    int64_t count = 0;
    for (int64_t e = 0; e < list->edge_count; e++) {
        if (edge_use_count(&list->edges[e]) != 1)
            continue;
        int32_t side = list->uses[list->edges[e].first_use];
        sides[2 * count] = mesh->triangles[side];
        sides[2 * count + 1] = mesh->triangles[side % 3 == 2 ? side - 2 : side + 1];
        count++;
    }
    return count;
}

static int32_t chain_loops(const struct mesh *mesh, const struct edge_list *list, int32_t *vertices,
                           int32_t *loop_starts, struct error *err)
{
    struct finding many = mesh_nonmanifold_edges(list);
    if (many.count > 0)
        return error_set(err, "edge {%d,%d} has more than two triangles: no boundary loops",
                         list->edges[many.first].low, list->edges[many.first].high);
    int32_t *sides = malloc(2 * (size_t)mesh_boundary_edges(list).count * sizeof *sides + 1);
    if (!sides)
        return error_set(err, "out of memory: collecting boundary edges");
    int64_t count = collect_boundary(mesh, list, sides);
    int32_t loops = boundary_chain(sides, count, mesh->vertex_count, vertices, loop_starts, err);
    free(sides);
    return loops;
}

int32_t mesh_boundary_loops(const struct mesh *mesh, int32_t *vertices, int32_t *loop_starts,
                            struct error *err)
{
    struct edge_list list;
    if (edge_list_init(&list, mesh, err))
        return -1;
    int32_t loops = chain_loops(mesh, &list, vertices, loop_starts, err);
    edge_list_release(&list);
    return loops;
}

int mesh_smooth(struct mesh *mesh, struct error *err)
{
    struct edge_list list;
    if (edge_list_init(&list, mesh, err))
        return -1;
    struct smoother smoother;
    int result = smoother_init(&smoother, mesh->vertex_count, err);
    if (result == 0) {
        for (int64_t e = 0; e < list.edge_count; e++) {
            const struct edge *edge = &list.edges[e];
            smoother_add_edge(&smoother, mesh->positions, edge->low, edge->high);
            if (edge_use_count(edge) == 1) {
                smoother_fix(&smoother, edge->low);
                smoother_fix(&smoother, edge->high);
            }
        }
        smoother_apply(&smoother, mesh->positions);
        smoother_release(&smoother);
    }
    edge_list_release(&list);
    return result;
}

void mesh_vertex_normals(const struct mesh *mesh, float *normals)
{
    if (mesh->vertex_count == 0)
        return;
    memset(normals, 0, 3 * (size_t)mesh->vertex_count * sizeof *normals);
    triangles_add_normals(mesh->positions, mesh->triangles, mesh->triangle_count, normals);
    vectors_to_unit(normals, mesh->vertex_count);
}

int mesh_refuse_isolated(const struct mesh *mesh, const char *what, struct error *err)
{
    struct finding found;
    if (mesh_isolated_vertices(mesh, &found, err))
        return -1;
    if (found.count == 0)
        return 0;
    return error_set(err, "vertex %lld is in no triangle: %s cannot hold it",
                     (long long)found.first, what);
}
