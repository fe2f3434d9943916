/* Contact sheets: many small pictures with captions; see pictures.hpp. */
#include "graders/render/canvas.hpp"
#include "graders/render/pictures.hpp"
#include "graders/render/text.hpp"

#include <stdexcept>

namespace
{
const int margin = 20, gap = 14, head = 84, caption_height = 50;
const int side_limit = 8000; /* pixels */
const int columns_limit = 12;

/* Pixels from the upper left corner. */
struct grid {
    int columns, rows, cell_width, cell_height, width, height;

    int left(size_t i) const
    {
        return margin + int(i % columns) * (cell_width + gap);
    }
    int top(size_t i) const
    {
        return head + int(i / columns) * (cell_height + caption_height + gap);
    }
};

/* Cells get smaller as they get more, down to a thumb's size; what does not fit then is left out.
 */
grid layout_of(const sheet &from)
{
    grid g;
    size_t count = std::max<size_t>(1, from.cells.size());
    g.columns = std::clamp(from.columns, 1, columns_limit);
    g.columns = int(std::min<size_t>(g.columns, count));
    g.cell_width = g.columns <= 3 ? 400 : g.columns <= 6 ? 300 : 220;
    g.cell_height = g.cell_width * 3 / 4;
    int rows_limit = (side_limit - head - margin) / (g.cell_height + caption_height + gap);
    g.rows = int(std::min<size_t>((count + g.columns - 1) / g.columns, rows_limit));
    g.width = 2 * margin + g.columns * (g.cell_width + gap) - gap;
    g.height = head + g.rows * (g.cell_height + caption_height + gap) - gap + margin;
    return g;
}

/* Two lines: the first bold, the second grey. `pixel` is a pixel in units of paper. */
void draw_caption(paper &page, point2 at, const std::string &caption, double width, double pixel)
{
    size_t end = std::min(caption.find('\n'), caption.size());
    const font bold = {14 * pixel, weight::semibold, palette::ink};
    const font plain = {13 * pixel, weight::regular, palette::grey_ink};
    page.text({at.x, at.y + 18 * pixel}, page.fitting(caption.substr(0, end), bold, width), bold);
    if (end < caption.size())
        page.text({at.x, at.y + 37 * pixel}, page.fitting(caption.substr(end + 1), plain, width),
                  plain);
}

/* Everything but the pictures. */
image draw_page(const sheet &from, const grid &g, size_t shown)
{
    canvas target(g.width, g.height, backdrop::plain, 1); /* only text and rectangles */
    double pixel = paper_height / g.height;
    target.on_paper([&](paper &page) {
        page.rectangle({0, 0}, page.width(), page.height(), palette::sheet);
        const font title = {22 * pixel, weight::semibold, palette::ink};
        const font subtitle = {14 * pixel, weight::regular, palette::grey_ink};
        double room = page.width() - 2 * margin * pixel;
        bool spanish = from.language == "es";
        std::string more = shown < from.cells.size()
                               ? (spanish ? "   las primeras " : "   the first ") +
                                     std::to_string(shown) + (spanish ? " de " : " of ") +
                                     std::to_string(from.cells.size())
                               : "";
        page.text({margin * pixel, 38 * pixel}, page.fitting(from.title, title, room), title);
        page.text({margin * pixel, 64 * pixel}, page.fitting(from.subtitle + more, subtitle, room),
                  subtitle);
        for (size_t i = 0; i < shown; i++) {
            point2 corner = {g.left(i) * pixel, g.top(i) * pixel};
            double width = g.cell_width * pixel, height = g.cell_height * pixel;
            page.rectangle({corner.x - pixel, corner.y - pixel}, width + 2 * pixel,
                           height + 2 * pixel, {208, 214, 224});
            page.rectangle(corner, width, height, {228, 232, 239});
            page.text({corner.x + width / 2, corner.y + height / 2},
                      spanish ? "sin imagen" : "no picture",
                      {13 * pixel, weight::regular, palette::pale_ink}, align::centre);
            draw_caption(page, {corner.x, corner.y + height}, from.cells[i].caption, width, pixel);
        }
    });
    return target.draw();
}
} // namespace

image draw_sheet(const sheet &from)
{
    grid g = layout_of(from);
    size_t shown = std::min(from.cells.size(), size_t(g.rows) * g.columns);
    image page = draw_page(from, g, shown);
    for (size_t i = 0; i < shown; i++) {
        if (from.cells[i].picture_path.empty())
            continue;
        try {
            image picture = read_image(from.cells[i].picture_path);
            paste_image(page, fit_image(picture, g.cell_width, g.cell_height), g.left(i), g.top(i));
        } catch (const std::runtime_error &) {
            continue; /* the frame already says "no picture" */
        }
    }
    return page;
}
