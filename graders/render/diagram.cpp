/* A mesh with coloured faces, arrows and words: how a structure hangs together; see pictures.hpp.
 */
#include "graders/render/canvas.hpp"
#include "graders/render/pictures.hpp"
#include "graders/render/plot.hpp"
#include "graders/render/shape.hpp"
#include "graders/render/solids.hpp"
#include "graders/render/surfaces.hpp"

#include <vtkCamera.h>

namespace
{
struct diagram {
    shape mesh;
    unit_box box;
    view look;
    double lift; /* towards the eye, so that arrows lie over the surface */

    vec3 place(vec3 point) const
    {
        return (point - box.centre) * box.scale + look.toward * lift;
    }
};

void add_faces(canvas &target, const diagram &made, const scene &from)
{
    const double rise = .0012;
    vec3 up = made.look.toward * rise;
    for (int look = 0; look < palette::look_count; look++) {
        solids patches;
        for (const diagram_face &face : from.shown.diagram.faces) {
            if (face.look != size_t(look))
                continue;
            const triangle &t = from.mesh.triangles[face.triangle];
            vec3 corner[3];
            for (int i = 0; i < 3; i++)
                corner[i] = (from.mesh.points[t[i]] - made.box.centre) * made.box.scale + up;
            patches.patch(corner[0], corner[1], corner[2]);
        }
        if (!patches.empty())
            target.world()->AddActor(
                patches.actor(look_colour(size_t(look)).with_alpha(.42), finish::lit));
    }
}

void add_arrow(solids &heads, const diagram &made, const diagram_arrow &one, double radius)
{
    const double head = 5.2 * radius, dash = 5 * radius;
    vec3 from = made.place(one.from), to = made.place(one.to);
    vec3 along = normalised(to - from);
    double shaft = std::max(length(to - from) - head, 0.0);
    if (one.dashed)
        for (double at = 0; at < shaft; at += 1.9 * dash)
            heads.tube(from + along * at, from + along * std::min(at + dash, shaft), radius);
    else
        heads.tube(from, from + along * shaft, radius);
    heads.cone(from + along * shaft, to, 2.5 * radius);
}

void add_arrows(canvas &target, const diagram &made, const scene &from, double radius)
{
    for (int look = 0; look < palette::look_count; look++) {
        solids arrows;
        for (const diagram_arrow &one : from.shown.diagram.arrows)
            if (one.look == size_t(look))
                add_arrow(arrows, made, one, radius);
        for (const diagram_label &one : from.shown.diagram.labels)
            if (one.look == size_t(look) && one.text.empty())
                arrows.ball(made.place(one.at), 3 * radius);
        if (!arrows.empty())
            target.world()->AddActor(arrows.actor(look_colour(size_t(look)), finish::lit));
    }
}

/* Words on a white pill with a rim of the look's colour, centred. */
void draw_pill(paper &sheet, point2 at, const std::string &words, size_t look)
{
    const font style = {13, weight::semibold, look_ink(look)};
    const double height = 18;
    std::string shown = sheet.fitting(words, style, sheet.width() * .4);
    double width = std::max(sheet.text_width(shown, style) + 10, height);
    point2 corner = {at.x - width / 2, at.y - height / 2};
    sheet.rounded({corner.x - 1.4, corner.y - 1.4}, width + 2.8, height + 2.8, height / 2 + 1.4,
                  look_colour(look));
    sheet.rounded(corner, width, height, height / 2, palette::paper);
    sheet.text({at.x, at.y + 4.7}, shown, style, align::centre);
}

void draw_words(paper &sheet, const diagram &made, const scene &from, const framing &frame)
{
    for (const diagram_arrow &one : from.shown.diagram.arrows)
        if (!one.label.empty())
            draw_pill(sheet, frame.on_paper(made.place((one.from + one.to) * .5)), one.label,
                      one.look);
    for (const diagram_label &one : from.shown.diagram.labels)
        if (!one.text.empty())
            draw_pill(sheet, frame.on_paper(made.place(one.at)), one.text, one.look);
}
} // namespace

image draw_diagram(const scene &from, picture_size size)
{
    if (from.mesh.points.empty() || unit_box(from.mesh.points).flat_point)
        throw not_showable("There is nothing to draw: the mesh is empty.");
    const diagram_figure &shown = from.shown.diagram;
    unit_box box(from.mesh.points);
    diagram made = {shape(box.apply(from.mesh.points), from.mesh.triangles), box, view(), .004};
    made.look = shown.has_view
                    ? view(shown.azimuth_degrees, shown.elevation_degrees)
                    : best_view(sample_surface(made.mesh.points, made.mesh.triangles), {});
    canvas target(size.width, size.height, backdrop::gradient);
    framing frame(target.world()->GetActiveCamera(), made.mesh.points, made.look,
                  target.paper_width(), {40, 40, 92, from.shown.legend.empty() ? 40.0 : 80.0});
    double units = frame.units_at_middle();
    target.world()->AddActor(shadow_actor(made.mesh.points, made.mesh.triangles));
    target.world()->AddActor(
        surface_actor(made.mesh.points, made.mesh.triangles, palette::surface));
    add_faces(target, made, from);
    target.world()->AddActor(wire_actor(made.mesh.points, made.mesh.edges, 1.3 * target.scale(),
                                        palette::wire.with_alpha(.5)));
    add_arrows(target, made, from, 1.9 / units);
    target.on_paper([&](paper &sheet) {
        draw_title(sheet, from.title, from.subtitle);
        draw_words(sheet, made, from, frame);
        draw_key(sheet, from.shown.legend);
    });
    return target.draw();
}
