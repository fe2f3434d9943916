/* The faults of connectivity, one by one; see faults.h. Each kind is looked for only where its count is not
 * 0, since most meshes have none. */
#include "reference/survey/faults.h"

#include <stdlib.h>

static int list_triangles(struct mesh_survey *survey, const struct mesh *mesh, struct error *err)
{
    for (int32_t t = 0; t < mesh->triangle_count; t++)
        if (triangle_is_degenerate(mesh->triangles + 3 * (int64_t)t) &&
            survey_note(&survey->faults[SURVEY_DEGENERATE],
                        (struct survey_element){{t, -1, -1, -1}}, err))
            return -1;
    return 0;
}

/* -- triangles that are listed twice ---------------------------------------------------------- */

/* A triangle by its vertices in order of number. */
struct named_triangle {
    int32_t vertex[3], number;
};

static void put_in_order(int32_t *low, int32_t *high)
{
    if (*low > *high) {
        int32_t lower = *high;
        *high = *low;
        *low = lower;
    }
}

static int by_vertices(const void *left, const void *right)
{
    const struct named_triangle *a = left, *b = right;
    for (int i = 0; i < 3; i++)
        if (a->vertex[i] != b->vertex[i])
            return a->vertex[i] < b->vertex[i] ? -1 : 1;
    return (a->number > b->number) - (a->number < b->number);
}

static bool same_vertices(const struct named_triangle *a, const struct named_triangle *b)
{
    return a->vertex[0] == b->vertex[0] && a->vertex[1] == b->vertex[1] &&
           a->vertex[2] == b->vertex[2];
}

static int list_duplicates(struct mesh_survey *survey, const struct mesh *mesh, struct error *err)
{
    size_t count = (size_t)mesh->triangle_count;
    struct named_triangle *named = malloc((count + 1) * sizeof *named);
    if (!named)
        return error_set(err, "out of memory: sorting %d triangles", mesh->triangle_count);
    for (size_t t = 0; t < count; t++) {
        const int32_t *corner = mesh->triangles + 3 * t;
        named[t] = (struct named_triangle){{corner[0], corner[1], corner[2]}, (int32_t)t};
        put_in_order(&named[t].vertex[0], &named[t].vertex[1]);
        put_in_order(&named[t].vertex[1], &named[t].vertex[2]);
        put_in_order(&named[t].vertex[0], &named[t].vertex[1]);
    }
    qsort(named, count, sizeof *named, by_vertices);
    int result = 0;
    for (size_t i = 1, first = 0; result == 0 && i < count; i++) {
        if (same_vertices(&named[first], &named[i]))
            result = survey_note(
                &survey->faults[SURVEY_DUPLICATE],
                (struct survey_element){{named[i].number, named[first].number, -1, -1}}, err);
        else
            first = i;
    }
    free(named);
    return result;
}

/* -- vertices and edges ----------------------------------------------------------------------- */

static int list_isolated(struct mesh_survey *survey, const struct mesh *mesh, struct error *err)
{
    uint8_t *is_used = calloc((size_t)mesh->vertex_count + 1, 1);
    int result = is_used ? 0 : error_set(err, "out of memory: marking vertices");
    for (int64_t corner = 0; result == 0 && corner < 3 * (int64_t)mesh->triangle_count; corner++)
        is_used[mesh->triangles[corner]] = 1;
    for (int32_t v = 0; result == 0 && v < mesh->vertex_count; v++)
        if (!is_used[v])
            result = survey_note(&survey->faults[SURVEY_ISOLATED],
                                 (struct survey_element){{v, -1, -1, -1}}, err);
    free(is_used);
    return result;
}

static int list_nonmanifold_vertices(struct mesh_survey *survey, const struct mesh *mesh,
                                     const struct edge_list *list, struct error *err)
{
    int32_t *fan_counts = malloc(((size_t)mesh->vertex_count + 1) * sizeof *fan_counts);
    int result = fan_counts ? mesh_count_fans(mesh, list, fan_counts, err)
                            : error_set(err, "out of memory: counting fans");
    for (int32_t v = 0; result == 0 && v < mesh->vertex_count; v++)
        if (fan_counts[v] > 1)
            result = survey_note(&survey->faults[SURVEY_NONMANIFOLD_VERTEX],
                                 (struct survey_element){{v, -1, -1, -1}}, err);
    free(fan_counts);
    return result;
}

static int list_edges(struct mesh_survey *survey, const struct edge_list *list, struct error *err)
{
    int result = 0;
    for (int64_t e = 0; result == 0 && e < list->edge_count; e++) {
        const struct edge *edge = &list->edges[e];
        const int32_t *uses = list->uses + edge->first_use;
        int64_t uses_count = edge_use_count(edge);
        if (uses_count > 2)
            result = survey_note(
                &survey->faults[SURVEY_NONMANIFOLD_EDGE],
                (struct survey_element){{edge->low, edge->high, (int32_t)uses_count, -1}}, err);
        else if (uses_count == 2 && edge->forward_count != 1)
            result = survey_note(
                &survey->faults[SURVEY_INCOHERENT],
                (struct survey_element){{edge->low, edge->high, uses[0] / 3, uses[1] / 3}}, err);
    }
    return result;
}

int survey_list_connectivity(struct mesh_survey *survey, const struct mesh *mesh,
                             const struct edge_list *list, struct error *err)
{
    const struct topology *t = &survey->topology;
    if ((t->degenerate.count > 0 && list_triangles(survey, mesh, err)) ||
        (t->duplicate.count > 0 && list_duplicates(survey, mesh, err)) ||
        (t->isolated.count > 0 && list_isolated(survey, mesh, err)) ||
        (t->nonmanifold_vertex.count > 0 && list_nonmanifold_vertices(survey, mesh, list, err)) ||
        (t->nonmanifold_edge.count + t->incoherent.count > 0 && list_edges(survey, list, err)))
        return -1;
    return 0;
}
