/* The figures of a benchmark run's page: for each a scene for meshgrade-render (format in
 * graders/render/README.md) and a sentence that says what it shows, computed from the same rows. */
#ifndef GRADERS_REPORT_BENCH_FIGURES_H
#define GRADERS_REPORT_BENCH_FIGURES_H

#include "graders/report/bench/study.h"

#include <stdio.h>

struct figure {
    const char *name;  /* of its files: pictures/NAME.json and .png */
    const char *label; /* "Bytes per triangle", for lists and alternative text */
    int width, height; /* pixels */

    /* A new reference; NULL when the run has nothing for it (or memory ran out). */
    json_t *(*scene)(const struct study *study);

    /* Writes one or more sentences; only called when there is a scene. */
    void (*finding)(const struct study *study, FILE *to);

    const char *absent; /* what is missing when there is no scene: "no two sizes were measured" */
};

extern const struct figure figure_bytes, figure_costs, figure_heat, figure_strips, figure_voxels,
    figure_doubling, figure_limit, figure_peers;
extern const struct figure lesson_strips, lesson_winged_edge, lesson_half_edge, lesson_voxels;

/* All of them in the page's order; ends with NULL. */
extern const struct figure *const study_figures[];

/* What figure->finding writes, in memory that the caller frees; NULL: out of memory. */
char *figure_words(const struct figure *figure, const struct study *study);

/* -- parts of scenes ----------------------------------------------------------------------------
 */

/* Looks of the renderer's palette. */
enum look {
    LOOK_ORANGE,
    LOOK_BLUE,
    LOOK_GREEN,
    LOOK_PURPLE,
    LOOK_AMBER,
    LOOK_SKY,
    LOOK_GREY,
    LOOK_DARK
};
enum { LOOK_COUNT = LOOK_DARK + 1 };

/* {"shape": ..., "look": ..., "name": ...} of a legend. */
json_t *figure_key(const char *shape, enum look look, const char *name);

/* A guide across a plot, at `value` of the axis "x" or "y". */
json_t *figure_guide(const char *axis, double value, const char *label);

/* A curve; points are added in the order of x. */
json_t *figure_series(const char *name, enum look look, bool dashed);
void figure_point(json_t *series, double x, double y);

/* A panel of curves on logarithmic axes, with no curve yet ("series" is an empty array). */
json_t *figure_panel(const char *title, const char *x_label, const char *y_label);

/* "Twins of half edges": an operation as a title. Writes at most `capacity` bytes. */
void figure_operation_title(const char *operation, char *text, size_t capacity);

/* Adds a number under a key, unless it is NaN. */
void figure_number(json_t *object, const char *key, double value);

#endif
