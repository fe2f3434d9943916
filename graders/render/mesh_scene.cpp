/* A mesh with its marks; see pictures.hpp. */
#include "graders/render/canvas.hpp"
#include "graders/render/magnifier.hpp"
#include "graders/render/numbers.hpp"
#include "graders/render/pictures.hpp"
#include "graders/render/surfaces.hpp"
#include "graders/render/text.hpp"

#include <algorithm>
#include <optional>
#include <vtkCamera.h>

namespace
{
const size_t isolated_limit = 4000;

void add_wire(canvas &target, const shape &mesh, double units)
{
    double opacity = wire_opacity(mesh.spacing * units);
    target.world()->AddActor(wire_actor(mesh.points, mesh.edges, .9 * target.scale(),
                                        palette::wire.with_alpha(opacity)));
}

void add_isolated(canvas &target, const shape &mesh, double radius)
{
    solids dots;
    for (size_t i = 0; i < mesh.isolated.size() && i < isolated_limit; i++)
        dots.ball(mesh.points[mesh.isolated[i]], 1.3 * radius);
    if (dots.empty())
        return;
    target.world()->AddActor(dots.actor(palette::grey_ink, finish::lit));
    target.front()->AddActor(dots.actor(palette::grey_ink.with_alpha(.22), finish::ghost));
}

std::vector<legend_entry> legend_of(const scene &from, const shape &mesh, const view &look,
                                    const depth_grid &depths)
{
    std::vector<legend_entry> entries = mark_legend(from);
    if (!mesh.isolated.empty())
        entries.push_back(
            disc_entry("isolated", grouped(int64_t(mesh.isolated.size())), palette::grey_ink));
    if (mesh.shows_inside &&
        shows_a_back(mesh.points, without_marked(mesh.triangles, from.marks), look, depths))
        entries.push_back(patch_entry("back of a triangle", palette::back_face));
    if (std::any_of(from.marks.begin(), from.marks.end(),
                    [&](const mark &one) { return depths.hides(mark_middle(mesh.points, one)); }))
        entries.push_back(patch_entry("pale: behind", {236, 216, 222}));
    for (const legend_entry &entry : number_legend(from))
        entries.push_back(entry);
    return entries;
}

/* With that many faults every view shows some, so the default view is used. */
bool most_is_at_fault(const scene &from)
{
    int64_t count = 0;
    for (int kind = 0; kind < mark_kind_count; kind++)
        count += kind == boundary || kind >= right_one ? 0 : from.mark_counts[kind];
    return count > 8 && count > int64_t(from.mesh.triangles.size() / 4);
}

std::string subtitle_of(const scene &from)
{
    const char *note = "only the neighbourhood of the marks is shown";
    if (!from.cut)
        return from.subtitle;
    return from.subtitle.empty() ? note : from.subtitle + "; " + note;
}
} // namespace

image draw_mesh(const scene &from, picture_size size)
{
    if (from.mesh.points.empty())
        throw not_showable("The mesh is empty: it has no vertices and no triangles.");
    if (unit_box(from.mesh.points).flat_point)
        throw not_showable("All vertices of the mesh lie in one place.");
    shape mesh(unit_box(from.mesh.points).apply(from.mesh.points), from.mesh.triangles,
               from.outlines);
    canvas target(size.width, size.height, backdrop::gradient);
    std::vector<place> surface = sample_surface(mesh.points, mesh.triangles);
    view look = best_view(surface, most_is_at_fault(from) ? std::vector<place>()
                                                          : places_of_marks(mesh, from.marks));
    depth_grid depths(surface, look);
    std::vector<legend_entry> legend = legend_of(from, mesh, look, depths);
    std::optional<close_up> inset = choose_close_up(from, mesh, look, depths);
    margins free = {48, inset ? close_up_side + 56.0 : 48, 92, legend.size() > 5 ? 100.0 : 76.0};
    vtkCamera *camera = target.world()->GetActiveCamera();
    framing frame(camera, mesh.points, look, target.paper_width(), free);
    pen how = mark_pen(mesh, frame.units_at_middle());

    if (look.toward.z > 0) /* from below the ground would lie before the mesh */
        target.world()->AddActor(shadow_actor(mesh.points, mesh.triangles));
    target.world()->AddActor(surface_actor(mesh.points, mesh.triangles, palette::surface));
    add_wire(target, mesh, frame.units_at_middle());
    add_isolated(target, mesh, how.radius);
    add_marks(target.world(), mesh.points, from.marks, how, finish::lit);
    add_marks(target.front(), mesh.points, from.marks, how, finish::ghost);
    if (inset)
        add_close_up(target, *inset, from, mesh, frame);
    std::vector<number> numbers;
    if (!inset || numbers_all(mesh) || !from.labels.empty())
        numbers = numbers_of(from, mesh, look, depths);
    target.on_paper([&](paper &sheet) {
        draw_numbers(
            sheet, numbers, [&](vec3 at) { return frame.on_paper(at); }, frame.on_paper({0, 0, 0}));
        draw_title(sheet, from.title, subtitle_of(from));
        draw_legend(sheet, legend);
        draw_axes(sheet, look);
    });
    return target.draw();
}
