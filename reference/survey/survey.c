/* What a mesh is; see survey.h. */
#include "reference/survey/survey.h"

#include "reference/survey/faults.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { USUAL_PAIRS = 20000000, PAIRS_OF_A_TRIANGLE = 50 };

/* -- measures --------------------------------------------------------------------------------- */

static void measure_valence(struct mesh_survey *survey, const struct edge_list *list,
                            int32_t *valence, int32_t vertex_count)
{
    for (int64_t e = 0; e < list->edge_count; e++) {
        valence[list->edges[e].low]++;
        valence[list->edges[e].high]++;
    }
    int64_t vertices = 0, sum = 0;
    for (int32_t v = 0; v < vertex_count; v++) {
        if (valence[v] == 0)
            continue;
        if (vertices++ == 0 || valence[v] < survey->least_valence)
            survey->least_valence = valence[v];
        if (valence[v] > survey->most_valence)
            survey->most_valence = valence[v];
        sum += valence[v];
        survey->valence_counts[valence[v] < SURVEY_VALENCES ? valence[v] : SURVEY_VALENCES]++;
    }
    survey->mean_valence = vertices > 0 ? (double)sum / (double)vertices : 0;
}

static void cross(const double a[3], const double b[3], double product[3])
{
    for (int i = 0; i < 3; i++)
        product[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* Area and volume, seen from the middle of the box so that a far origin costs no digits. */
static void measure_size(struct mesh_survey *survey, const struct mesh *mesh)
{
    double middle[3], area = 0, volume = 0;
    for (int i = 0; i < 3; i++)
        middle[i] = ((double)survey->box.low[i] + (double)survey->box.high[i]) / 2;
    for (int64_t t = 0; t < mesh->triangle_count; t++) {
        const int32_t *corner = mesh->triangles + 3 * t;
        double a[3], u[3], v[3], normal[3];
        for (int i = 0; i < 3; i++) {
            double origin = (double)mesh->positions[3 * (int64_t)corner[0] + i];
            a[i] = origin - middle[i];
            u[i] = (double)mesh->positions[3 * (int64_t)corner[1] + i] - origin;
            v[i] = (double)mesh->positions[3 * (int64_t)corner[2] + i] - origin;
        }
        cross(u, v, normal);
        area += sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        volume += a[0] * normal[0] + a[1] * normal[1] + a[2] * normal[2];
    }
    survey->area = area / 2;
    survey->volume = volume / 6;
}

static void measure_box(struct mesh_survey *survey, const struct mesh *mesh)
{
    survey->box = bounds_empty();
    for (int64_t v = 0; v < mesh->vertex_count; v++)
        bounds_include(&survey->box, mesh->positions + 3 * v);
}

static void choose_tolerance(struct mesh_survey *survey, double wished)
{
    double square = 0, largest = 0;
    for (int i = 0; i < 3; i++) {
        double low = (double)survey->box.low[i], high = (double)survey->box.high[i];
        square += (high - low) * (high - low);
        largest = fmax(largest, fmax(fabs(low), fabs(high)));
    }
    double usual = fmax(sqrt(square) * 1e-6, 2 * largest * (double)FLT_EPSILON);
    survey->tolerance = wished > 0 ? wished : usual;
    if (survey->topology.vertex_count == 0)
        survey->tolerance = 0;
}

/* V - E + F = 2 (C - G) - B, over components, genus and boundary loops. */
static void conclude(struct mesh_survey *survey)
{
    const struct topology *t = &survey->topology;
    survey->is_closed = t->boundary.count == 0 && t->triangle_count > 0;
    survey->is_manifold = t->nonmanifold_edge.count + t->nonmanifold_vertex.count == 0;
    survey->is_coherent = t->incoherent.count == 0;
    survey->has_genus = survey->is_manifold && t->is_orientable && t->degenerate.count == 0 &&
                        t->triangle_count > 0;
    survey->genus =
        survey->has_genus
            ? (2 * t->component_count - t->boundary_loop_count - t->euler_characteristic) / 2
            : -1;
    survey->has_volume = survey->is_closed && survey->is_manifold && survey->is_coherent;
}

/* -- the whole -------------------------------------------------------------------------------- */

static int survey_with_edges(struct mesh_survey *survey, const struct mesh *mesh,
                             const struct edge_list *list, const struct survey_wish *wish,
                             struct error *err)
{
    if (mesh_topology_of_edges(mesh, list, &survey->topology, err))
        return -1;
    int32_t *valence = calloc((size_t)mesh->vertex_count + 1, sizeof *valence);
    if (!valence)
        return error_set(err, "out of memory: valences of %d vertices", mesh->vertex_count);
    measure_valence(survey, list, valence, mesh->vertex_count);
    free(valence);
    measure_box(survey, mesh);
    measure_size(survey, mesh);
    choose_tolerance(survey, wish->tolerance);
    conclude(survey);
    int64_t limit = wish->pair_limit > 0
                        ? wish->pair_limit
                        : USUAL_PAIRS + PAIRS_OF_A_TRIANGLE * (int64_t)mesh->triangle_count;
    if (survey_list_connectivity(survey, mesh, list, err) || survey_find_flat(survey, mesh, err) ||
        (survey->topology.boundary.count > 0 &&
         (survey_find_cracks(survey, mesh, list, err) ||
          survey_find_t_vertices(survey, mesh, list, limit, err))))
        return -1;
    return wish->without_crossings ? 0 : survey_find_crossings(survey, mesh, limit, err);
}

int mesh_survey_make(struct mesh_survey *survey, const struct mesh *mesh,
                     const struct survey_wish *wish, struct error *err)
{
    struct edge_list list;
    *survey = (struct mesh_survey){0};
    if (edge_list_init(&list, mesh, err))
        return -1;
    int result = survey_with_edges(survey, mesh, &list, wish, err);
    edge_list_release(&list);
    for (int kind = 0; kind < SURVEY_KINDS; kind++)
        survey_sort(&survey->faults[kind]);
    if (result != 0)
        mesh_survey_release(survey);
    return result;
}

void mesh_survey_release(struct mesh_survey *survey)
{
    for (int kind = 0; kind < SURVEY_KINDS; kind++)
        free(survey->faults[kind].kept);
    *survey = (struct mesh_survey){0};
}

int64_t mesh_survey_fault_count(const struct mesh_survey *survey)
{
    int64_t count = 0;
    for (int kind = 0; kind < SURVEY_KINDS; kind++)
        count += survey->faults[kind].count;
    return count;
}
