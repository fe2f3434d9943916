/* Curves on logarithmic axes; see pictures.hpp. */
#include "graders/render/axis.hpp"
#include "graders/render/canvas.hpp"
#include "graders/render/marker.hpp"
#include "graders/render/overlay.hpp"
#include "graders/render/pictures.hpp"
#include "graders/render/text.hpp"

#include <cstdio>
#include <iterator>

namespace
{
const font tick_font = {12, weight::regular, palette::grey_ink};
const font label_font = {13.5, weight::regular, palette::ink};
const double guide_width = 6, below_width = 7;
const colour guide_ink = palette::grey_ink.with_alpha(.3);
const font name_font = {14, weight::semibold, palette::ink};

struct plot_area {
    double left, right, top, bottom;
    chart_axis x, y;

    point2 at(double x_value, double y_value) const
    {
        return {left + (right - left) * x.place(x_value),
                bottom - (bottom - top) * y.place(y_value)};
    }
};

bool is_submission(const curve &one)
{
    return one.name == "submission";
}

/* What a submission is held against: the reference's measures or the right values. */
bool is_yardstick(const curve &one)
{
    return one.name == "reference" || one.name == "right";
}

/* A line for the eye, as the growth that is allowed: wide, pale, without markers. */
bool is_guide(const curve &one)
{
    return !one.guide.empty();
}

/* Colours and markers go with the name, so that the submission looks the same in every chart. */
size_t look_of(const std::vector<curve> &curves, size_t index)
{
    if (is_submission(curves[index]))
        return 0;
    if (is_yardstick(curves[index]))
        return 1;
    bool named = false;
    size_t before = 0;
    for (size_t i = 0; i < curves.size(); i++) {
        bool special = is_submission(curves[i]) || is_yardstick(curves[i]);
        named = named || special;
        before += i < index && !special;
    }
    return (before + (named ? 2 : 0)) % std::size(palette::curves);
}

void draw_axes_and_grid(paper &sheet, const plot_area &area, const scene &from)
{
    for (const tick &t : area.x.ticks) {
        double x = area.left + (area.right - area.left) * area.x.place(t.value);
        sheet.rectangle({x - .5, area.top}, 1, area.bottom - area.top, palette::hairline);
        sheet.text({x, area.bottom + 21}, t.label, tick_font, align::centre);
    }
    for (const tick &t : area.y.ticks) {
        double y = area.bottom - (area.bottom - area.top) * area.y.place(t.value);
        sheet.rectangle({area.left, y - .5}, area.right - area.left, 1, palette::hairline);
        sheet.text({area.left - 10, y + 4.4}, t.label, tick_font, align::right);
    }
    sheet.rectangle({area.left, area.bottom - .7}, area.right - area.left, 1.4, palette::pale_ink);
    sheet.text({(area.left + area.right) / 2, area.bottom + 46},
               sheet.fitting(from.x_label, label_font, area.right - area.left), label_font,
               align::centre);
    sheet.upward_text({26, (area.top + area.bottom) / 2},
                      sheet.fitting(from.y_label, label_font, area.bottom - area.top), label_font);
}

/* The fitted line y = c x^e, through the points' geometric mean, where the curve has points. */
void draw_fit(paper &sheet, const plot_area &area, const curve &one, colour paint)
{
    if (one.exponent == 0 || one.x.size() < 2)
        return;
    double log_x = 0, log_y = 0;
    for (size_t i = 0; i < one.x.size(); i++) {
        log_x += std::log(one.x[i]) / double(one.x.size());
        log_y += std::log(one.y[i]) / double(one.x.size());
    }
    auto [first, last] = std::minmax_element(one.x.begin(), one.x.end());
    auto fitted = [&](double x) { return std::exp(log_y + one.exponent * (std::log(x) - log_x)); };
    sheet.dashed(area.at(*first, fitted(*first)), area.at(*last, fitted(*last)), 1.6, 5, 6,
                 paint.with_alpha(.6));
}

void draw_curve(paper &sheet, const plot_area &area, const curve &one, size_t look)
{
    std::vector<point2> points;
    for (size_t i = 0; i < one.x.size(); i++)
        points.push_back(area.at(one.x[i], one.y[i]));
    if (is_guide(one))
        return sheet.polyline(points, guide_width, guide_ink);
    draw_fit(sheet, area, one, palette::curves[look]);
    if (is_yardstick(one)) /* wide and pale below: where curves are equal, both are seen */
        sheet.polyline(points, below_width, palette::curves[look].with_alpha(.4));
    else
        sheet.polyline(points, 2.6, palette::curves[look]);
    for (point2 at : points)
        draw_marker(sheet, at, look, is_yardstick(one) ? 6.4 : 4.6, palette::curves[look]);
}

std::string exponent_text(double exponent)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", exponent);
    return text;
}

/* A piece of the curve, for the legend. */
void draw_sample(paper &sheet, point2 at, const curve &one, size_t look)
{
    const double length = 34;
    if (is_guide(one))
        return sheet.line(at, {at.x + length, at.y}, guide_width, guide_ink);
    if (is_yardstick(one))
        sheet.line(at, {at.x + length, at.y}, below_width, palette::curves[look].with_alpha(.4));
    else
        sheet.line(at, {at.x + length, at.y}, 2.6, palette::curves[look]);
    draw_marker(sheet, {at.x + length / 2, at.y}, look, is_yardstick(one) ? 6.4 : 4.6,
                palette::curves[look]);
}

/* Entry: line and marker, name, and the fitted growth as "~ n" with a raised exponent. */
double draw_entry(paper &sheet, point2 at, const curve &one, size_t look, bool measure_only)
{
    const font raised = {10, weight::regular, palette::grey_ink};
    const font plain = {14, weight::regular, palette::grey_ink};
    std::string name = sheet.fitting(one.label, name_font, 260);
    double width = 46 + sheet.text_width(name, name_font);
    if (!measure_only) {
        draw_sample(sheet, {at.x, at.y - 5}, one, look);
        sheet.text({at.x + 46, at.y}, name, name_font);
    }
    if (one.exponent == 0)
        return width;
    width += 14;
    if (!measure_only) {
        sheet.text({at.x + width, at.y}, one.grows, plain);
        sheet.text({at.x + width + sheet.text_width(one.grows, plain) + 1.5, at.y - 6},
                   exponent_text(one.exponent), raised);
    }
    return width + sheet.text_width(one.grows, plain) + 2 +
           sheet.text_width(exponent_text(one.exponent), raised);
}

/* The corner of the plot where a card of this size covers least of the curves. */
point2 emptiest_corner(const plot_area &area, const std::vector<curve> &curves, double width,
                       double height)
{
    const double off = 14;
    const int steps = 16; /* samples a segment */
    double right = area.right - off - width, low = area.bottom - off - height;
    const point2 corners[] = {{area.left + off, area.top + 8},
                              {right, low},
                              {right, area.top + 8},
                              {area.left + off, low}};
    point2 best = corners[0];
    int least_covered = -1;
    for (point2 corner : corners) {
        int covered = 0;
        for (const curve &one : curves)
            for (size_t i = 1; i < one.x.size(); i++)
                for (int s = 0; s <= steps; s++) {
                    point2 a = area.at(one.x[i - 1], one.y[i - 1]);
                    point2 b = area.at(one.x[i], one.y[i]);
                    double x = a.x + (b.x - a.x) * s / steps, y = a.y + (b.y - a.y) * s / steps;
                    covered += x > corner.x - off && x < corner.x + width + off &&
                               y > corner.y - off && y < corner.y + height + off;
                }
        if (least_covered < 0 || covered < least_covered) {
            least_covered = covered;
            best = corner;
        }
    }
    return best;
}

void draw_legend_card(paper &sheet, const plot_area &area, const scene &from)
{
    const std::vector<curve> &curves = from.curves;
    const double row = 25, pad = 14;
    double width = 0;
    bool fitted = false;
    for (size_t i = 0; i < curves.size(); i++) {
        width = std::max(width, draw_entry(sheet, {}, curves[i], look_of(curves, i), true));
        fitted = fitted || curves[i].exponent != 0;
    }
    double height = row * double(curves.size()) + (fitted ? 20 : 0) + pad;
    point2 corner = emptiest_corner(area, curves, width + 2 * pad, height);
    sheet.rounded({corner.x - 1, corner.y - 1}, width + 2 * pad + 2, height + 2, 7,
                  palette::hairline);
    sheet.rounded(corner, width + 2 * pad, height, 6, palette::paper.with_alpha(.96));
    double y = corner.y + pad + 11;
    for (size_t i = 0; i < curves.size(); i++, y += row)
        draw_entry(sheet, {corner.x + pad, y}, curves[i], look_of(curves, i), false);
    if (fitted) {
        sheet.dashed({corner.x + pad, y - 8}, {corner.x + pad + 34, y - 8}, 1.6, 5, 6,
                     palette::pale_ink);
        sheet.text({corner.x + pad + 46, y - 3.5},
                   from.say("fitted growth", "crecimiento ajustado"),
                   {12, weight::regular, palette::grey_ink});
    }
}

/* The first curve of a kind that has points, or null. */
const curve *first_of(const std::vector<curve> &curves, bool (*is_kind)(const curve &))
{
    for (const curve &one : curves)
        if (is_kind(one) && !one.x.empty())
            return &one;
    return nullptr;
}

/* How many times the reference's the submission's last point is, as a bracket at its right. */
void draw_ratio(paper &sheet, const plot_area &area, const std::vector<curve> &curves)
{
    const curve *submission = first_of(curves, is_submission);
    const curve *reference = first_of(curves, is_yardstick);
    if (!submission || !reference || submission->x.back() != reference->x.back())
        return;
    double ratio = submission->y.back() / reference->y.back();
    point2 a = area.at(submission->x.back(), submission->y.back());
    point2 b = area.at(reference->x.back(), reference->y.back());
    if (std::fabs(a.y - b.y) < 16)
        return;
    double x = a.x + 13;
    sheet.line({x, a.y}, {x, b.y}, 1.4, palette::grey_ink);
    sheet.line({x - 5, a.y}, {x, a.y}, 1.4, palette::grey_ink);
    sheet.line({x - 5, b.y}, {x, b.y}, 1.4, palette::grey_ink);
    double times = std::max(ratio, 1 / ratio);
    std::string words = (ratio < 1 ? "÷ " : "× ") +
                        (times >= 9.95 ? short_number(std::round(times)) : exponent_text(times));
    sheet.text({x + 7, (a.y + b.y) / 2 + 5}, words, {14, weight::semibold, palette::ink});
}
} // namespace

image draw_chart(const scene &from, picture_size size)
{
    std::vector<double> xs, ys;
    for (const curve &one : from.curves) {
        xs.insert(xs.end(), one.x.begin(), one.x.end());
        ys.insert(ys.end(), one.y.begin(), one.y.end());
    }
    if (xs.empty())
        throw not_showable(from.say("There is nothing to chart: no point was measured.",
                                    "Nada que dibujar: no se midió ningún punto."));
    canvas target(size.width, size.height, backdrop::plain);
    target.on_paper([&](paper &sheet) {
        plot_area area = {108,
                          sheet.width() - 76,
                          100,
                          sheet.height() - 76,
                          make_axis_of_sizes(xs, from.x_label),
                          make_axis(ys, from.y_label)};
        draw_title(sheet, from.title, from.subtitle);
        draw_axes_and_grid(sheet, area, from);
        for (size_t i = from.curves.size(); i-- > 0;)
            draw_curve(sheet, area, from.curves[i], look_of(from.curves, i));
        draw_ratio(sheet, area, from.curves);
        draw_legend_card(sheet, area, from);
    });
    return target.draw();
}
