/* Strips in turn colours, with the order of their vertices; see pictures.hpp. */
#include "graders/render/canvas.hpp"
#include "graders/render/magnifier.hpp"
#include "graders/render/marks.hpp"
#include "graders/render/pictures.hpp"
#include "graders/render/surfaces.hpp"
#include "graders/render/text.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <unordered_map>
#include <vtkCamera.h>

namespace
{
const int colour_count = int(std::size(palette::strips));
const size_t strips_with_ways = 300; /* more ways hide the strips */

/* All strips in one numbering, with the scene's mesh (what the marks name) after them. */
struct strip_set {
    std::vector<vec3> points;
    std::vector<size_t> first; /* of strip s; one more at the end */
    std::vector<triangle> triangles[colour_count];
    std::vector<edge> rungs;  /* the zigzag through the vertices in their order */
    std::vector<vec3> marked; /* the scene's mesh in the same box */
    size_t triangle_count = 0;
};

/* The triangles of strip s, by the lowest number of each place; counts them and adds the rungs. */
std::vector<triangle> triangles_of(strip_set &set, size_t s, const std::vector<int32_t> &place)
{
    std::vector<triangle> triangles;
    for (size_t i = set.first[s]; i + 1 < set.first[s + 1]; i++) {
        set.rungs.push_back({int32_t(i), int32_t(i + 1)});
        if (i + 2 >= set.first[s + 1])
            continue;
        bool odd = (i - set.first[s]) % 2 == 1;
        triangle t = {place[i], place[i + (odd ? 2 : 1)], place[i + (odd ? 1 : 2)]};
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
            continue;
        triangles.push_back(t);
        set.triangle_count++;
    }
    return triangles;
}

/* Gives strips their colours in turn, but leaves out those of the strips before that they touch
 * along an edge, as far as there are others: two strips of one colour would look like one. */
class colours_in_turn
{
  public:
    int next(const std::vector<triangle> &strip)
    {
        bool taken[colour_count] = {};
        for (const triangle &t : strip)
            for (int i = 0; i < 3; i++)
                for (auto [it, end] = sides.equal_range(side(t, i)); it != end; ++it)
                    taken[it->second] = true;
        int colour = turn++ % colour_count, tried = 0;
        for (; taken[colour] && tried < colour_count; tried++)
            colour = (colour + 1) % colour_count;
        for (const triangle &t : strip)
            for (int i = 0; i < 3; i++)
                sides.emplace(side(t, i), colour);
        return colour;
    }

  private:
    static uint64_t side(const triangle &t, int i)
    {
        uint32_t a = uint32_t(t[size_t(i)]), b = uint32_t(t[size_t((i + 1) % 3)]);
        return uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    }

    std::unordered_multimap<uint64_t, int> sides; /* colours of the strips at each edge so far */
    int turn = 0;
};

strip_set collect(const scene &from)
{
    strip_set set;
    for (const std::vector<vec3> &strip : from.strips) {
        set.first.push_back(set.points.size());
        set.points.insert(set.points.end(), strip.begin(), strip.end());
    }
    set.first.push_back(set.points.size());
    std::vector<vec3> all = set.points;
    all.insert(all.end(), from.mesh.points.begin(), from.mesh.points.end());
    unit_box box(all);
    set.points = box.apply(set.points);
    set.marked = box.apply(from.mesh.points);
    std::vector<int32_t> place = same_places(set.points);
    colours_in_turn colours;
    for (size_t s = 0; s + 1 < set.first.size(); s++) {
        std::vector<triangle> strip = triangles_of(set, s, place);
        std::vector<triangle> &same = set.triangles[colours.next(strip)];
        same.insert(same.end(), strip.begin(), strip.end());
    }
    return set;
}

std::vector<triangle> all_triangles(const strip_set &set)
{
    std::vector<triangle> all;
    for (const auto &triangles : set.triangles)
        all.insert(all.end(), triangles.begin(), triangles.end());
    return all;
}

double mean_length(const std::vector<vec3> &points, const std::vector<edge> &edges)
{
    double sum = 0;
    for (const edge &e : edges)
        sum += length(points[e[1]] - points[e[0]]);
    return edges.empty() ? 0 : sum / double(edges.size());
}

/* The way along each strip: from middle to middle of its rungs, with a ball where it starts and a
 * cone where it ends. */
void add_ways(canvas &target, const strip_set &set, double radius, vec3 lift)
{
    const double head = 7 * radius;
    solids ways;
    for (size_t s = 0; s + 1 < set.first.size(); s++) {
        std::vector<vec3> middles;
        for (size_t i = set.first[s]; i + 1 < set.first[s + 1]; i++)
            middles.push_back((set.points[i] + set.points[i + 1]) * .5 + lift);
        if (middles.size() < 2)
            continue;
        vec3 end = middles.back(), before = middles[middles.size() - 2];
        vec3 neck = end - normalised(end - before) * head;
        while (middles.size() > 1 && length(middles.back() - end) < head)
            middles.pop_back();
        middles.push_back(neck);
        ways.ball(middles[0], 2.2 * radius);
        for (size_t i = 1; i < middles.size(); i++)
            ways.tube(middles[i - 1], middles[i], .62 * radius);
        ways.cone(neck, end, 2.6 * radius);
    }
    if (!ways.empty())
        target.world()->AddActor(ways.actor(palette::ink, finish::lit));
}

std::vector<legend_entry> legend_of(const scene &from, const strip_set &set, bool shows_backs)
{
    std::vector<legend_entry> entries;
    entries.push_back(
        {from.say("strips in turn", "tiras por turno"), grouped(int64_t(from.strips.size())),
         [](paper &sheet, point2 at, double width) {
             for (int i = 0; i < colour_count; i++)
                 sheet.rectangle({at.x - width / 2 + width * i / colour_count, at.y - 6},
                                 width / colour_count, 12, palette::strips[i]);
         }});
    entries.push_back({from.say("triangles", "triángulos"), grouped(int64_t(set.triangle_count)),
                       [](paper &sheet, point2 at, double) {
                           sheet.polygon(
                               {{at.x - 8, at.y + 6}, {at.x + 8, at.y + 6}, {at.x, at.y - 7}},
                               palette::strips[0]);
                       }});
    if (from.strips.size() <= strips_with_ways)
        entries.push_back(
            {from.say("order", "orden"), "",
             [](paper &sheet, point2 at, double width) {
                 sheet.line({at.x - width / 2 + 3, at.y}, {at.x + 5, at.y}, 2, palette::ink);
                 sheet.disc({at.x - width / 2 + 3, at.y}, 3.6, palette::ink);
                 sheet.polygon(
                     {{at.x + 4, at.y - 5}, {at.x + 4, at.y + 5}, {at.x + width / 2 + 1, at.y}},
                     palette::ink);
             },
             true});
    for (legend_entry &entry : mark_legend(from))
        entries.push_back(entry);
    if (shows_backs)
        entries.push_back(patch_entry(from.say("back of a triangle", "reverso de un triángulo"),
                                      palette::back_face));
    return entries;
}
} // namespace

image draw_strips(const scene &from, picture_size size)
{
    strip_set set = collect(from);
    if (set.points.empty())
        throw not_showable(from.say("There are no strips: the answer has no vertices.",
                                    "No hay tiras: la respuesta no tiene vértices."));
    canvas target(size.width, size.height, backdrop::gradient);
    std::vector<triangle> all = all_triangles(set);
    shape named(set.marked, from.mesh.triangles);
    std::vector<place> surface = sample_surface(set.points, all);
    view look = best_view(surface, {});
    depth_grid depths(surface, look);
    std::optional<close_up> inset = choose_close_up(from, named, look, depths);
    std::vector<legend_entry> legend =
        legend_of(from, set, shows_a_back(set.points, all, look, depths));
    framing frame(target.world()->GetActiveCamera(), set.points, look, target.paper_width(),
                  {48, inset ? close_up_side + 56.0 : 48, 92, legend.size() > 4 ? 100.0 : 76.0});
    double units = frame.units_at_middle(), width = mean_length(set.points, set.rungs);
    double spacing = edge_spacing(set.points, all, set.rungs);
    double thin = std::clamp(.06 * spacing, .7 / units, 3.0 / units);
    double thick = std::clamp(.06 * width, .7 / units, 3.0 / units);

    for (int c = 0; c < colour_count; c++)
        if (!set.triangles[c].empty())
            target.world()->AddActor(
                surface_actor(set.points, set.triangles[c], palette::strips[c]));
    target.world()->AddActor(shadow_actor(set.points, all));
    double opacity = wire_opacity(spacing * units);
    target.world()->AddActor(
        wire_actor(set.points, set.rungs, 1.1 * target.scale(), palette::wire.with_alpha(opacity)));
    if (width * units > 7 && from.strips.size() <= strips_with_ways)
        add_ways(target, set, thick, look.toward * (1.5 * thick));
    pen how = {1.3 * thin, 1 / units};
    add_marks(target.world(), set.marked, from.marks, how, finish::lit);
    add_marks(target.front(), set.marked, from.marks, how, finish::ghost);
    if (inset)
        add_close_up(target, *inset, from, named, frame);
    target.on_paper([&](paper &sheet) {
        draw_title(sheet, from.title, from.subtitle);
        draw_legend(sheet, legend);
        draw_axes(sheet, look);
    });
    return target.draw(from.world.get());
}
