/* A mesh with its marks; see pictures.hpp. */
#include "graders/render/canvas.hpp"
#include "graders/render/magnifier.hpp"
#include "graders/render/marks.hpp"
#include "graders/render/pictures.hpp"
#include "graders/render/surfaces.hpp"
#include "graders/render/text.hpp"

#include <algorithm>
#include <optional>
#include <vtkCamera.h>

namespace
{
const size_t labelled_vertices_limit = 36, isolated_limit = 4000;

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
    return entries;
}

/* With that many faults every view shows some, so the default view is used. */
bool most_is_at_fault(const scene &from)
{
    int64_t count = 0;
    for (int kind = 0; kind < mark_kind_count; kind++)
        count += kind == boundary ? 0 : from.mark_counts[kind];
    return count > 8 && count > int64_t(from.mesh.triangles.size() / 4);
}

/* Which vertices have their numbers beside them: all of few, else those of the first mark. */
std::vector<size_t> labelled_vertices(const scene &from, const shape &mesh)
{
    std::vector<size_t> numbers;
    if (mesh.points.size() <= labelled_vertices_limit)
        for (size_t v = 0; v < mesh.points.size(); v++)
            numbers.push_back(v);
    else if (!from.marks.empty() && from.marks[0].kind != boundary)
        for (int i = 0; i < from.marks[0].vertex_count(); i++)
            numbers.push_back(size_t(from.marks[0].vertex[i]));
    return numbers;
}

void label_vertices(canvas &target, const shape &mesh, const std::vector<size_t> &numbers,
                    const depth_grid &depths, const framing &frame)
{
    point2 middle = frame.on_paper({0, 0, 0});
    for (size_t v : numbers) {
        point2 at = frame.on_paper(mesh.points[v]);
        bool hidden = depths.hides(mesh.points[v]);
        target.on_paper([=](paper &sheet) {
            draw_label(sheet, at, {at.x - middle.x, at.y - middle.y}, std::to_string(v), hidden);
        });
    }
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
    shape mesh(unit_box(from.mesh.points).apply(from.mesh.points), from.mesh.triangles);
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
    double radius = mark_radius(mesh, frame.units_at_middle());

    if (look.toward.z > 0) /* from below the ground would lie before the mesh */
        target.world()->AddActor(shadow_actor(mesh.points, mesh.triangles));
    target.world()->AddActor(surface_actor(mesh.points, mesh.triangles, palette::surface));
    add_wire(target, mesh, frame.units_at_middle());
    add_isolated(target, mesh, radius);
    add_marks(target.world(), mesh.points, from.marks, radius, finish::lit);
    add_marks(target.front(), mesh.points, from.marks, radius, finish::ghost);
    if (inset)
        add_close_up(target, *inset, from, mesh, frame);
    if (!from.cut && (!inset || mesh.points.size() <= labelled_vertices_limit))
        label_vertices(target, mesh, labelled_vertices(from, mesh), depths, frame);
    target.on_paper([&](paper &sheet) {
        draw_title(sheet, from.title, subtitle_of(from));
        draw_legend(sheet, legend);
        draw_axes(sheet, look);
    });
    return target.draw();
}
