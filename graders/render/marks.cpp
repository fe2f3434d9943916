/* See marks.hpp. */
#include "graders/render/marks.hpp"
#include "graders/render/text.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace
{
/* Of the edges of a kind, in tube radii. */
struct style {
    double tube;
    bool dashed;
    int beads; /* evenly along the edge */
    double bead;
    double end; /* balls at the two ends, 0: none */
};

const style styles[mark_kind_count] = {
    {1.0, true, 0, 0, 0},    /* missing: dashed, as it is not there */
    {.75, false, 2, 1.8, 0}, /* duplicate: two beads */
    {1.1, false, 0, 0, 0},   /* extra: solid and thick */
    {.6, false, 0, 0, 2.0},  /* degenerate: thin between two balls */
    {.7, false, 0, 0, 0},    /* boundary: solid and thin */
    {.8, false, 0, 0, 0},    /* flipped */
    {.9, false, 1, 2.1, 0},  /* wrong: one bead */
    {.9, false, 0, 0, 0},    /* right */
    {.9, false, 0, 0, 0},    /* the six turn colours */
    {.9, false, 0, 0, 0},    {.9, false, 0, 0, 0}, {.9, false, 0, 0, 0},
    {.9, false, 0, 0, 0},    {.9, false, 0, 0, 0},
};
const double vertex_ball = 2.4, outline_tube = .6;

void add_edge(solids &out, vec3 a, vec3 b, const style &how, double radius)
{
    if (length(b - a) == 0)
        return out.ball(a, vertex_ball * radius);
    if (how.dashed)
        add_dashes(out, a, b, how.tube * radius);
    else
        out.tube(a, b, how.tube * radius);
    for (int i = 1; i <= how.beads; i++)
        out.ball(a + (b - a) * (double(i) / (how.beads + 1)), how.bead * radius);
    if (how.end > 0) {
        out.ball(a, how.end * radius);
        out.ball(b, how.end * radius);
    }
}

void set_over_surface(vtkActor *actor)
{
    actor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, -1);
}

void add_mark(solids &lines, solids &patches, const std::vector<vec3> &points, const mark &one,
              const pen &how)
{
    const style &by_kind = styles[one.kind];
    std::vector<vec3> p;
    for (int32_t v : one.vertex)
        p.push_back(points[v]);
    pen tube = {by_kind.tube * how.radius, how.unit};
    switch (one.what) {
    case element::at_vertex:
        return lines.ball(p[0], vertex_ball * how.radius);
    case element::at_edge:
        return add_edge(lines, p[0], p[1], by_kind, how.radius);
    case element::arrow:
        return add_arrow(lines, p[0], p[1], tube, by_kind.dashed);
    case element::half_edge:
        return add_half_edge(lines, p, tube, by_kind.dashed);
    case element::path:
    case element::loop:
        return add_path(lines, p, one.what == element::loop, tube, by_kind.dashed);
    case element::at_triangle:
    case element::face:
        break;
    }
    for (const triangle &t : one.fill)
        patches.patch(points[t[0]], points[t[1]], points[t[2]]);
    for (size_t i = 0; i < p.size() && one.is_fault(); i++)
        lines.tube(p[i], p[(i + 1) % p.size()], outline_tube * how.radius);
}

/* The outline of what the faces of a kind without fault cover together. */
void add_outline(solids &lines, const std::vector<vec3> &points, const std::vector<mark> &marks,
                 mark_kind kind, double radius)
{
    std::map<edge, int> sides;
    for (const mark &one : marks)
        for (size_t i = 0; one.is_face() && one.kind == kind && i < one.vertex.size(); i++) {
            int32_t a = one.vertex[i], b = one.vertex[(i + 1) % one.vertex.size()];
            sides[{std::min(a, b), std::max(a, b)}]++;
        }
    for (const auto &[side, count] : sides)
        if (count == 1)
            lines.tube(points[side[0]], points[side[1]], outline_tube * radius);
}

/* Whether it is shown through what lies before it: faults, and what leads there. */
bool has_ghost(const mark &one)
{
    return one.is_fault() || one.kind == boundary || one.kind == right_one ||
           (!one.is_face() && one.what != element::half_edge);
}

/* All marks of one kind. */
void add_kind(vtkRenderer *renderer, const std::vector<vec3> &points,
              const std::vector<mark> &marks, mark_kind kind, const pen &how, finish look)
{
    solids lines, patches;
    bool pale = look == finish::ghost;
    for (const mark &one : marks)
        if (one.kind == kind && (!pale || has_ghost(one)))
            add_mark(lines, patches, points, one, how);
    if (kind >= right_one && !pale)
        add_outline(lines, points, marks, kind, how.radius);
    if (!lines.empty())
        renderer->AddActor(lines.actor(palette::marks[kind].with_alpha(pale ? .22 : 1), look));
    if (!patches.empty()) {
        auto actor = patches.actor(palette::marks[kind].with_alpha(pale ? .10 : .62),
                                   pale ? finish::ghost : finish::flat);
        set_over_surface(actor);
        renderer->AddActor(actor);
    }
}
} // namespace

/* What the verdict names stands out among its like: a white rim, and a dark one around it. Of a
 * flipped face arrows show which way it runs. */
static void add_rim(vtkRenderer *renderer, const std::vector<vec3> &points, const mark &one,
                    const pen &how)
{
    const double white_units = 1.1, dark_units = 1.9;
    solids lines, patches, winding;
    add_mark(lines, patches, points, one, how);
    std::vector<vec3> corners;
    for (int32_t v : one.vertex)
        corners.push_back(points[v]);
    for (size_t i = 0; one.kind == flipped && i < corners.size(); i++) {
        add_half_edge(winding, corners, {.5 * how.radius, .7 * how.unit}, false);
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    }
    if (!winding.empty())
        renderer->AddActor(winding.actor(palette::ink, finish::lit));
    renderer->AddActor(lines.rim(palette::paper, white_units * how.unit));
    renderer->AddActor(lines.rim(palette::ink, dark_units * how.unit));
}

static edge edge_of(const mark &one)
{
    return {std::min(one.vertex[0], one.vertex[1]), std::max(one.vertex[0], one.vertex[1])};
}

/* Without the boundary edges that are marked as something worse too. */
static std::vector<mark> without_covered(const std::vector<mark> &marks)
{
    std::set<edge> at_fault;
    for (const mark &one : marks)
        if (one.what == element::at_edge && one.kind != boundary)
            at_fault.insert(edge_of(one));
    std::vector<mark> kept;
    for (const mark &one : marks)
        if (one.what != element::at_edge || one.kind != boundary || !at_fault.count(edge_of(one)))
            kept.push_back(one);
    return kept;
}

void add_marks(vtkRenderer *renderer, const std::vector<vec3> &points,
               const std::vector<mark> &marks, const pen &how, finish look)
{
    std::vector<mark> shown = without_covered(marks);
    for (int kind = 0; kind < mark_kind_count; kind++)
        add_kind(renderer, points, shown, mark_kind(kind), how, look);
    if (look == finish::lit && !marks.empty() && marks[0].is_fault())
        add_rim(renderer, points, marks[0], how);
}

pen mark_pen(const shape &mesh, double paper_units_per_world_unit)
{
    const double thinnest_units = 1.25, thickest_units = 2.7;
    double unit = 1 / paper_units_per_world_unit;
    return {std::clamp(.09 * mesh.spacing, thinnest_units * unit, thickest_units * unit), unit};
}

vec3 mark_normal(const shape &mesh, const mark &one)
{
    vec3 sum;
    for (int i = 0; i < one.vertex_count(); i++)
        sum = sum + mesh.normals[one.vertex[i]];
    return normalised(sum);
}

static vec3 middle_of(const std::vector<vec3> &points, const triangle &t)
{
    return (points[t[0]] + points[t[1]] + points[t[2]]) * (1.0 / 3);
}

/* Whether a place of the face's plane lies in the triangle. */
static bool covers(const std::vector<vec3> &points, const triangle &t, vec3 place)
{
    vec3 a = points[t[0]], b = points[t[1]], c = points[t[2]], normal = cross(b - a, c - a);
    return dot(cross(b - a, place - a), normal) >= 0 && dot(cross(c - b, place - b), normal) >= 0 &&
           dot(cross(a - c, place - c), normal) >= 0;
}

static double distance_to(vec3 place, vec3 a, vec3 b)
{
    double along = dot(b - a, b - a);
    double share = along > 0 ? std::clamp(dot(place - a, b - a) / along, 0.0, 1.0) : 0;
    return length(place - (a + (b - a) * share));
}

/* How far a place of a face is from its outline; nothing outside of it. */
static double depth_in_face(const std::vector<vec3> &points, const mark &face, vec3 place)
{
    bool inside = std::any_of(face.fill.begin(), face.fill.end(),
                              [&](const triangle &t) { return covers(points, t, place); });
    double depth = inside ? 1e9 : 0;
    for (size_t i = 0; i < face.vertex.size(); i++)
        depth = std::min(depth, distance_to(place, points[face.vertex[i]],
                                            points[face.vertex[(i + 1) % face.vertex.size()]]));
    return depth;
}

/* The middle of a face's area, or that of one of its triangles, which lies deepest in the face. */
static vec3 face_middle(const std::vector<vec3> &points, const mark &face)
{
    const size_t many = 64;
    vec3 sum;
    double total = 0;
    for (const triangle &t : face.fill) {
        double area = length(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
        sum = sum + middle_of(points, t) * area;
        total += area;
    }
    vec3 best = total > 0 ? sum * (1 / total) : middle_of(points, face.fill[0]);
    double deepest = depth_in_face(points, face, best);
    for (size_t i = 0; face.fill.size() > 2 && i < std::min(face.fill.size(), many); i++) {
        vec3 middle = middle_of(points, face.fill[i]);
        double depth = depth_in_face(points, face, middle);
        if (depth > 1.2 * deepest) {
            deepest = depth;
            best = middle;
        }
    }
    return best;
}

vec3 mark_middle(const std::vector<vec3> &points, const mark &one)
{
    bool on_edge = one.what == element::half_edge || one.what == element::arrow;
    bool is_path = one.what == element::path || one.what == element::loop;
    if (!one.fill.empty())
        return face_middle(points, one);
    if (is_path)
        return points[one.vertex[one.vertex.size() / 2]];
    size_t count = on_edge ? 2 : one.vertex.size();
    vec3 sum;
    for (size_t i = 0; i < count; i++)
        sum = sum + points[one.vertex[i]];
    return sum * (1.0 / double(count));
}

static triangle in_order(triangle corners)
{
    std::sort(corners.begin(), corners.end());
    return corners;
}

std::vector<triangle> without_marked(const std::vector<triangle> &triangles,
                                     const std::vector<mark> &marks)
{
    std::set<triangle> marked;
    for (const mark &one : marks)
        for (const triangle &t : one.fill)
            marked.insert(in_order(t));
    std::vector<triangle> left;
    std::copy_if(triangles.begin(), triangles.end(), std::back_inserter(left),
                 [&](const triangle &t) { return !marked.count(in_order(t)); });
    return left;
}

/* One place, or of a path some along it. */
static void add_places(const shape &mesh, const mark &one, std::vector<place> &places)
{
    const size_t most = 12;
    double weight = one.is_fault() ? 1 : .1;
    if (one.what != element::path && one.what != element::loop) {
        places.push_back({mark_middle(mesh.points, one), mark_normal(mesh, one), weight});
        return;
    }
    size_t count = std::min(one.vertex.size(), most);
    for (size_t i = 0; i < count; i++) {
        int32_t v = one.vertex[i * one.vertex.size() / count];
        places.push_back({mesh.points[v], mesh.normals[v], weight / double(count)});
    }
}

std::vector<place> places_of_marks(const shape &mesh, const std::vector<mark> &marks)
{
    std::vector<place> places;
    double sum = 0;
    size_t of_first = 0;
    for (const mark &one : marks) {
        add_places(mesh, one, places);
        of_first = of_first ? of_first : places.size();
    }
    for (const place &one : places)
        sum += one.weight;
    for (size_t i = 0; i < of_first && marks[0].is_fault(); i++)
        places[i].weight += sum / 3 / double(of_first);
    return places;
}

static void draw_edge_swatch(paper &sheet, point2 at, double width, mark_kind kind)
{
    const double unit = 2.3;
    const style &how = styles[kind];
    colour paint = palette::marks[kind];
    point2 left = {at.x - width / 2, at.y}, right = {at.x + width / 2, at.y};
    if (how.dashed)
        sheet.dashed(left, right, 2 * how.tube * unit, 5.5, 4.5 * how.tube + 0.3, paint);
    else
        sheet.line(left, right, 2 * how.tube * unit, paint);
    for (int i = 1; i <= how.beads; i++)
        sheet.disc({left.x + width * i / (how.beads + 1), at.y}, how.bead * unit, paint);
    if (how.end > 0) {
        sheet.disc(left, how.end * unit, paint);
        sheet.disc(right, how.end * unit, paint);
    }
}

static void draw_arrow_swatch(paper &sheet, point2 at, double width, mark_kind kind)
{
    const double unit = 2.3;
    colour paint = palette::marks[kind];
    point2 left = {at.x - width / 2, at.y}, right = {at.x + width / 2, at.y};
    if (styles[kind].dashed)
        sheet.dashed(left, right, 2 * unit, 5.5, 4.5, paint);
    else
        sheet.line(left, right, 2 * styles[kind].tube * unit, paint);
    sheet.polygon({{at.x - 5, at.y - 6}, {at.x + 8, at.y}, {at.x - 5, at.y + 6}}, paint);
}

static void draw_triangle_swatch(paper &sheet, point2 at, mark_kind kind)
{
    const point2 corners[] = {{at.x - 9, at.y + 6}, {at.x + 9, at.y + 6}, {at.x, at.y - 8}};
    colour paint = palette::marks[kind];
    sheet.polygon({corners[0], corners[1], corners[2]}, paint.with_alpha(.62));
    for (int i = 0; i < 3; i++)
        sheet.line(corners[i], corners[(i + 1) % 3], 2.4, paint);
}

/* What most of the marks of a kind are: a vertex, an edge, an arrow (or a path) or a triangle (any
 * face). */
static element usual_element(const scene &from, mark_kind kind)
{
    int vertices = 0, edges = 0, arrows = 0, faces = 0;
    for (const mark &one : from.marks)
        if (one.kind == kind) {
            bool is_vertex = one.what == element::at_vertex, is_edge = one.what == element::at_edge;
            (one.is_face() ? faces : is_vertex ? vertices : is_edge ? edges : arrows)++;
        }
    if (faces > std::max(edges, arrows) && faces >= vertices)
        return element::at_triangle;
    if (vertices > std::max(edges, arrows))
        return element::at_vertex;
    return arrows > edges ? element::arrow : element::at_edge;
}

static void draw_swatch(paper &sheet, point2 at, double width, mark_kind kind, element what)
{
    if (what == element::at_triangle)
        draw_triangle_swatch(sheet, at, kind);
    else if (what == element::at_vertex)
        sheet.disc(at, 5.8, palette::marks[kind]);
    else if (what == element::arrow)
        draw_arrow_swatch(sheet, at, width, kind);
    else
        draw_edge_swatch(sheet, at, width, kind);
}

/* How many of a kind there are, and how many of them are drawn when not all. */
static std::string mark_count(const scene &from, mark_kind kind)
{
    auto drawn = std::count_if(from.marks.begin(), from.marks.end(),
                               [kind](const mark &one) { return one.kind == kind; });
    int64_t all = from.mark_counts[kind];
    if (drawn >= all)
        return grouped(all);
    return (drawn == 0 ? "none" : grouped(drawn)) + " of " + grouped(all) + " drawn";
}

legend_entry patch_entry(const std::string &name, colour paint)
{
    return {name, "",
            [paint](paper &sheet, point2 at, double) {
                sheet.rounded({at.x - 8, at.y - 6}, 16, 12, 2.5, paint.darker(.86));
                sheet.rounded({at.x - 7, at.y - 5}, 14, 10, 2, paint);
            },
            true};
}

legend_entry disc_entry(const std::string &name, const std::string &count, colour paint)
{
    return {name, count, [paint](paper &sheet, point2 at, double) { sheet.disc(at, 5.2, paint); }};
}

/* One entry for all turn colours that have no name of their own, with a disc of each. */
static void add_turn_entry(const scene &from, std::vector<legend_entry> &entries)
{
    std::vector<colour> paints;
    int64_t count = 0;
    for (int k = turn_0; k <= turn_last; k++)
        if (from.mark_counts[k] > 0 && from.mark_words[k].empty()) {
            count += from.mark_counts[k];
            paints.push_back(palette::marks[k]);
        }
    if (paints.empty())
        return;
    std::string name = from.turns_word.empty() ? "parts" : from.turns_word;
    entries.push_back(
        {name, grouped(from.turn_count > 0 ? from.turn_count : count),
         [paints](paper &sheet, point2 at, double width) {
             size_t shown = std::min<size_t>(paints.size(), 3);
             for (size_t i = 0; i < shown; i++)
                 sheet.disc({at.x + width * ((i + .5) / double(shown) - .5), at.y}, 4, paints[i]);
         }});
}

std::vector<legend_entry> mark_legend(const scene &from)
{
    std::vector<legend_entry> entries;
    if (from.ok_count > 0)
        entries.push_back({"ok", grouped(from.ok_count),
                           [](paper &sheet, point2 at, double width) {
                               sheet.line({at.x - width / 2, at.y}, {at.x + width / 2, at.y}, 1.6,
                                          palette::grey_ink);
                           },
                           true});
    for (int k = 0; k < mark_kind_count; k++) {
        mark_kind kind = mark_kind(k);
        element what = usual_element(from, kind);
        bool has_word = !from.mark_words[k].empty();
        if (from.mark_counts[k] > 0 && (has_word || kind < turn_0))
            entries.push_back({has_word            ? from.mark_words[k]
                               : kind == right_one ? "should be"
                                                   : mark_names[k],
                               mark_count(from, kind),
                               [kind, what](paper &sheet, point2 at, double width) {
                                   draw_swatch(sheet, at, width, kind, what);
                               }});
    }
    add_turn_entry(from, entries);
    for (const fact &one : from.facts)
        entries.push_back({one.name, one.value, [](paper &sheet, point2 at, double) {
                               sheet.disc(at, 2.5, palette::grey_ink);
                           }});
    return entries;
}
