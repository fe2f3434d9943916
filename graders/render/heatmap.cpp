/* A table whose cells have colours; see pictures.hpp. */
#include "graders/render/canvas.hpp"
#include "graders/render/pictures.hpp"
#include "graders/render/plot.hpp"

#include <cmath>
#include <iterator>
#include <sstream>

namespace
{
struct layout {
    double left, top, cell_width, cell_height, text;
};

/* The colour of a share of the range, 0 ... 1. */
colour heat_colour(double share)
{
    const size_t last = std::size(palette::heat) - 1;
    double at = std::clamp(share, 0.0, 1.0) * double(last);
    size_t below = std::min(size_t(at), last - 1);
    double part = at - double(below);
    colour a = palette::heat[below], b = palette::heat[below + 1];
    auto mixed = [&](uint8_t from, uint8_t to) {
        return uint8_t(std::lround(from + (to - from) * part));
    };
    return {mixed(a.red, b.red), mixed(a.green, b.green), mixed(a.blue, b.blue)};
}

double luminance(colour c)
{
    return (.299 * c.red + .587 * c.green + .114 * c.blue) / 255;
}

double share_of(const heat_figure &figure, double value)
{
    return std::log(value / figure.low) / std::log(figure.high / figure.low);
}

double longest_word(paper &sheet, const std::string &words, const font &style)
{
    double longest = 0;
    std::istringstream in(words);
    for (std::string word; in >> word;)
        longest = std::max(longest, sheet.text_width(word, style));
    return longest;
}

/* Columns' names stand in at most three lines. */
void draw_column_name(paper &sheet, const layout &place, size_t c, const std::string &name)
{
    font style = {std::min(12.5, place.text + .5), weight::semibold, palette::ink};
    while (style.size > 8 && longest_word(sheet, name, style) > place.cell_width - 4)
        style.size -= .5;
    std::vector<std::string> lines = sheet.wrapped(name, style, place.cell_width - 4, 3);
    double y = place.top - 8 - 1.25 * style.size * double(lines.size() - 1);
    for (const std::string &line : lines) {
        sheet.text({place.left + place.cell_width * (double(c) + .5), y}, line, style,
                   align::centre);
        y += 1.25 * style.size;
    }
}

void draw_cell(paper &sheet, const layout &place, const heat_figure &figure, size_t r, size_t c)
{
    const heat_cell &cell = figure.cells[r * figure.columns.size() + c];
    const double gap = 1.2;
    point2 corner = {place.left + place.cell_width * double(c) + gap,
                     place.top + place.cell_height * double(r) + gap};
    double width = place.cell_width - 2 * gap, height = place.cell_height - 2 * gap;
    bool empty = std::isnan(cell.value);
    colour fill = empty ? palette::sheet : heat_colour(share_of(figure, cell.value));
    sheet.rectangle(corner, width, height, fill);
    colour ink = empty ? palette::pale_ink : luminance(fill) > .55 ? palette::ink : palette::paper;
    const font style = {place.text, weight::regular, ink};
    sheet.text({corner.x + width / 2, corner.y + height / 2 + .36 * place.text},
               sheet.fitting(cell.label, style, width - 2), style, align::centre);
}

void draw_scale(paper &sheet, const heat_figure &figure)
{
    const int steps = 60;
    const double width = 240, height = 12, y = sheet.height() - 36;
    const font style = {13, weight::regular, palette::ink};
    double left = sheet.width() / 2 - width / 2;
    for (int i = 0; i < steps; i++)
        sheet.rectangle({left + width * i / steps, y}, width / steps + .3, height,
                        heat_colour(i / double(steps - 1)));
    sheet.text({left - 10, y + 11}, figure.low_label, style, align::right);
    sheet.text({left + width + 10, y + 11}, figure.high_label, style);
}

void draw_all(paper &sheet, const scene &from)
{
    const heat_figure &figure = from.shown.heat;
    double top = draw_figure_title(sheet, from.title, from.subtitle) + 54;
    layout place;
    place.cell_height = std::min(40.0, (sheet.height() - 54 - top) / double(figure.rows.size()));
    place.text = std::clamp(.46 * place.cell_height, 7.5, 13.5);
    const font name = {std::min(13.5, place.text + 1.5), weight::regular, palette::ink};
    double name_width = 0;
    for (const std::string &row : figure.rows)
        name_width = std::max(name_width, sheet.text_width(row, name));
    place.left = 24 + std::min(name_width, .3 * sheet.width()) + 10;
    place.top = top;
    place.cell_width = (sheet.width() - 24 - place.left) / double(figure.columns.size());
    for (size_t c = 0; c < figure.columns.size(); c++)
        draw_column_name(sheet, place, c, figure.columns[c]);
    for (size_t r = 0; r < figure.rows.size(); r++) {
        double middle = place.top + place.cell_height * (double(r) + .5);
        sheet.text({place.left - 10, middle + .36 * name.size},
                   sheet.fitting(figure.rows[r], name, .3 * sheet.width()), name, align::right);
        for (size_t c = 0; c < figure.columns.size(); c++)
            draw_cell(sheet, place, figure, r, c);
    }
    draw_scale(sheet, figure);
}
} // namespace

image draw_heatmap(const scene &from, picture_size size)
{
    if (from.shown.heat.rows.empty() || from.shown.heat.columns.empty())
        throw not_showable("There is nothing to chart: the table is empty.");
    canvas target(size.width, size.height, backdrop::plain);
    target.on_paper([&](paper &sheet) { draw_all(sheet, from); });
    return target.draw();
}
