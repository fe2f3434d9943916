/* Cost per triangle of each kernel as meshes outgrow the caches. */
#include "graders/report/bench/figures.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIZES_MAX = 12, KERNELS_SHOWN = 6 };

struct point {
    double triangles, ns, low, high;
};

static int by_size(const void *a, const void *b)
{
    const struct point *x = a, *y = b;
    return (x->triangles > y->triangles) - (x->triangles < y->triangles);
}

static size_t points_of(const struct study *study, const struct wanted *wanted,
                        struct point points[SIZES_MAX])
{
    size_t i, count = 0;
    const json_t *row;
    json_array_foreach(study->rows, i, row)
    {
        const json_t *time = json_object_get(row, "ns_per_triangle");
        struct point one = {study_number(row, "triangles"), study_number(time, "median"),
                            study_number(time, "low"), study_number(time, "high")};
        if (study_matches(row, wanted) && one.triangles > 0 && one.ns > 0 && count < SIZES_MAX)
            points[count++] = one;
    }
    qsort(points, count, sizeof *points, by_size);
    return count;
}

/* The kind of mesh with most sizes; false when none has two. */
static bool choose_kind(const struct study *study, struct wanted *wanted)
{
    const char *kinds[STUDY_NAMES_MAX];
    size_t most = 1;
    *wanted = (struct wanted){
        .what = "kernels", .kind = "kernel", .variant = "plain", .order = "generated"};
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

/* The last variant on one thread that was measured: they come plain first, wider ones after. */
static const char *fastest_variant(const struct study *study, const char *operation)
{
    static const char *const variants[] = {"avx512", "avx2", "plain"};
    for (size_t i = 0; i < sizeof variants / sizeof *variants; i++)
        if (study_find(study, &(struct wanted){.what = "kernels",
                                               .kind = "kernel",
                                               .operation = operation,
                                               .variant = variants[i]}))
            return variants[i];
    return "plain";
}

static void add_curve(json_t *panel, const struct study *study, const struct wanted *wanted,
                      const char *name, enum look look, bool dashed)
{
    struct point points[SIZES_MAX] = {{0}};
    size_t count = points_of(study, wanted, points);
    if (count == 0)
        return;
    json_t *series = figure_series(name, look, dashed);
    json_t *low = json_array(), *high = json_array();
    for (size_t i = 0; i < count; i++) {
        figure_point(series, points[i].triangles, points[i].ns);
        json_array_append_new(low, json_real(isnan(points[i].low) ? points[i].ns : points[i].low));
        json_array_append_new(high,
                              json_real(isnan(points[i].high) ? points[i].ns : points[i].high));
    }
    json_object_set_new(series, "low", low);
    json_object_set_new(series, "high", high);
    json_array_append_new(json_object_get(panel, "series"), series);
}

/* Each level of cache as the number of triangles whose bytes, read and written once, fill it. */
static void add_caches(json_t *panel, const struct study *study, const struct wanted *wanted)
{
    const json_t *row = study_find(study, wanted);
    double bytes = study_number(json_object_get(row, "limit"), "bytes_per_triangle");
    size_t i;
    const json_t *cache;
    json_array_foreach(json_object_get(json_object_get(study->document, "machine"), "caches"), i,
                       cache)
    {
        char label[48];
        double size = study_number(cache, "bytes");
        if (strcmp(study_text(cache, "type"), "Instruction") == 0 || !(size > 0) || !(bytes > 0))
            continue;
        snprintf(label, sizeof label, size < 1 << 20 ? "L%.0f %.0f KB" : "L%.0f %.0f MB",
                 study_number(cache, "level"), size < 1 << 20 ? size / 1024 : size / 1048576);
        json_array_append_new(json_object_get(panel, "guides"),
                              figure_guide("x", size / bytes, label));
    }
}

static json_t *panel_of(const struct study *study, struct wanted wanted)
{
    char title[80];
    figure_operation_title(wanted.operation, title, sizeof title);
    json_t *panel = figure_panel(title, "triangles", "ns a triangle");
    const char *variant = fastest_variant(study, wanted.operation);
    struct wanted fast = wanted;
    fast.variant = variant;
    add_curve(panel, study, &fast, "ordered", LOOK_BLUE, false);
    add_caches(panel, study, &fast);
    fast.order = "scrambled";
    add_curve(panel, study, &fast, "scrambled", LOOK_ORANGE, false);
    if (strcmp(variant, "plain") != 0)
        add_curve(panel, study, &wanted, "plain C, ordered", LOOK_GREY, true);
    return panel;
}

static json_t *scene(const struct study *study)
{
    struct wanted wanted;
    const char *operations[STUDY_NAMES_MAX];
    char subtitle[160];
    if (!choose_kind(study, &wanted))
        return NULL;
    size_t count = study_names(study, &wanted, "operation", operations);
    json_t *panels = json_array();
    for (size_t i = 0; i < count && i < KERNELS_SHOWN; i++) {
        wanted.operation = operations[i];
        json_array_append_new(panels, panel_of(study, wanted));
    }
    snprintf(subtitle, sizeof subtitle,
             "%s, fastest variant on one thread; dashed verticals: input and output fill a level "
             "of cache",
             wanted.mesh_kind);
    return json_pack("{s:s, s:s, s:s, s:i, s:b, s:o}", "kind", "panels", "title",
                     "Cost per triangle as meshes outgrow the caches", "subtitle", subtitle,
                     "columns", count > 4 ? 3 : 2, "shared_axes", true, "panels", panels);
}

/* Writes how much dearer scrambling is, least and most, at the largest size that has both. */
static void write_scrambling(const struct study *study, struct wanted wanted, FILE *to)
{
    const char *operations[STUDY_NAMES_MAX], *least_name = NULL, *most_name = NULL;
    double least = (double)INFINITY, most = 0;
    size_t count = study_names(study, &wanted, "operation", operations);
    for (size_t i = 0; i < count; i++) {
        struct point ordered[SIZES_MAX] = {{0}}, scrambled[SIZES_MAX] = {{0}};
        struct wanted here = wanted;
        here.operation = operations[i];
        here.variant = fastest_variant(study, operations[i]);
        size_t a = points_of(study, &here, ordered);
        here.order = "scrambled";
        size_t b = points_of(study, &here, scrambled);
        if (a == 0 || b == 0 || fabs(ordered[a - 1].triangles - scrambled[b - 1].triangles) > 0.5)
            continue;
        double ratio = scrambled[b - 1].ns / ordered[a - 1].ns;
        if (ratio < least) {
            least = ratio;
            least_name = operations[i];
        }
        if (ratio > most) {
            most = ratio;
            most_name = operations[i];
        }
    }
    if (most_name)
        fprintf(to,
                "At the largest size a scrambled mesh costs %.1f (%s) to %.1f (%s) times an "
                "ordered one.",
                least, study_operation(least_name), most, study_operation(most_name));
}

static void finding(const struct study *study, FILE *to)
{
    struct wanted wanted;
    const char *operations[STUDY_NAMES_MAX], *name = NULL;
    double most = 0, sizes = 0;
    if (!choose_kind(study, &wanted))
        return;
    size_t count = study_names(study, &wanted, "operation", operations);
    for (size_t i = 0; i < count; i++) {
        struct point points[SIZES_MAX] = {{0}};
        struct wanted here = wanted;
        here.operation = operations[i];
        here.variant = fastest_variant(study, operations[i]);
        size_t point_count = points_of(study, &here, points);
        if (point_count < 2)
            continue;
        double ratio = points[point_count - 1].ns / points[0].ns;
        if (ratio > most) {
            most = ratio;
            name = operations[i];
            sizes = points[point_count - 1].triangles / points[0].triangles;
        }
    }
    if (name)
        fprintf(to,
                "On an ordered mesh %.0f times as large a triangle costs at most %.1f times as "
                "much (%s). ",
                sizes, most, study_operation(name));
    write_scrambling(study, wanted, to);
}

const struct figure figure_doubling = {.name = "doubling",
                                       .label = "Cost per triangle of the kernels over the size",
                                       .width = 1440,
                                       .height = 960,
                                       .scene = scene,
                                       .finding = finding,
                                       .absent = "no kernel was measured at two sizes of a mesh"};
