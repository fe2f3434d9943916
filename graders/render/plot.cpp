/* See plot.hpp. */
#include "graders/render/plot.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

colour look_colour(size_t look)
{
    return palette::looks[look % std::size(palette::looks)];
}

colour look_ink(size_t look)
{
    return look_colour(look).darker(.78);
}

double draw_figure_title(paper &sheet, const std::string &title, const std::string &subtitle)
{
    draw_title(sheet, title, subtitle);
    const font subtitle_font = {13, weight::regular, palette::grey_ink};
    size_t lines = sheet.wrapped(subtitle, subtitle_font, sheet.width() - 48, 2).size();
    return 48 + 18 * double(lines);
}

static void draw_swatch(paper &sheet, const key_entry &entry, point2 at, double width)
{
    colour paint = look_colour(entry.look);
    double left = at.x - width / 2, right = at.x + width / 2;
    switch (entry.shape) {
    case key_shape::bar:
        return sheet.rectangle({left, at.y - 6}, width, 12, paint);
    case key_shape::tick:
        return sheet.rectangle({at.x - 1.5, at.y - 8}, 3, 16, paint);
    case key_shape::line:
        return sheet.line({left, at.y}, {right, at.y}, 2.6, paint);
    case key_shape::point:
        return sheet.disc(at, 5, paint);
    case key_shape::face:
        return sheet.polygon({{at.x - 9, at.y + 7}, {at.x + 9, at.y + 7}, {at.x, at.y - 8}}, paint);
    case key_shape::arrow:
        sheet.line({left, at.y}, {right - 8, at.y}, 3, paint);
        return sheet.polygon({{right - 10, at.y - 5.5}, {right - 10, at.y + 5.5}, {right, at.y}},
                             paint);
    }
}

void draw_key(paper &sheet, const std::vector<key_entry> &entries)
{
    std::vector<legend_entry> legend;
    for (const key_entry &entry : entries)
        legend.push_back(
            {sheet.fitting(entry.name, {13.5, weight::regular, palette::ink}, 320), "",
             [entry](paper &on, point2 at, double width) { draw_swatch(on, entry, at, width); }});
    if (!legend.empty())
        draw_legend(sheet, legend);
}

std::vector<double> spread(std::vector<double> wished, double height, double low, double high)
{
    size_t count = wished.size();
    std::vector<size_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return wished[a] < wished[b]; });
    /* Neighbours that overlap become a block around the mean of their wishes. */
    struct block {
        double middle;
        size_t size;
    };
    std::vector<block> blocks;
    for (size_t i : order) {
        blocks.push_back({wished[i], 1});
        while (blocks.size() > 1) {
            block &last = blocks.back(), &before = blocks[blocks.size() - 2];
            double apart = height * double(last.size + before.size) / 2;
            if (last.middle - before.middle >= apart)
                break;
            double size = double(last.size + before.size);
            before.middle =
                (before.middle * double(before.size) + last.middle * double(last.size)) / size;
            before.size += last.size;
            blocks.pop_back();
        }
    }
    std::vector<double> placed(count);
    double least = low;
    size_t next = 0, left = count;
    for (const block &one : blocks) {
        double half = height * double(one.size) / 2;
        double most = high - height * double(left);
        double start = std::max(least, std::min(one.middle - half, std::max(most, least)));
        for (size_t k = 0; k < one.size; k++)
            placed[order[next++]] = start + height * (double(k) + .5);
        least = start + 2 * half;
        left -= one.size;
    }
    return placed;
}

void draw_guide_label(paper &sheet, double x, double left, double top, double bottom, bool at_top,
                      const std::string &words)
{
    const font style = {11, weight::regular, palette::grey_ink};
    std::string shown = sheet.fitting(words, style, (bottom - top) * .9);
    double half = sheet.text_width(shown, style) / 2 + 5;
    bool right = x < left + 16;
    sheet.upward_text({right ? x + 12 : x - 4, at_top ? top + half : bottom - half}, shown, style);
}
