/* Horizontal bars in groups; see pictures.hpp. */
#include "graders/render/canvas.hpp"
#include "graders/render/pictures.hpp"
#include "graders/render/plot.hpp"

#include <cmath>

namespace
{
const double group_share = .55; /* height of a space between groups, in bars */
const double title_share = 1.15;

/* From the upper edge of a group's first bar to the lower edge of its last. */
struct span {
    double top, bottom;
};

struct layout {
    double left, right, top, bottom; /* of the plot */
    double pitch;                    /* from bar to bar */
    double text;                     /* size of names */
    chart_axis axis;
    double base; /* where bars begin */
    std::vector<span> spans;

    double x(double value) const
    {
        return left + (right - left) * std::clamp(axis.place(value), 0.0, 1.0);
    }
};

/* The height of everything, in bars. */
double total_share(const bar_figure &figure)
{
    double share = 0;
    for (const bar_group &group : figure.groups)
        share += double(group.bars.size()) + (group.title.empty() ? 0 : title_share);
    return share + group_share * double(figure.groups.size() - 1);
}

chart_axis axis_of(const bar_figure &figure)
{
    std::vector<double> values;
    for (const bar_group &group : figure.groups)
        for (const bar &one : group.bars)
            for (double value : {one.value, one.low, one.high, one.tick})
                if (!std::isnan(value))
                    values.push_back(value);
    for (const guide &one : figure.guides)
        values.push_back(one.value);
    return figure.logarithmic ? make_axis(values, figure.x_label) : make_linear_axis(values);
}

double widest(paper &sheet, const bar_figure &figure, std::string bar::*text, const font &style)
{
    double most = 0;
    for (const bar_group &group : figure.groups)
        for (const bar &one : group.bars)
            most = std::max(most, sheet.text_width(one.*text, style));
    return most;
}

layout lay_out(paper &sheet, const bar_figure &figure, double top, double bottom)
{
    layout place;
    place.pitch = std::min(34.0, (bottom - top) / total_share(figure));
    place.text = std::clamp(.62 * place.pitch, 8.0, 14.5);
    place.top = top;
    place.bottom = top + place.pitch * total_share(figure);
    const font name = {place.text, weight::regular, palette::ink};
    const font label = {place.text, weight::semibold, palette::ink};
    place.left = 24 + std::min(widest(sheet, figure, &bar::name, name), .36 * sheet.width()) + 10;
    place.right = sheet.width() - 24 -
                  std::min(widest(sheet, figure, &bar::label, label), .3 * sheet.width());
    place.axis = axis_of(figure);
    /* On a logarithmic axis no bar can begin at 0: it begins where the first guide stands. */
    bool guided = figure.logarithmic && !figure.guides.empty();
    place.base = guided ? place.x(figure.guides[0].value) : place.left;
    double y = place.top;
    for (const bar_group &group : figure.groups) {
        y += group.title.empty() ? 0 : title_share * place.pitch;
        place.spans.push_back({y, y + place.pitch * double(group.bars.size())});
        y = place.spans.back().bottom + group_share * place.pitch;
    }
    return place;
}

void draw_grid(paper &sheet, const layout &place, const bar_figure &figure)
{
    const font tick_font = {12, weight::regular, palette::grey_ink};
    for (const tick &t : place.axis.ticks) {
        double x = place.x(t.value);
        for (const span &one : place.spans)
            sheet.rectangle({x - .5, one.top}, 1, one.bottom - one.top, palette::hairline);
        sheet.text({x, place.bottom + 18}, t.label, tick_font, align::centre);
    }
    const font label_font = {13.5, weight::regular, palette::ink};
    sheet.text({(place.left + place.right) / 2, place.bottom + 40},
               sheet.fitting(figure.x_label, label_font, sheet.width() - 2 * 24), label_font,
               align::centre);
}

void draw_guides(paper &sheet, const layout &place, const bar_figure &figure)
{
    const font style = {12, weight::regular, palette::grey_ink};
    for (const guide &one : figure.guides) {
        double x = place.x(one.value);
        for (const span &span : place.spans)
            sheet.dashed({x, span.top - 2}, {x, span.bottom + 2}, 1.6, 5, 4, palette::grey_ink);
        double width = sheet.text_width(one.label, style);
        sheet.text({std::clamp(x, width / 2 + 4, sheet.width() - width / 2 - 4), place.top - 6},
                   one.label, style, align::centre);
    }
}

void draw_bar(paper &sheet, const layout &place, const bar &one, double middle)
{
    const double thick = .68 * place.pitch;
    const font name = {place.text, weight::regular, palette::ink};
    const font label = {place.text, weight::semibold, palette::ink};
    double baseline = middle + .36 * place.text, end = place.left;
    sheet.text({place.left - 10, baseline}, sheet.fitting(one.name, name, .36 * sheet.width()),
               name, align::right);
    if (!std::isnan(one.value)) {
        double at = place.x(one.value);
        sheet.rectangle({std::min(at, place.base), middle - thick / 2},
                        std::max(std::fabs(at - place.base), 1.5), thick, look_colour(one.look));
        end = std::max(at, place.base);
    }
    if (!std::isnan(one.low) && !std::isnan(one.high)) {
        double low = place.x(one.low), high = place.x(one.high);
        const double cap = .2 * place.pitch;
        sheet.line({low, middle}, {high, middle}, 1.6, palette::ink);
        sheet.line({low, middle - cap}, {low, middle + cap}, 1.6, palette::ink);
        sheet.line({high, middle - cap}, {high, middle + cap}, 1.6, palette::ink);
        end = std::max(end, high);
    }
    if (!std::isnan(one.tick)) {
        double x = place.x(one.tick);
        sheet.rectangle({x - 2.6, middle - .46 * place.pitch}, 5.2, .92 * place.pitch,
                        palette::paper);
        sheet.rectangle({x - 1.4, middle - .42 * place.pitch}, 2.8, .84 * place.pitch,
                        palette::ink);
        end = std::max(end, x + 1.4);
    }
    double room = std::max(sheet.width() - 14 - end, 40.0);
    sheet.text({end + 7, baseline}, sheet.fitting(one.label, label, room), label);
}

void draw_all(paper &sheet, const scene &from)
{
    const bar_figure &figure = from.shown.bars;
    double top =
        draw_figure_title(sheet, from.title, from.subtitle) + (figure.guides.empty() ? 8 : 30);
    layout place =
        lay_out(sheet, figure, top, sheet.height() - (from.shown.legend.empty() ? 58 : 86));
    draw_grid(sheet, place, figure);
    for (size_t g = 0; g < figure.groups.size(); g++) {
        const bar_group &group = figure.groups[g];
        const span &span = place.spans[g];
        const font style = {place.text + .5, weight::semibold, palette::ink};
        sheet.text({24, span.top - .35 * place.pitch},
                   sheet.fitting(group.title, style, sheet.width() - 48), style);
        for (size_t i = 0; i < group.bars.size(); i++)
            draw_bar(sheet, place, group.bars[i], span.top + place.pitch * (double(i) + .5));
        sheet.rectangle({place.base - .7, span.top}, 1.4, span.bottom - span.top,
                        palette::pale_ink);
    }
    draw_guides(sheet, place, figure);
    draw_key(sheet, from.shown.legend);
}
} // namespace

image draw_bars(const scene &from, picture_size size)
{
    if (from.shown.bars.groups.empty())
        throw not_showable("There is nothing to chart: there are no bars.");
    canvas target(size.width, size.height, backdrop::plain);
    target.on_paper([&](paper &sheet) { draw_all(sheet, from); });
    return target.draw();
}
