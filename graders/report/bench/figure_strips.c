/* Strips against an indexed mesh: vertices processed and bytes (problem 4.3). The curves are
 * computed here from strips that are really cut, not from the run. */
#include "graders/report/bench/figures.h"

#include "reference/mesh/generate.h"
#include "reference/mesh/strips.h"

#include <math.h>

enum { SIDE_LEAST = 2, SIDE_MOST = 256 };

/* Ratios of problem 4.3 for the n x n grid, by its formula: n strips of 2n triangles. */
static double formula_vertices(double n)
{
    return 2 * n * (n + 1) / ((n + 1) * (n + 1));
}

static double formula_bytes(double n)
{
    int64_t vertices = (int64_t)((n + 1) * (n + 1)), triangles = (int64_t)(2 * n * n);
    return (double)mesh_bytes(vertices, triangles) /
           (double)strips_bytes((int64_t)n, (int64_t)(2 * n * (n + 1)));
}

struct ratios {
    double vertices, bytes; /* NaN when out of memory */
};

/* The same of strips cut by strips_from_mesh. */
static struct ratios measured(int64_t n)
{
    struct mesh mesh = {0};
    struct strips strips = {0};
    struct ratios ratios = {(double)NAN, (double)NAN};
    struct error ignored = {""};
    if (generate_grid(&mesh, n, n, &ignored) == 0 &&
        strips_from_mesh(&strips, &mesh, &ignored) == 0) {
        ratios.vertices = (double)strips.vertex_count / mesh.vertex_count;
        ratios.bytes = (double)mesh_bytes(mesh.vertex_count, mesh.triangle_count) /
                       (double)strips_bytes(strips.strip_count, strips.vertex_count);
    }
    strips_release(&strips);
    mesh_release(&mesh);
    return ratios;
}

static json_t *panel(const char *title, double limit, const char *limit_label)
{
    json_t *panel = figure_panel(title, "n, for the n x n grid", "ratio");
    json_object_set_new(panel, "y_scale", json_string("linear"));
    json_array_append_new(json_object_get(panel, "guides"), figure_guide("y", limit, limit_label));
    return panel;
}

static json_t *scene(const struct study *study)
{
    (void)study;
    json_t *vertices = panel("Vertices processed, strips / indexed mesh", 2, "claimed limit: 2");
    json_t *bytes = panel("Bytes, indexed mesh / strips", 1.5, "claimed limit: 3/2");
    json_t *lines[] = {
        figure_series("formula", LOOK_GREY, true), figure_series("measured", LOOK_BLUE, false),
        figure_series("formula", LOOK_GREY, true), figure_series("measured", LOOK_BLUE, false)};
    for (int64_t n = SIDE_LEAST; n <= SIDE_MOST; n *= 2) {
        struct ratios real = measured(n);
        figure_point(lines[0], (double)n, formula_vertices((double)n));
        figure_point(lines[1], (double)n, real.vertices);
        figure_point(lines[2], (double)n, formula_bytes((double)n));
        figure_point(lines[3], (double)n, real.bytes);
    }
    for (int i = 3; i >= 0; i--)
        json_array_append_new(json_object_get(i < 2 ? vertices : bytes, "series"), lines[i]);
    return json_pack("{s:s, s:s, s:s, s:i, s:[o, o]}", "kind", "panels", "title",
                     "Strips against an indexed mesh, as the grid grows", "subtitle",
                     "problem 4.3; measured on strips that were cut from the grid", "columns", 2,
                     "panels", vertices, bytes);
}

static void finding(const struct study *study, FILE *to)
{
    struct ratios last = measured(SIDE_MOST);
    fprintf(to,
            "On the %d x %d grid strips process %.3f times the vertices of the indexed mesh "
            "(claimed limit: 2) in 1/%.3f of its bytes (claimed limit: 3/2). ",
            SIDE_MOST, SIDE_MOST, last.vertices, last.bytes);
    struct wanted wanted = {
        .what = "representations", .subject = "triangle-strips", .operation = "transform"};
    const char *meshes[STUDY_NAMES_MAX], *where = NULL;
    double most = 0;
    size_t count = study_names(study, &wanted, "mesh", meshes);
    for (size_t i = 0; i < count; i++) {
        wanted.mesh = meshes[i];
        const json_t *facts = json_object_get(study_find(study, &wanted), "facts");
        double vertices = study_number(study_find(study, &wanted), "vertices");
        double ratio = study_number(facts, "vertices_processed") / vertices;
        if (ratio > most) {
            most = ratio;
            where = meshes[i];
        }
    }
    if (where)
        fprintf(to, "On the meshes of this run the strips process at most %.2f times as many (%s).",
                most, where);
}

const struct figure figure_strips = {.name = "strips",
                                     .label = "Strips against an indexed mesh",
                                     .width = 1440,
                                     .height = 640,
                                     .scene = scene,
                                     .finding = finding,
                                     .absent = "memory ran out"};
