/* A mesh with its marks; see pictures.hpp. */
#include "graders/render/canvas.hpp"
#include "graders/render/magnifier.hpp"
#include "graders/render/numbers.hpp"
#include "graders/render/pictures.hpp"
#include "graders/render/surfaces.hpp"
#include "graders/render/text.hpp"
#include "graders/render/values.hpp"

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

/* A mesh of the picture: the only one, or the input's and the answer's. */
struct subject {
    const scene *from;
    shape mesh;                 /* in a unit box around `aside` */
    std::vector<place> surface; /* of the mesh before it was moved there */
    vec3 aside;
    std::optional<depth_grid> depths;
    std::string caption, note;

    bool is_empty() const
    {
        return mesh.points.empty();
    }
};

subject subject_of(const scene &from, const unit_box &box)
{
    subject made;
    made.from = &from;
    made.mesh = shape(box.apply(from.mesh.points), from.mesh.triangles, from.outlines);
    made.surface = sample_surface(made.mesh.points, made.mesh.triangles);
    return made;
}

/* With that many faults every view shows some, so the default view is used. */
bool most_is_at_fault(const scene &from)
{
    int64_t count = 0;
    for (int kind = 0; kind < mark_kind_count; kind++)
        count += kind == boundary || kind >= right_one ? 0 : from.mark_counts[kind];
    return count > 8 && count > int64_t(from.mesh.triangles.size() / 4);
}

bool has_fault(const scene &from)
{
    return !from.marks.empty() && from.marks[0].is_fault();
}

view view_of(const subject &one)
{
    return best_view(one.surface, most_is_at_fault(*one.from)
                                      ? std::vector<place>()
                                      : places_of_marks(one.mesh, one.from->marks));
}

std::string count_of_elements(const scene &from)
{
    return grouped(int64_t(from.mesh.points.size())) + from.say(" vertices, ", " vértices, ") +
           grouped(int64_t(from.mesh.triangles.size())) + from.say(" triangles", " triángulos") +
           (from.cut ? from.say(" shown", " visibles") : "");
}

/* Both meshes in boxes of one scale, unless one is much bigger. */
std::vector<subject> subjects_of(const scene &from)
{
    const double much = 20;
    unit_box box(from.mesh.points);
    if (!from.answer)
        return {subject_of(from, box)};
    unit_box other(from.answer->mesh.points);
    bool both = !from.mesh.points.empty() && !from.answer->mesh.points.empty();
    double least = std::min(box.scale, other.scale);
    if (both && std::max(box.scale, other.scale) < much * least)
        box.scale = other.scale = least;
    std::vector<subject> all = {subject_of(from, box), subject_of(*from.answer, other)};
    all[0].caption = from.say("input", "entrada");
    all[1].caption = from.say("answer", "respuesta");
    for (subject &one : all)
        one.note = count_of_elements(*one.from);
    return all;
}

double half_width(const subject &one, const view &look)
{
    const double least = .2; /* the caption needs room */
    double widest = least;
    for (vec3 p : one.mesh.points)
        widest = std::max(widest, std::fabs(dot(p, look.right)));
    return widest;
}

/* Puts the meshes side by side, as they are seen. */
void arrange(std::vector<subject> &all, const view &look)
{
    const double gap = .14;
    double sum = -gap, at = 0;
    for (const subject &one : all)
        sum += 2 * half_width(one, look) + gap;
    at = -sum / 2;
    for (subject &one : all) {
        double half = half_width(one, look);
        one.aside = all.size() > 1 ? look.right * (at + half) : vec3();
        at += 2 * half + gap;
        for (vec3 &p : one.mesh.points)
            p = p + one.aside;
        one.depths.emplace(one.surface, look, one.aside);
    }
}

/* The marks of all meshes under one legend. */
scene legend_scene(const std::vector<subject> &all)
{
    scene sum;
    sum.language = all[0].from->language;
    for (const subject &one : all) {
        const scene &from = *one.from;
        sum.marks.insert(sum.marks.end(), from.marks.begin(), from.marks.end());
        sum.labels.insert(sum.labels.end(), from.labels.begin(), from.labels.end());
        sum.facts.insert(sum.facts.end(), from.facts.begin(), from.facts.end());
        sum.ok_count = std::max(sum.ok_count, from.ok_count);
        sum.turn_count = std::max(sum.turn_count, from.turn_count);
        if (sum.turns_word.empty())
            sum.turns_word = from.turns_word;
        sum.has_groups = sum.has_groups || !from.groups.empty();
        for (int k = 0; k < mark_kind_count; k++) {
            sum.mark_counts[k] += from.mark_counts[k];
            if (sum.mark_words[k].empty())
                sum.mark_words[k] = from.mark_words[k];
        }
    }
    return sum;
}

std::vector<legend_entry> legend_of(const std::vector<subject> &all, const view &look)
{
    scene sum = legend_scene(all);
    std::vector<legend_entry> entries = mark_legend(sum);
    size_t isolated = 0;
    bool back = false, behind = false;
    for (const subject &one : all) {
        const shape &mesh = one.mesh;
        for (const legend_entry &entry : vector_legend(*one.from))
            entries.push_back(entry);
        isolated += mesh.isolated.size();
        back = back || (mesh.shows_inside && !has_coloured_faces(*one.from) &&
                        shows_a_back(mesh.points, without_marked(mesh.triangles, one.from->marks),
                                     look, *one.depths));
        for (const mark &by : one.from->marks)
            behind = behind || one.depths->hides(mark_middle(mesh.points, by));
    }
    if (isolated > 0)
        entries.push_back(disc_entry(sum.say("isolated", "aislados"), grouped(int64_t(isolated)),
                                     palette::grey_ink));
    if (back)
        entries.push_back(patch_entry(sum.say("back of a triangle", "reverso de un triángulo"),
                                      palette::back_face));
    if (behind)
        entries.push_back(patch_entry(sum.say("pale: behind", "pálido: detrás"), {236, 216, 222}));
    for (const legend_entry &entry : number_legend(sum))
        entries.push_back(entry);
    return entries;
}

std::string subtitle_of(const scene &from)
{
    const char *note = from.say("only the neighbourhood of the marks is shown",
                                "solo se muestra el entorno de las marcas");
    if (!from.cut && !(from.answer && from.answer->cut))
        return from.subtitle;
    return from.subtitle.empty() ? note : from.subtitle + "; " + note;
}

/* The shadow of all on one floor. */
void add_shadow(canvas &target, const std::vector<subject> &all)
{
    std::vector<vec3> points;
    std::vector<triangle> triangles;
    for (const subject &one : all) {
        for (triangle t : one.mesh.triangles) {
            for (int32_t &v : t)
                v += int32_t(points.size());
            triangles.push_back(t);
        }
        points.insert(points.end(), one.mesh.points.begin(), one.mesh.points.end());
    }
    target.world()->AddActor(shadow_actor(points, triangles));
}

void add_subject(canvas &target, const subject &one, double units)
{
    const shape &mesh = one.mesh;
    pen how = mark_pen(mesh, units);
    target.world()->AddActor(scene_surface(*one.from, mesh));
    add_wire(target, mesh, units);
    add_isolated(target, mesh, how.radius);
    std::vector<mark> marks = drawn_marks(*one.from);
    add_marks(target.world(), mesh.points, marks, how, finish::lit);
    add_marks(target.front(), mesh.points, marks, how, finish::ghost);
    add_vectors(target.world(), *one.from, mesh, how, finish::lit);
    add_vectors(target.front(), *one.from, mesh, how, finish::ghost);
}

/* The bars of the scales, from the left; one when both meshes have the same. */
void draw_scales(paper &sheet, const std::vector<subject> &all)
{
    const double top = 100, left = 24, right = sheet.width() / 2 + 24;
    const value_scale *shown = nullptr;
    for (const subject &one : all) {
        const value_scale &values = one.from->values;
        bool same = shown && shown->low == values.low && shown->high == values.high &&
                    std::isnan(values.worst);
        if (values.numbers.empty() || same)
            continue;
        draw_scale(sheet, {&one == &all[0] ? left : right, top}, values);
        shown = &values;
    }
}

void draw_over(paper &sheet, const std::vector<subject> &all, const framing &frame,
               const view &look, bool has_inset)
{
    double below = 26, lowest = 0;
    for (const subject &one : all) {
        below = numbers_all(one.mesh) ? 36 : below;
        for (vec3 p : one.mesh.points)
            lowest = std::max(lowest, frame.on_paper(p).y);
    }
    for (const subject &one : all) {
        auto on_paper = [&](vec3 at) { return frame.on_paper(at); };
        point2 middle = frame.on_paper(one.aside);
        bool numbered = !has_inset || numbers_all(one.mesh) || !one.from->labels.empty();
        if (numbered && !one.is_empty())
            draw_numbers(sheet, numbers_of(*one.from, one.mesh, look, *one.depths), on_paper,
                         middle);
        sheet.text({middle.x, lowest + below}, one.caption, {14, weight::semibold, palette::ink},
                   align::centre);
        sheet.text({middle.x, lowest + below + 20}, one.note,
                   {13, weight::regular, palette::grey_ink}, align::centre);
    }
    draw_scales(sheet, all);
}

/* The mesh whose fault the verdict names: the answer's first, then the input's. */
const subject &named_subject(const std::vector<subject> &all)
{
    const subject &answer = all.back();
    return has_fault(*answer.from) || all.front().is_empty() ? answer : all.front();
}

void check_showable(const std::vector<subject> &all)
{
    const scene &words = *all[0].from;
    bool empty = true, flat = true;
    for (const subject &one : all) {
        empty = empty && one.is_empty();
        flat = flat && unit_box(one.from->mesh.points).flat_point;
    }
    if (empty)
        throw not_showable(words.say("The mesh is empty: it has no vertices and no triangles.",
                                     "La malla está vacía: no tiene vértices ni triángulos."));
    if (flat)
        throw not_showable(words.say("All vertices of the mesh lie in one place.",
                                     "Todos los vértices de la malla están en un mismo punto."));
}
} // namespace

image draw_mesh(const scene &from, picture_size size)
{
    std::vector<subject> all = subjects_of(from);
    check_showable(all);
    canvas target(size.width, size.height, backdrop::gradient);
    view look = view_of(named_subject(all));
    arrange(all, look);
    std::vector<legend_entry> legend = legend_of(all, look);
    const subject &named = named_subject(all);
    std::optional<close_up> inset;
    if (!named.is_empty())
        inset = choose_close_up(*named.from, named.mesh, look, *named.depths);
    bool pair = all.size() > 1, scaled = false;
    std::vector<vec3> points;
    for (const subject &one : all) {
        points.insert(points.end(), one.mesh.points.begin(), one.mesh.points.end());
        if (one.is_empty())
            points.push_back(one.aside);
        for (const vec3 &p : one.mesh.points)
            if (!one.from->vectors.empty()) /* they may point anywhere */
                points.push_back(one.aside + (p - one.aside) * (1 + 1.5 * vectors_reach));
        scaled = scaled || !one.from->values.numbers.empty();
    }
    double bottom = (legend.size() > 5 ? 100.0 : 76.0) + (pair ? 56 : 0);
    margins free = {48, inset ? close_up_side + 56.0 : 48, 92 + (scaled ? scale_room : 0), bottom};
    framing frame(target.world()->GetActiveCamera(), points, look, target.paper_width(), free);
    if (look.toward.z > 0) /* from below the ground would lie before the mesh */
        add_shadow(target, all);
    for (const subject &one : all)
        if (!one.is_empty())
            add_subject(target, one, frame.units_at_middle());
    if (inset)
        add_close_up(target, *inset, *named.from, named.mesh, frame);
    target.on_paper([&](paper &sheet) {
        draw_over(sheet, all, frame, look, inset.has_value());
        draw_title(sheet, from.title, subtitle_of(from));
        draw_legend(sheet, legend);
        draw_axes(sheet, look);
    });
    return target.draw(from.world.get());
}
