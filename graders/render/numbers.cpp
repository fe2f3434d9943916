/* See numbers.hpp. */
#include "graders/render/numbers.hpp"

#include <algorithm>
#include <set>

namespace
{
const size_t few_vertices = 36, few_of_mark = 12;

/* A face is hidden when another lies before it, or when it is seen from behind on a closed mesh. */
bool is_hidden(const label &one, vec3 middle, const shape &mesh, const view &look,
               const depth_grid &depths)
{
    if (depths.hides(middle))
        return true;
    if (!one.at.is_face() || mesh.shows_inside || one.at.fill.empty())
        return false;
    vec3 normal;
    for (const triangle &t : one.at.fill)
        normal = normal + cross(mesh.points[t[1]] - mesh.points[t[0]],
                                mesh.points[t[2]] - mesh.points[t[0]]);
    return dot(normal, look.toward) < 0;
}

/* Whether some mark names all vertices of the labelled element. */
bool is_marked(const scene &from, const label &one)
{
    auto names = [](const mark &by, int32_t v) {
        return std::find(by.vertex.begin(), by.vertex.end(), v) != by.vertex.end();
    };
    return std::any_of(from.marks.begin(), from.marks.end(), [&](const mark &by) {
        return by.vertex.size() <= few_of_mark &&
               std::all_of(one.at.vertex.begin(), one.at.vertex.end(),
                           [&](int32_t v) { return names(by, v); });
    });
}

std::vector<int32_t> numbered_vertices(const scene &from, const shape &mesh)
{
    std::vector<int32_t> vertices;
    if (from.cut)
        return vertices;
    if (numbers_all(mesh))
        for (size_t v = 0; v < mesh.points.size(); v++)
            vertices.push_back(int32_t(v));
    else if (!from.marks.empty() && from.marks[0].is_fault() &&
             from.marks[0].vertex.size() <= few_of_mark)
        vertices = from.marks[0].vertex;
    return vertices;
}
} // namespace

bool numbers_all(const shape &mesh)
{
    return mesh.points.size() <= few_vertices;
}

std::vector<number> numbers_of(const scene &from, const shape &mesh, const view &look,
                               const depth_grid &depths)
{
    std::vector<number> numbers;
    std::set<int32_t> labelled;
    for (const label &one : from.labels)
        if (one.at.what == element::at_vertex)
            labelled.insert(one.at.vertex[0]);
    for (int32_t v : numbered_vertices(from, mesh))
        if (labelled.insert(v).second)
            numbers.push_back({element::at_vertex, mesh.points[v], std::to_string(v),
                               depths.hides(mesh.points[v])});
    for (const label &one : from.labels) {
        vec3 middle = mark_middle(mesh.points, one.at);
        bool hidden = is_hidden(one, middle, mesh, look, depths);
        if (hidden && one.at.what != element::at_vertex && !is_marked(from, one))
            continue; /* it would be read as the number of what lies before it */
        element what = one.at.is_face() ? element::face : one.at.what;
        numbers.push_back(
            {what, middle, std::to_string(one.number), is_hidden(one, middle, mesh, look, depths)});
    }
    /* What is seen lies over what is hidden. */
    std::stable_sort(numbers.begin(), numbers.end(),
                     [](const number &a, const number &b) { return a.hidden && !b.hidden; });
    return numbers;
}

void draw_numbers(paper &sheet, const std::vector<number> &numbers,
                  const std::function<point2(vec3)> &on_paper, point2 middle)
{
    for (const number &one : numbers) {
        point2 at = on_paper(one.at);
        if (one.what == element::at_vertex)
            draw_label(sheet, at, {at.x - middle.x, at.y - middle.y}, one.words, one.hidden);
        else
            draw_sign(sheet, at, one.words, one.what == element::face ? sign::circle : sign::box,
                      one.hidden);
    }
}

std::vector<legend_entry> number_legend(const scene &from)
{
    bool edges = false, faces = false;
    for (const label &one : from.labels) {
        edges = edges || one.at.what == element::at_edge;
        faces = faces || one.at.is_face();
    }
    std::vector<legend_entry> entries;
    if (!edges && !faces)
        return entries;
    entries.push_back({"vertex number", "",
                       [](paper &sheet, point2 at, double) {
                           draw_label(sheet, {at.x, at.y + 13}, {0, 0}, "0", false);
                       },
                       true});
    if (edges)
        entries.push_back(
            {"edge number", "",
             [](paper &sheet, point2 at, double) { draw_sign(sheet, at, "0", sign::box, false); },
             true});
    if (faces)
        entries.push_back({"face number", "",
                           [](paper &sheet, point2 at, double) {
                               draw_sign(sheet, at, "0", sign::circle, false);
                           },
                           true});
    return entries;
}
