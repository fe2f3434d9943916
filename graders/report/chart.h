/* Charts: scenes made from a result's measures, and any chart scene drawn as SVG into a page. Both
 * axes are logarithmic. */
#ifndef GRADERS_REPORT_CHART_H
#define GRADERS_REPORT_CHART_H

#include "graders/report/html.h"

#include <jansson.h>

/* The family of measures.growth that decides: the one that the growth check's message names, or
 * else the one furthest above what is allowed, and of equal ones the one with the largest exponent
 * (borrowed; NULL when there is none). */
const json_t *chart_growth_family(const json_t *result);

/* Chart scenes (format in graders/render/README.md) of submission and reference over doubling
 * sizes: the work of the family above; peak memory, where it was measured at more than one size.
 * New references; NULL when the result has no such measure or when out of memory. */
/* What the sizes count: "triangles"; "size" where the result does not say. */
struct phrase chart_elements(const json_t *result);

json_t *chart_of_growth(const json_t *result);
json_t *chart_of_memory(const json_t *result);

/* Draws a chart scene as an <svg>, with `label` for those who do not see it. A scene without a
 * positive point draws nothing. */
void chart_draw(struct html *page, const json_t *scene, struct phrase label);

/* A number as a person writes it: "128", "16k", "2.1M". Writes at most `capacity` bytes. */
void chart_number(double value, char *text, size_t capacity);

#endif
