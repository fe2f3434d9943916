/* See figure_reader.hpp. */
#include "graders/render/figure_reader.hpp"
#include "graders/render/json_values.hpp"

#include <cmath>
#include <iterator>

namespace
{
const size_t panel_limit = 16, series_limit = 24, guide_limit = 12, group_limit = 24;
const size_t bar_limit = 80, row_limit = 40, key_limit = 12, part_limit = 4000;
const int box_limit = 200000;
const size_t look_count_limit = 8; /* palette::looks */

/* Whether a value has a place on an axis. */
bool has_place(double value, bool linear)
{
    const double least = 1e-12, most = 1e18;
    return linear ? value >= 0 && value <= most : value >= least && value <= most;
}

size_t look_at(const json_t *json)
{
    json_int_t look = json_integer_value(json_object_get(json, "look"));
    return look >= 0 && look < json_int_t(look_count_limit) ? size_t(look) : 0;
}

/* Calls `take` for each element of an array, at most `limit` of them. */
template <class taker> void each_of(const json_t *json, const char *key, size_t limit, taker &&take)
{
    const json_t *list = json_object_get(json, key);
    for (size_t i = 0; i < json_array_size(list) && i < limit; i++)
        take(json_array_get(list, i));
}

std::vector<guide> guides_at(const json_t *json, bool x_linear, bool y_linear)
{
    std::vector<guide> guides;
    each_of(json, "guides", guide_limit, [&](const json_t *from) {
        guide to;
        to.on_x = text_at(from, "axis") != "y";
        to.value = number_at(from, "value");
        to.label = text_at(from, "label");
        if (has_place(to.value, to.on_x ? x_linear : y_linear))
            guides.push_back(to);
    });
    return guides;
}

series series_of(const json_t *from, const panel &within)
{
    series to;
    to.name = text_at(from, "name");
    to.look = look_at(from);
    to.dashed = json_is_true(json_object_get(from, "dashed"));
    std::vector<double> x = numbers_at(from, "x"), y = numbers_at(from, "y");
    std::vector<double> low = numbers_at(from, "low"), high = numbers_at(from, "high");
    bool ranged = !low.empty() || !high.empty();
    if (x.size() != y.size() || (ranged && (low.size() != y.size() || high.size() != y.size())))
        throw not_showable("series \"" + to.name + "\": x, y and their ranges differ in length");
    for (size_t i = 0; i < x.size(); i++) {
        if (!has_place(x[i], within.x_linear) || !has_place(y[i], within.y_linear))
            continue;
        to.x.push_back(x[i]);
        to.y.push_back(y[i]);
        if (!ranged)
            continue;
        bool sound = has_place(low[i], within.y_linear) && has_place(high[i], within.y_linear);
        to.low.push_back(sound ? std::min(low[i], y[i]) : y[i]);
        to.high.push_back(sound ? std::max(high[i], y[i]) : y[i]);
    }
    return to;
}

void read_panels(const json_t *json, panel_figure &out)
{
    out.columns = size_t(std::max<json_int_t>(
        1, std::min<json_int_t>(6, json_integer_value(json_object_get(json, "columns")))));
    out.shared_axes = json_is_true(json_object_get(json, "shared_axes"));
    each_of(json, "panels", panel_limit, [&](const json_t *from) {
        panel to;
        to.title = text_at(from, "title");
        to.x_label = text_at(from, "x_label");
        to.y_label = text_at(from, "y_label");
        to.x_linear = text_at(from, "x_scale") == "linear";
        to.y_linear = text_at(from, "y_scale") == "linear";
        to.guides = guides_at(from, to.x_linear, to.y_linear);
        each_of(from, "series", series_limit,
                [&](const json_t *one) { to.lines.push_back(series_of(one, to)); });
        out.panels.push_back(to);
    });
}

bar bar_of(const json_t *from, bool logarithmic)
{
    bar to;
    to.name = text_at(from, "name");
    to.label = text_at(from, "label");
    to.look = look_at(from);
    double *const places[] = {&to.value, &to.low, &to.high, &to.tick};
    const char *const keys[] = {"value", "low", "high", "tick"};
    for (size_t i = 0; i < std::size(keys); i++) {
        double value = number_at(from, keys[i]);
        *places[i] = has_place(value, !logarithmic) ? value : absent;
    }
    return to;
}

void read_bars(const json_t *json, bar_figure &out)
{
    size_t left = bar_limit;
    out.logarithmic = text_at(json, "scale") == "log";
    out.x_label = text_at(json, "x_label");
    out.guides = guides_at(json, !out.logarithmic, true);
    each_of(json, "groups", group_limit, [&](const json_t *from) {
        bar_group to;
        to.title = text_at(from, "title");
        each_of(from, "bars", left,
                [&](const json_t *one) { to.bars.push_back(bar_of(one, out.logarithmic)); });
        left -= to.bars.size();
        if (!to.bars.empty())
            out.groups.push_back(to);
    });
}

std::vector<std::string> names_at(const json_t *json, const char *key)
{
    std::vector<std::string> names;
    const json_t *list = json_object_get(json, key);
    for (size_t i = 0; i < json_array_size(list) && i < row_limit; i++) {
        json_t *holder = json_pack("{s:O}", "name", json_array_get(list, i));
        names.push_back(text_at(holder, "name"));
        json_decref(holder);
    }
    return names;
}

void read_heat(const json_t *json, heat_figure &out)
{
    out.rows = names_at(json, "rows");
    out.columns = names_at(json, "columns");
    out.low = number_at(json, "low");
    out.high = number_at(json, "high");
    out.low_label = text_at(json, "low_label");
    out.high_label = text_at(json, "high_label");
    if (!has_place(out.low, false) || !has_place(out.high, false) || out.high <= out.low)
        throw not_showable("the colours of the heat map have no range");
    const json_t *cells = json_object_get(json, "cells");
    for (size_t r = 0; r < out.rows.size(); r++)
        for (size_t c = 0; c < out.columns.size(); c++) {
            const json_t *from = json_array_get(json_array_get(cells, r), c);
            double value = number_at(from, "value");
            out.cells.push_back({has_place(value, false) ? value : absent, text_at(from, "label")});
        }
}

bool point_at(const json_t *json, const char *key, vec3 &out)
{
    const json_t *list = json_object_get(json, key);
    double xyz[3];
    for (size_t i = 0; i < 3; i++) {
        xyz[i] = json_number_value(json_array_get(list, i));
        if (!(std::fabs(xyz[i]) < 1e18))
            return false;
    }
    out = {xyz[0], xyz[1], xyz[2]};
    return json_array_size(list) == 3;
}

void read_diagram(const json_t *json, size_t triangles, diagram_figure &out)
{
    const json_t *view = json_object_get(json, "view");
    out.azimuth_degrees = number_at(view, "azimuth_degrees");
    out.elevation_degrees = number_at(view, "elevation_degrees");
    out.has_view = std::fabs(out.azimuth_degrees) <= 360 && std::fabs(out.elevation_degrees) < 90;
    each_of(json, "faces", part_limit, [&](const json_t *from) {
        const json_t *t = json_object_get(from, "triangle");
        if (json_is_integer(t) && json_integer_value(t) >= 0 &&
            json_integer_value(t) < json_int_t(triangles))
            out.faces.push_back({size_t(json_integer_value(t)), look_at(from)});
    });
    each_of(json, "arrows", part_limit, [&](const json_t *from) {
        diagram_arrow to = {{},
                            {},
                            look_at(from),
                            text_at(from, "label"),
                            json_is_true(json_object_get(from, "dashed"))};
        if (point_at(from, "from", to.from) && point_at(from, "to", to.to))
            out.arrows.push_back(to);
    });
    each_of(json, "labels", part_limit, [&](const json_t *from) {
        diagram_label to = {{}, look_at(from), text_at(from, "text")};
        if (point_at(from, "at", to.at))
            out.labels.push_back(to);
    });
}

void read_legend(const json_t *json, std::vector<key_entry> &out)
{
    static const char *const shapes[] = {"bar", "tick", "line", "arrow", "face", "point"};
    each_of(json, "legend", key_limit, [&](const json_t *from) {
        key_entry to;
        std::string shape = text_at(from, "shape");
        for (size_t s = 0; s < std::size(shapes); s++)
            if (shape == shapes[s])
                to.shape = key_shape(s);
        to.look = look_at(from);
        to.name = text_at(from, "name");
        out.push_back(to);
    });
}

void read_boxes(const json_t *json, int per_side, std::vector<cell_box> &out)
{
    const json_t *boxes = json_object_get(json, "boxes");
    for (size_t i = 0; i < json_array_size(boxes) && i < size_t(box_limit); i++) {
        const json_t *from = json_array_get(boxes, i);
        int32_t xyzs[4];
        for (size_t k = 0; k < 4; k++) {
            json_int_t value = json_integer_value(json_array_get(from, k));
            if (value < 0 || value > per_side)
                throw not_showable("box " + std::to_string(i) + " leaves the voxels");
            xyzs[k] = int32_t(value);
        }
        for (int k = 0; k < 3; k++)
            if (xyzs[3] < 1 || xyzs[k] + xyzs[3] > per_side)
                throw not_showable("box " + std::to_string(i) + " leaves the voxels");
        out.push_back({xyzs[0], xyzs[1], xyzs[2], xyzs[3]});
    }
}
} // namespace

void read_figure(const json_t *json, scene &out)
{
    read_legend(json, out.shown.legend);
    if (out.kind == scene_kind::panels)
        read_panels(json, out.shown.curves);
    if (out.kind == scene_kind::bars)
        read_bars(json, out.shown.bars);
    if (out.kind == scene_kind::heatmap)
        read_heat(json, out.shown.heat);
    if (out.kind == scene_kind::diagram)
        read_diagram(json, out.mesh.triangles.size(), out.shown.diagram);
    if (out.kind == scene_kind::voxels)
        read_boxes(json, out.voxels_per_side, out.shown.boxes);
    each_of(json, "captions", 3, [&](const json_t *from) {
        out.shown.captions.push_back({text_at(from, "name"), text_at(from, "note")});
    });
}
