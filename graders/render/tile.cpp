/* Tiles for what cannot be drawn, and the choice between all kinds; see pictures.hpp. */
#include "graders/render/canvas.hpp"
#include "graders/render/overlay.hpp"
#include "graders/render/pictures.hpp"

image draw_tile(const scene &from, const std::string &sentence, picture_size size)
{
    canvas target(size.width, size.height, backdrop::gradient);
    target.on_paper([&](paper &sheet) {
        draw_title(sheet, from.title, from.subtitle);
        const font style = {18, weight::regular, palette::grey_ink};
        const double line_height = 28, icon = 30;
        double middle = sheet.width() / 2;
        std::vector<std::string> lines = sheet.wrapped(sentence, style, sheet.width() * .7, 6);
        double y = sheet.height() / 2 - line_height * double(lines.size()) / 2 + 30;
        point2 centre = {middle, y - 70};
        const point2 corners[] = {{centre.x - icon, centre.y + icon * .8},
                                  {centre.x + icon, centre.y + icon * .8},
                                  {centre.x, centre.y - icon}};
        for (int i = 0; i < 3; i++)
            sheet.dashed(corners[i], corners[(i + 1) % 3], 2.4, 7, 7, palette::pale_ink);
        for (point2 corner : corners)
            sheet.disc(corner, 4.2, palette::pale_ink);
        for (const std::string &line : lines) {
            sheet.text({middle, y}, line, style, align::centre);
            y += line_height;
        }
    });
    return target.draw();
}

static image draw_kind(const scene &from, picture_size size)
{
    switch (from.kind) {
    case scene_kind::mesh:
        return draw_mesh(from, size);
    case scene_kind::strips:
        return draw_strips(from, size);
    case scene_kind::voxels:
        return draw_voxels(from, size);
    case scene_kind::chart:
        return draw_chart(from, size);
    case scene_kind::panels:
        return draw_panels(from, size);
    case scene_kind::bars:
        return draw_bars(from, size);
    case scene_kind::heatmap:
        return draw_heatmap(from, size);
    case scene_kind::diagram:
        return draw_diagram(from, size);
    case scene_kind::none:
        break;
    }
    throw not_showable(from.say("Nothing to show: the answer is a number.",
                                "Nada que mostrar: la respuesta es un número."));
}

image draw_scene(const scene &from, picture_size size)
{
    try {
        return draw_kind(from, size);
    } catch (const not_showable &why) {
        return draw_tile(from, why.what(), size);
    }
}
