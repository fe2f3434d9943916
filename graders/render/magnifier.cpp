/* See magnifier.hpp. */
#include "graders/render/magnifier.hpp"
#include "graders/render/marks.hpp"
#include "graders/render/surfaces.hpp"

#include <vtkCamera.h>

static const double corner_top = 92, corner_right = 26;

static double mark_reach(const shape &mesh, const mark &one)
{
    vec3 middle = mark_middle(mesh.points, one);
    double reach = 0;
    for (int32_t v : one.vertex)
        reach = std::max(reach, length(mesh.points[v] - middle));
    return reach;
}

/* The usual look, or when the mark lies aslant or behind, that from its own outer side. */
static view look_at_mark(const view &look, vec3 normal, bool hidden)
{
    const double aslant = .45;
    double facing = dot(normal, look.toward);
    if ((std::fabs(facing) > aslant && !hidden) || length(normal) == 0)
        return look;
    if (!hidden && facing < 0) /* wound inside out */
        normal = normal * -1;
    double azimuth = std::atan2(normal.y, normal.x) * 180 / M_PI;
    double elevation = std::asin(std::clamp(normal.z, -1.0, 1.0)) * 180 / M_PI;
    return view(azimuth + 12, std::clamp(elevation + 12, -70.0, 75.0));
}

std::optional<close_up> choose_close_up(const scene &from, const shape &mesh, const view &look,
                                        const depth_grid &depths)
{
    const double small = .05; /* of the mesh's diagonal */
    for (const mark &one : from.marks) {
        if (!one.is_fault())
            continue;
        double reach = std::max(mark_reach(mesh, one), 1.2 * mesh.spacing);
        vec3 middle = mark_middle(mesh.points, one), normal = mark_normal(mesh, one);
        bool hidden = depths.hides(middle);
        if ((reach > small && !hidden) || mesh.triangles.empty())
            return std::nullopt;
        if (hidden && one.kind == flipped) /* its normal points inwards */
            normal = normal * -1;
        return close_up{one, middle, look_at_mark(look, normal, hidden), 2.4 * reach};
    }
    return std::nullopt;
}

static void set_camera(vtkCamera *camera, const close_up &inset)
{
    vec3 eye = inset.middle + inset.look.toward;
    camera->ParallelProjectionOn();
    camera->SetParallelScale(inset.half_width);
    camera->SetFocalPoint(inset.middle.x, inset.middle.y, inset.middle.z);
    camera->SetPosition(eye.x, eye.y, eye.z);
    camera->SetViewUp(inset.look.up.x, inset.look.up.y, inset.look.up.z);
    /* Near enough that other parts of the mesh do not hide the place. */
    camera->SetClippingRange(1 - 2.5 * inset.half_width, 1 + 12 * inset.half_width);
}

static void add_things(vtkRenderer *renderer, const close_up &inset, const scene &from,
                       const shape &mesh, double scale)
{
    pen how = {.022 * inset.half_width, 2 * inset.half_width / close_up_side};
    renderer->AddActor(surface_actor(mesh.points, mesh.triangles, palette::surface));
    renderer->AddActor(
        wire_actor(mesh.points, mesh.edges, .9 * scale, palette::wire.with_alpha(.42)));
    add_marks(renderer, mesh.points, from.marks, how, finish::lit);
}

/* The numbers of the shown element's vertices, and the scene's labels that fall into the frame. */
static void draw_frame_numbers(paper &sheet, const close_up &inset, const scene &from,
                               const shape &mesh, point2 centre)
{
    const size_t most_vertices = 12;
    const double units = close_up_side / 2 / inset.half_width, inside = close_up_side / 2 - 10;
    auto away = [&](vec3 place) {
        vec3 offset = place - inset.middle;
        return point2{dot(offset, inset.look.right) * units, -dot(offset, inset.look.up) * units};
    };
    for (int32_t v : inset.shown.vertex) {
        point2 at = away(mesh.points[v]);
        if (!from.cut && inset.shown.vertex.size() <= most_vertices)
            draw_label(sheet, {centre.x + at.x, centre.y + at.y}, at, std::to_string(v), false);
    }
    for (const label &one : from.labels) {
        vec3 place = mark_middle(mesh.points, one.at);
        point2 at = away(place);
        bool near = std::fabs(dot(place - inset.middle, inset.look.toward)) < inset.half_width;
        if (one.at.what != element::at_vertex && near && std::fabs(at.x) < inside &&
            std::fabs(at.y) < inside)
            draw_sign(sheet, {centre.x + at.x, centre.y + at.y}, std::to_string(one.number),
                      one.at.is_face() ? sign::circle : sign::box, false);
    }
}

/* The frame, the vertices' numbers in it, and a line to the place in the big picture. */
static void draw_frame(paper &sheet, const close_up &inset, const scene &from, const shape &mesh,
                       point2 place)
{
    point2 corner = {sheet.width() - corner_right - close_up_side, corner_top};
    point2 centre = {corner.x + close_up_side / 2, corner.y + close_up_side / 2};
    const double ring = 9;
    colour ink = palette::grey_ink;
    sheet.circle(place, ring, 3.8, palette::paper);
    sheet.circle(place, ring, 1.6, ink);
    point2 end = {corner.x, std::clamp(place.y, corner.y + 12, corner.y + close_up_side - 12)};
    double reach = std::hypot(end.x - place.x, end.y - place.y);
    if (end.x > place.x + ring && reach > 0)
        sheet.line({place.x + (end.x - place.x) * ring / reach,
                    place.y + (end.y - place.y) * ring / reach},
                   end, 1.2, ink);
    const point2 corners[] = {corner,
                              {corner.x + close_up_side, corner.y},
                              {corner.x + close_up_side, corner.y + close_up_side},
                              {corner.x, corner.y + close_up_side}};
    for (int i = 0; i < 4; i++)
        sheet.line(corners[i], corners[(i + 1) % 4], 1.6, ink);
    draw_frame_numbers(sheet, inset, from, mesh, centre);
}

void add_close_up(canvas &target, const close_up &inset, const scene &from, const shape &mesh,
                  const framing &frame)
{
    vtkRenderer *renderer =
        target.add_inset({target.paper_width() - corner_right - close_up_side, corner_top},
                         close_up_side, close_up_side);
    set_camera(renderer->GetActiveCamera(), inset);
    add_things(renderer, inset, from, mesh, target.scale());
    point2 place = frame.on_paper(inset.middle);
    target.on_paper([&inset, &from, &mesh, place](paper &sheet) {
        draw_frame(sheet, inset, from, mesh, place);
    });
}
