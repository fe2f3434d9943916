/* Build and query cost by representation over the size of the mesh. */
#include "graders/report/bench/figures.h"

#include "reference/representation/representation.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const shown[] = {"build", "edges", "faces-around-vertex", "is-edge"};
enum { SHOWN_COUNT = sizeof shown / sizeof *shown, SIZES_MAX = 12 };

struct point {
    double triangles, ns;
};

static int by_size(const void *a, const void *b)
{
    const struct point *x = a, *y = b;
    return (x->triangles > y->triangles) - (x->triangles < y->triangles);
}

/* Times of one subject and operation over the sizes of a kind of mesh, smallest first. */
static size_t points_of(const struct study *study, const struct wanted *wanted,
                        struct point points[SIZES_MAX])
{
    size_t i, count = 0;
    const json_t *row;
    json_array_foreach(study->rows, i, row)
    {
        struct point one = {study_number(row, "triangles"), study_time(row)};
        if (study_matches(row, wanted) && one.triangles > 0 && one.ns > 0 && count < SIZES_MAX)
            points[count++] = one;
    }
    qsort(points, count, sizeof *points, by_size);
    return count;
}

/* The kind of mesh with most sizes in its own order; false when none has two. */
static bool choose_kind(const struct study *study, struct wanted *wanted)
{
    const char *kinds[STUDY_NAMES_MAX];
    size_t most = 1;
    *wanted = (struct wanted){.what = "representations",
                              .kind = "representation",
                              .operation = "build",
                              .order = "generated"};
    size_t count = study_names(study, wanted, "mesh_kind", kinds);
    for (size_t i = 0; i < count; i++) {
        struct wanted here = *wanted;
        const char *meshes[STUDY_NAMES_MAX];
        here.mesh_kind = kinds[i];
        size_t sizes = study_names(study, &here, "mesh", meshes);
        if (sizes > most) {
            most = sizes;
            wanted->mesh_kind = kinds[i];
        }
    }
    return most > 1;
}

static json_t *panel_of(const struct study *study, struct wanted wanted)
{
    const char *subjects[STUDY_NAMES_MAX];
    char title[80];
    size_t count = study_names(study, &wanted, "subject", subjects);
    figure_operation_title(wanted.operation, title, sizeof title);
    json_t *panel = figure_panel(title, "triangles",
                                 study_is_query(wanted.operation) ? "ns a query" : "ns a triangle");
    for (size_t s = 0; s < count; s++) {
        struct point points[SIZES_MAX] = {{0}};
        wanted.subject = subjects[s];
        size_t point_count = points_of(study, &wanted, points);
        json_t *series = figure_series(study_title(study, "representations", subjects[s]),
                                       (enum look)(s % LOOK_COUNT), s >= LOOK_COUNT);
        for (size_t i = 0; i < point_count; i++)
            figure_point(series, points[i].triangles, points[i].ns);
        json_array_append_new(json_object_get(panel, "series"), series);
    }
    return panel;
}

static json_t *scene(const struct study *study)
{
    struct wanted wanted;
    char subtitle[100];
    if (!choose_kind(study, &wanted))
        return NULL;
    json_t *panels = json_array();
    for (size_t i = 0; i < SHOWN_COUNT; i++) {
        wanted.operation = shown[i];
        if (study_find(study, &wanted))
            json_array_append_new(panels, panel_of(study, wanted));
    }
    snprintf(subtitle, sizeof subtitle, "%s, in its own order", wanted.mesh_kind);
    return json_pack("{s:s, s:s, s:s, s:i, s:o}", "kind", "panels", "title",
                     "Build and query cost as the mesh grows", "subtitle", subtitle, "columns", 2,
                     "panels", panels);
}

/* Least and greatest growth of the time from the smallest to the largest size. */
struct growth {
    const char *least_subject, *most_subject;
    double least, most, times_larger;
};

static struct growth growth_of(const struct study *study, struct wanted wanted)
{
    const char *subjects[STUDY_NAMES_MAX];
    struct growth growth = {NULL, NULL, (double)INFINITY, 0, 0};
    size_t count = study_names(study, &wanted, "subject", subjects);
    for (size_t s = 0; s < count; s++) {
        struct point points[SIZES_MAX] = {{0}};
        wanted.subject = subjects[s];
        size_t point_count = points_of(study, &wanted, points);
        if (point_count < 2)
            continue;
        double ratio = points[point_count - 1].ns / points[0].ns;
        growth.times_larger =
            fmax(growth.times_larger, points[point_count - 1].triangles / points[0].triangles);
        if (ratio < growth.least) {
            growth.least = ratio;
            growth.least_subject = subjects[s];
        }
        if (ratio > growth.most) {
            growth.most = ratio;
            growth.most_subject = subjects[s];
        }
    }
    return growth;
}

/* What its header claims that the faces around a vertex take. */
static const char *accesses(const char *subject)
{
    const struct representation *kind = representation_find(subject);
    return kind ? kind->cost[QUERY_FACES_AROUND_VERTEX] : "not said";
}

static void finding(const struct study *study, FILE *to)
{
    struct wanted wanted;
    if (!choose_kind(study, &wanted))
        return;
    struct growth build = growth_of(study, wanted);
    if (build.least_subject)
        fprintf(to,
                "On a mesh %.0f times as large, building costs %.1f (%s) to %.1f (%s) times as "
                "much a triangle. ",
                build.times_larger, build.least,
                study_title(study, "representations", build.least_subject), build.most,
                study_title(study, "representations", build.most_subject));
    wanted.operation = "faces-around-vertex";
    struct growth faces = growth_of(study, wanted);
    if (faces.least_subject)
        fprintf(to,
                "The faces around a vertex cost %.1f times as much in %s (accesses: %s) and %.0f "
                "times as much in %s (accesses: %s; k the valence, n the mesh).",
                faces.least, study_title(study, "representations", faces.least_subject),
                accesses(faces.least_subject), faces.most,
                study_title(study, "representations", faces.most_subject),
                accesses(faces.most_subject));
}

const struct figure figure_costs = {.name = "costs",
                                    .label = "Build and query cost over the size of the mesh",
                                    .width = 1600,
                                    .height = 1040,
                                    .scene = scene,
                                    .finding = finding,
                                    .absent = "no mesh was measured at two sizes"};
