/* See marks.hpp. */
#include "graders/render/marks.hpp"
#include "graders/render/text.hpp"

#include <algorithm>
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
};
const double vertex_ball = 2.4, outline_tube = .6;

void add_dashes(solids &out, vec3 a, vec3 b, double radius)
{
    const double period = 7;     /* radii: a dash and the gap after it, round ends included */
    const double half_dash = .2; /* periods */
    int dashes = std::clamp(int(length(b - a) / (period * radius) + .5), 1, 40);
    for (int i = 0; i < dashes; i++)
        out.tube(a + (b - a) * ((i + .5 - half_dash) / dashes),
                 a + (b - a) * ((i + .5 + half_dash) / dashes), radius);
}

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
    actor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(-1, -2);
}

/* All marks of one kind. */
void add_kind(vtkRenderer *renderer, const std::vector<vec3> &points,
              const std::vector<mark> &marks, mark_kind kind, double radius, finish look)
{
    solids lines, patches;
    for (const mark &one : marks) {
        if (one.kind != kind)
            continue;
        vec3 p[3];
        for (int i = 0; i < one.vertex_count(); i++)
            p[i] = points[one.vertex[i]];
        if (one.what == element::at_vertex)
            lines.ball(p[0], vertex_ball * radius);
        if (one.what == element::at_edge)
            add_edge(lines, p[0], p[1], styles[kind], radius);
        if (one.what == element::at_triangle) {
            patches.patch(p[0], p[1], p[2]);
            for (int i = 0; i < 3; i++)
                lines.tube(p[i], p[(i + 1) % 3], outline_tube * radius);
        }
    }
    bool pale = look == finish::ghost;
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
               const std::vector<mark> &marks, double radius, finish look)
{
    std::vector<mark> shown = without_covered(marks);
    for (int kind = 0; kind < mark_kind_count; kind++)
        add_kind(renderer, points, shown, mark_kind(kind), radius, look);
}

double mark_radius(const shape &mesh, double paper_units_per_world_unit)
{
    const double thinnest_units = 1.25, thickest_units = 2.7;
    return std::clamp(.09 * mesh.spacing, thinnest_units / paper_units_per_world_unit,
                      thickest_units / paper_units_per_world_unit);
}

vec3 mark_normal(const shape &mesh, const mark &one)
{
    vec3 sum;
    for (int i = 0; i < one.vertex_count(); i++)
        sum = sum + mesh.normals[one.vertex[i]];
    return normalised(sum);
}

vec3 mark_middle(const std::vector<vec3> &points, const mark &one)
{
    vec3 sum;
    for (int i = 0; i < one.vertex_count(); i++)
        sum = sum + points[one.vertex[i]];
    return sum * (1.0 / one.vertex_count());
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
        if (one.what == element::at_triangle)
            marked.insert(in_order({one.vertex[0], one.vertex[1], one.vertex[2]}));
    std::vector<triangle> left;
    std::copy_if(triangles.begin(), triangles.end(), std::back_inserter(left),
                 [&](const triangle &t) { return !marked.count(in_order(t)); });
    return left;
}

std::vector<place> places_of_marks(const shape &mesh, const std::vector<mark> &marks)
{
    std::vector<place> places;
    double sum = 0;
    for (const mark &one : marks) {
        places.push_back(
            {mark_middle(mesh.points, one), mark_normal(mesh, one), one.kind == boundary ? .1 : 1});
        sum += places.back().weight;
    }
    if (!places.empty() && marks[0].kind != boundary)
        places[0].weight += sum / 3;
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

static void draw_triangle_swatch(paper &sheet, point2 at, mark_kind kind)
{
    const point2 corners[] = {{at.x - 9, at.y + 6}, {at.x + 9, at.y + 6}, {at.x, at.y - 8}};
    colour paint = palette::marks[kind];
    sheet.polygon({corners[0], corners[1], corners[2]}, paint.with_alpha(.62));
    for (int i = 0; i < 3; i++)
        sheet.line(corners[i], corners[(i + 1) % 3], 2.4, paint);
}

/* What most of the marks of a kind are. */
static element usual_element(const scene &from, mark_kind kind)
{
    int counts[3] = {};
    for (const mark &one : from.marks)
        if (one.kind == kind)
            counts[int(one.what)]++;
    if (counts[2] > counts[1] && counts[2] >= counts[0])
        return element::at_triangle;
    return counts[0] > counts[1] ? element::at_vertex : element::at_edge;
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
        if (from.mark_counts[k] > 0)
            entries.push_back({mark_names[k], mark_count(from, kind),
                               [kind, what](paper &sheet, point2 at, double width) {
                                   if (what == element::at_triangle)
                                       draw_triangle_swatch(sheet, at, kind);
                                   else if (what == element::at_vertex)
                                       sheet.disc(at, 5.8, palette::marks[kind]);
                                   else
                                       draw_edge_swatch(sheet, at, width, kind);
                               }});
    }
    for (const fact &one : from.facts)
        entries.push_back({one.name, one.value, [](paper &sheet, point2 at, double) {
                               sheet.disc(at, 2.5, palette::grey_ink);
                           }});
    return entries;
}
