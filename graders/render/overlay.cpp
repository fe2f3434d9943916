/* See overlay.hpp. */
#include "graders/render/overlay.hpp"

namespace
{
const double margin = 24, swatch_width = 26, row_height = 24, axes_room = 96, entry_gap = 22;
const font title_font = {20, weight::semibold, palette::ink};
const font subtitle_font = {13, weight::regular, palette::grey_ink};
const font name_font = {13.5, weight::regular, palette::ink};
const font count_font = {13.5, weight::semibold, palette::ink};
const font muted_font = {13.5, weight::regular, palette::grey_ink};

double entry_width(paper &sheet, const legend_entry &entry)
{
    double width = swatch_width + 8 + sheet.text_width(entry.name, name_font);
    if (!entry.count.empty())
        width += 6 + sheet.text_width(entry.count, entry.muted ? muted_font : count_font);
    return width;
}

void draw_entry(paper &sheet, const legend_entry &entry, point2 at)
{
    entry.swatch(sheet, {at.x + swatch_width / 2, at.y - 5}, swatch_width);
    double x = at.x + swatch_width + 8;
    x += sheet.text({x, at.y}, entry.name, entry.muted ? muted_font : name_font) + 6;
    if (!entry.count.empty())
        sheet.text({x, at.y}, entry.count, entry.muted ? muted_font : count_font);
}

using row = std::vector<size_t>;

std::vector<row> legend_layout(paper &sheet, const std::vector<legend_entry> &entries)
{
    const double room = sheet.width() - 2 * margin - axes_room;
    std::vector<row> rows;
    double used = room + 1;
    for (size_t i = 0; i < entries.size(); i++) {
        double width = entry_width(sheet, entries[i]);
        if (used + entry_gap + width > room) {
            rows.push_back({});
            used = -entry_gap;
        }
        rows.back().push_back(i);
        used += entry_gap + width;
    }
    return rows;
}

double row_width(paper &sheet, const std::vector<legend_entry> &entries, const row &line)
{
    double width = -entry_gap;
    for (size_t i : line)
        width += entry_gap + entry_width(sheet, entries[i]);
    return width;
}

/* Keeps the words readable over shadows and over the mesh. */
void draw_plate(paper &sheet, const std::vector<legend_entry> &entries,
                const std::vector<row> &rows)
{
    const double pad = 12, ascent = 19, descent = 11;
    double width = 0, height = row_height * double(rows.size() - 1);
    for (const row &line : rows)
        width = std::max(width, row_width(sheet, entries, line));
    sheet.rounded({sheet.width() - margin - width - pad, sheet.height() - margin - height - ascent},
                  width + 2 * pad, height + ascent + descent, 8, palette::paper.with_alpha(.8));
}
} // namespace

void draw_title(paper &sheet, const std::string &title, const std::string &subtitle)
{
    const double smallest_title = 15;
    double room = sheet.width() - 2 * margin;
    font style = title_font;
    while (style.size > smallest_title && sheet.text_width(title, style) > room)
        style.size -= 1;
    sheet.text({margin, 33}, sheet.fitting(title, style, room), style);
    double y = 55;
    for (const std::string &line : sheet.wrapped(subtitle, subtitle_font, room, 2)) {
        sheet.text({margin, y}, line, subtitle_font);
        y += 18;
    }
}

void draw_label(paper &sheet, point2 at, point2 away, const std::string &words, bool muted)
{
    const font style = {muted ? 9.5 : 10.5, muted ? weight::regular : weight::semibold,
                        muted ? palette::grey_ink : palette::ink};
    const double height = 14, reach = 13, ring = 2.6;
    double size = std::hypot(away.x, away.y);
    point2 unit = size > 0 ? point2{away.x / size, away.y / size} : point2{0, -1};
    double width = sheet.text_width(words, style) + 8;
    double x = at.x + unit.x * (reach + width / 2 - 6), y = at.y + unit.y * reach;
    x = std::clamp(x, width / 2 + 2, sheet.width() - width / 2 - 2);
    if (muted)
        sheet.circle(at, ring, 1, palette::grey_ink.with_alpha(.7));
    sheet.rounded({x - width / 2, y - height / 2}, width, height, height / 2,
                  palette::paper.with_alpha(muted ? .45 : .82));
    sheet.text({x, y + 3.8}, words, style, align::centre);
}

void draw_sign(paper &sheet, point2 at, const std::string &words, sign shape, bool muted)
{
    const font style = {11, weight::semibold, muted ? palette::grey_ink : palette::ink};
    const double height = 17, rim = 1.2;
    double width = std::max(sheet.text_width(words, style) + (shape == sign::box ? 7 : 9), height);
    double radius = shape == sign::box ? 1.5 : height / 2;
    point2 corner = {std::clamp(at.x - width / 2, 3.0, sheet.width() - width - 3),
                     at.y - height / 2};
    colour ink = muted ? palette::pale_ink : palette::ink;
    sheet.rounded({corner.x - rim, corner.y - rim}, width + 2 * rim, height + 2 * rim, radius + rim,
                  ink.with_alpha(muted ? .6 : 1));
    sheet.rounded(corner, width, height, radius, palette::paper.with_alpha(muted ? .9 : 1));
    sheet.text({corner.x + width / 2, at.y + 4}, words, style, align::centre);
}

void draw_legend(paper &sheet, const std::vector<legend_entry> &entries)
{
    if (entries.empty())
        return;
    std::vector<row> rows = legend_layout(sheet, entries);
    draw_plate(sheet, entries, rows);
    double y = sheet.height() - margin - row_height * double(rows.size() - 1);
    for (const row &line : rows) {
        double x = sheet.width() - margin - row_width(sheet, entries, line);
        for (size_t i : line) {
            draw_entry(sheet, entries[i], {x, y});
            x += entry_gap + entry_width(sheet, entries[i]);
        }
        y += row_height;
    }
}

void draw_axes(paper &sheet, const view &look)
{
    struct axis {
        const char *name;
        vec3 along;
        colour paint;
    };
    const double reach = 34;
    const point2 origin = {margin + 34, sheet.height() - 54};
    axis axes[] = {{"x", {1, 0, 0}, {204, 51, 63}},
                   {"y", {0, 1, 0}, {62, 138, 62}},
                   {"z", {0, 0, 1}, {48, 98, 192}}};
    std::sort(std::begin(axes), std::end(axes), [&](const axis &a, const axis &b) {
        return dot(a.along, look.toward) < dot(b.along, look.toward);
    });
    const font letter = {10.5, weight::semibold, {255, 255, 255}};
    for (const axis &one : axes) {
        point2 tip = {origin.x + reach * dot(one.along, look.right),
                      origin.y - reach * dot(one.along, look.up)};
        sheet.line(origin, tip, 2, one.paint);
        sheet.disc(tip, 7.5, one.paint);
        sheet.text({tip.x, tip.y + 3.4}, one.name, letter, align::centre);
    }
    sheet.disc(origin, 2.5, palette::grey_ink);
}
