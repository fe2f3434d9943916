/* What the figures share; see figures.h. */
#include "graders/report/bench/figures.h"

#include <math.h>
#include <stdlib.h>

const struct figure *const study_figures[] = {
    &figure_bytes,    &figure_costs,  &figure_heat,  &figure_strips,    &figure_voxels,
    &figure_doubling, &figure_limit,  &figure_peers, &lesson_half_edge, &lesson_winged_edge,
    &lesson_strips,   &lesson_voxels, NULL};

char *figure_words(const struct figure *figure, const struct study *study)
{
    char *text = NULL;
    size_t length = 0;
    FILE *to = open_memstream(&text, &length);
    if (!to)
        return NULL;
    figure->finding(study, to);
    if (fclose(to) != 0) {
        free(text);
        return NULL;
    }
    return text;
}

json_t *figure_key(const char *shape, enum look look, const char *name)
{
    return json_pack("{s:s, s:i, s:s}", "shape", shape, "look", (int)look, "name", name);
}

json_t *figure_guide(const char *axis, double value, const char *label)
{
    return json_pack("{s:s, s:f, s:s}", "axis", axis, "value", value, "label", label);
}

json_t *figure_series(const char *name, enum look look, bool dashed)
{
    return json_pack("{s:s, s:i, s:b, s:[], s:[]}", "name", name, "look", (int)look, "dashed",
                     dashed, "x", "y");
}

void figure_point(json_t *series, double x, double y)
{
    if (!isfinite(x) || !isfinite(y))
        return;
    json_array_append_new(json_object_get(series, "x"), json_real(x));
    json_array_append_new(json_object_get(series, "y"), json_real(y));
}

json_t *figure_panel(const char *title, const char *x_label, const char *y_label)
{
    return json_pack("{s:s, s:s, s:s, s:[], s:[]}", "title", title, "x_label", x_label, "y_label",
                     y_label, "series", "guides");
}

void figure_number(json_t *object, const char *key, double value)
{
    if (isfinite(value))
        json_object_set_new(object, key, json_real(value));
}

void figure_operation_title(const char *operation, char *text, size_t capacity)
{
    snprintf(text, capacity, "%s", study_operation(operation));
    if (*text >= 'a' && *text <= 'z')
        *text = (char)(*text - 'a' + 'A');
}
