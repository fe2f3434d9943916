/* Panels of curves with their names at their ends; see pictures.hpp. */
#include "graders/render/canvas.hpp"
#include "graders/render/marker.hpp"
#include "graders/render/pictures.hpp"
#include "graders/render/plot.hpp"

#include <cmath>

namespace
{
/* Sizes that depend on how many panels share the picture. */
struct measure {
    double tick, label, name, title, line, marker;
};

measure measure_for(size_t columns)
{
    if (columns <= 1)
        return {13, 14, 13.5, 15, 2.6, 4.4};
    if (columns == 2)
        return {12, 12.5, 12, 14, 2.4, 3.8};
    return {10.5, 11.5, 11, 13, 2.2, 3.4};
}

struct plot {
    double left, right, top, bottom;
    chart_axis x, y;

    point2 at(double x_value, double y_value) const
    {
        return {left + (right - left) * x.place(x_value),
                bottom - (bottom - top) * y.place(y_value)};
    }
};

struct ranges {
    std::vector<double> x, y;
};

void add_ranges(ranges &to, const panel &from)
{
    for (const series &one : from.lines) {
        to.x.insert(to.x.end(), one.x.begin(), one.x.end());
        to.y.insert(to.y.end(), one.y.begin(), one.y.end());
        to.y.insert(to.y.end(), one.low.begin(), one.low.end());
        to.y.insert(to.y.end(), one.high.begin(), one.high.end());
    }
    for (const guide &one : from.guides)
        if (!one.on_x && !one.label.empty())
            to.y.push_back(one.value);
}

bool is_within(const chart_axis &axis, double value)
{
    return value > axis.low && value < axis.high;
}

void draw_frame(paper &sheet, const plot &area, const panel &from, const measure &size)
{
    const font tick_font = {size.tick, weight::regular, palette::grey_ink};
    const font label_font = {size.label, weight::regular, palette::ink};
    for (const tick &t : area.x.ticks) {
        double x = area.at(t.value, area.y.low).x;
        sheet.rectangle({x - .5, area.top}, 1, area.bottom - area.top, palette::hairline);
        sheet.text({x, area.bottom + 1.5 * size.tick}, t.label, tick_font, align::centre);
    }
    for (const tick &t : area.y.ticks) {
        double y = area.at(area.x.low, t.value).y;
        sheet.rectangle({area.left, y - .5}, area.right - area.left, 1, palette::hairline);
        sheet.text({area.left - 8, y + .36 * size.tick}, t.label, tick_font, align::right);
    }
    sheet.rectangle({area.left, area.bottom - .7}, area.right - area.left, 1.4, palette::pale_ink);
    if (!from.title.empty())
        sheet.text({area.left, area.top - 9},
                   sheet.fitting(from.title, {size.title, weight::semibold, palette::ink},
                                 area.right - area.left + 60),
                   {size.title, weight::semibold, palette::ink});
    sheet.text({(area.left + area.right) / 2, area.bottom + 1.5 * size.tick + 1.6 * size.label},
               sheet.fitting(from.x_label, label_font, area.right - area.left + 60), label_font,
               align::centre);
}

/* Whether the upper end of a guide has fewer points of curves near it than the lower one. */
bool upper_end_is_free(const plot &area, const panel &from, double x)
{
    const double near = 22;
    const int steps = 12; /* samples a segment */
    int upper = 0, lower = 0;
    for (const series &one : from.lines)
        for (size_t i = 1; i < one.x.size(); i++)
            for (int s = 0; s <= steps; s++) {
                point2 a = area.at(one.x[i - 1], one.y[i - 1]), b = area.at(one.x[i], one.y[i]);
                point2 at = {a.x + (b.x - a.x) * s / steps, a.y + (b.y - a.y) * s / steps};
                if (std::fabs(at.x - x) < near)
                    (at.y < (area.top + area.bottom) / 2 ? upper : lower)++;
            }
    return upper <= lower;
}

void draw_guides(paper &sheet, const plot &area, const panel &from, const measure &size)
{
    const colour ink = palette::pale_ink;
    for (const guide &one : from.guides) {
        if (!is_within(one.on_x ? area.x : area.y, one.value))
            continue;
        if (one.on_x) {
            double x = area.at(one.value, area.y.low).x;
            sheet.dashed({x, area.top}, {x, area.bottom}, 1.3, 4, 4, ink);
            draw_guide_label(sheet, x, area.left, area.top, area.bottom,
                             upper_end_is_free(area, from, x), one.label);
        } else {
            double y = area.at(area.x.low, one.value).y;
            const font style = {size.tick, weight::regular, palette::grey_ink};
            sheet.dashed({area.left, y}, {area.right, y}, 1.3, 4, 4, ink);
            sheet.text({area.left + 6, y - 4},
                       sheet.fitting(one.label, style, (area.right - area.left) * .8), style);
        }
    }
}

void draw_series(paper &sheet, const plot &area, const series &one, const measure &size)
{
    colour paint = look_colour(one.look);
    std::vector<point2> points;
    for (size_t i = 0; i < one.x.size(); i++)
        points.push_back(area.at(one.x[i], one.y[i]));
    for (size_t i = 0; i < one.low.size(); i++)
        sheet.line(area.at(one.x[i], one.low[i]), area.at(one.x[i], one.high[i]), 1.4,
                   paint.with_alpha(.55));
    for (size_t i = 1; i < points.size() && one.dashed; i++)
        sheet.dashed(points[i - 1], points[i], .7 * size.line, 5, 4.5, paint.with_alpha(.85));
    if (!one.dashed)
        sheet.polyline(points, size.line, paint);
    const size_t many = 40; /* points: then the curve alone is clearer */
    for (point2 at : points)
        if (points.size() < many)
            draw_marker(sheet, at, one.look, one.dashed ? .7 * size.marker : size.marker, paint);
}

void draw_names(paper &sheet, const plot &area, const panel &from, const measure &size, double room)
{
    const double step = 1.22 * size.name, off = 6;
    std::vector<double> wished;
    std::vector<const series *> named;
    for (const series &one : from.lines)
        if (!one.x.empty() && !one.name.empty()) {
            named.push_back(&one);
            wished.push_back(area.at(one.x.back(), one.y.back()).y);
        }
    std::vector<double> placed = spread(wished, step, area.top - step, area.bottom + step / 2);
    for (size_t i = 0; i < named.size(); i++) {
        const font style = {size.name, weight::semibold, look_ink(named[i]->look)};
        point2 end = area.at(named[i]->x.back(), named[i]->y.back());
        double x = area.right + off;
        bool moved = std::fabs(placed[i] - end.y) > 4 || x - end.x > 2 * off;
        if (moved)
            sheet.line({end.x + size.marker + 2, end.y}, {x - 2, placed[i]}, .9,
                       look_colour(named[i]->look).with_alpha(.55));
        sheet.text({x + 2, placed[i] + .36 * size.name},
                   sheet.fitting(named[i]->name, style, room - off - 2), style);
    }
}

double widest_name(paper &sheet, const panel_figure &figure, const measure &size)
{
    double widest = 0;
    for (const panel &one : figure.panels)
        for (const series &line : one.lines)
            widest = std::max(
                widest, sheet.text_width(line.name, {size.name, weight::semibold, palette::ink}));
    return widest;
}

chart_axis axis_for(const std::vector<double> &values, const std::string &label, bool linear,
                    double length)
{
    const double room = 40; /* of a tick's label */
    if (linear)
        return make_linear_axis(values);
    return make_axis(values, label, size_t(std::clamp(length / room, 4.0, 9.0)));
}

void draw_panel(paper &sheet, const panel &from, const ranges &shown, plot area,
                const measure &size, double name_room)
{
    area.x = axis_for(shown.x, from.x_label, from.x_linear, area.right - area.left);
    area.y = axis_for(shown.y, from.y_label, from.y_linear, 1.3 * (area.bottom - area.top));
    draw_frame(sheet, area, from, size);
    draw_guides(sheet, area, from, size);
    for (size_t i = from.lines.size(); i-- > 0;)
        draw_series(sheet, area, from.lines[i], size);
    draw_names(sheet, area, from, size, name_room);
}

void draw_all(paper &sheet, const scene &from)
{
    const panel_figure &figure = from.shown.curves;
    size_t columns = std::min(figure.columns, figure.panels.size());
    size_t rows = (figure.panels.size() + columns - 1) / columns;
    measure size = measure_for(columns);
    double top = draw_figure_title(sheet, from.title, from.subtitle);
    double bottom = sheet.height() - (from.shown.legend.empty() ? 14 : 44);
    double cell_width = (sheet.width() - 40) / double(columns);
    double cell_height = (bottom - top) / double(rows);
    double name_room = std::min(widest_name(sheet, figure, size) + 12, .36 * cell_width);
    ranges together;
    for (const panel &one : figure.panels)
        add_ranges(together, one);
    for (size_t i = 0; i < figure.panels.size(); i++) {
        const panel &one = figure.panels[i];
        ranges own;
        add_ranges(own, one);
        const ranges &shown = figure.shared_axes ? together : own;
        if (own.x.empty())
            continue;
        double x = 20 + cell_width * double(i % columns),
               y = top + cell_height * double(i / columns);
        plot area = {x + 4 * size.tick + 14,
                     x + cell_width - name_room,
                     y + (one.title.empty() ? 12 : 34),
                     y + cell_height - 3.4 * size.label - 10,
                     {},
                     {}};
        draw_panel(sheet, one, shown, area, size, name_room);
        if (i % columns == 0)
            sheet.upward_text({x + 4, (area.top + area.bottom) / 2},
                              sheet.fitting(one.y_label,
                                            {size.label, weight::regular, palette::ink},
                                            area.bottom - area.top + 30),
                              {size.label, weight::regular, palette::ink});
    }
    draw_key(sheet, from.shown.legend);
}
} // namespace

image draw_panels(const scene &from, picture_size size)
{
    bool any = false;
    for (const panel &one : from.shown.curves.panels)
        for (const series &line : one.lines)
            any = any || !line.x.empty();
    if (!any)
        throw not_showable("There is nothing to chart: no point was measured.");
    canvas target(size.width, size.height, backdrop::plain);
    target.on_paper([&](paper &sheet) { draw_all(sheet, from); });
    return target.draw();
}
