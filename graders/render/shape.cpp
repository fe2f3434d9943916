/* See shape.hpp. */
#include "graders/render/shape.hpp"

#include <limits>
#include <numeric>

unit_box::unit_box(const std::vector<vec3> &points)
{
    if (points.empty())
        return;
    double big = std::numeric_limits<double>::infinity();
    vec3 low = {big, big, big}, high = {-big, -big, -big};
    for (vec3 p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    centre = (low + high) * .5;
    double diagonal = length(high - low);
    flat_point = !(diagonal > 0);
    scale = flat_point ? 1 : 1 / diagonal;
}

std::vector<vec3> unit_box::apply(const std::vector<vec3> &points) const
{
    std::vector<vec3> out;
    out.reserve(points.size());
    for (vec3 p : points)
        out.push_back((p - centre) * scale);
    return out;
}

/* Triangles with three different vertices, each set of three once: repeats would fight for the same
 * pixels. */
static std::vector<triangle> visible_triangles(const std::vector<triangle> &all)
{
    std::vector<triangle> sorted = all;
    for (triangle &t : sorted)
        std::sort(t.begin(), t.end());
    std::vector<int32_t> order(all.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int32_t a, int32_t b) { return sorted[a] < sorted[b]; });
    std::vector<bool> keep(all.size());
    for (size_t i = 0; i < order.size(); i++) {
        const triangle &t = sorted[order[i]];
        keep[order[i]] = t[0] != t[1] && t[1] != t[2] && (i == 0 || t != sorted[order[i - 1]]);
    }
    std::vector<triangle> visible;
    for (size_t t = 0; t < all.size(); t++)
        if (keep[t])
            visible.push_back(all[t]);
    return visible;
}

namespace
{
struct directed_edge {
    edge ends;    /* smaller index first */
    int8_t along; /* 1 when the triangle runs from the smaller to the larger, -1 else */
};
} // namespace

/* Fills `edges`; returns whether every edge has two triangles that run along it in opposite ways.
 */
static bool collect_edges(const std::vector<triangle> &triangles, std::vector<edge> &edges)
{
    std::vector<directed_edge> all;
    all.reserve(3 * triangles.size());
    for (const triangle &t : triangles)
        for (int i = 0; i < 3; i++) {
            int32_t a = t[i], b = t[(i + 1) % 3];
            all.push_back({{std::min(a, b), std::max(a, b)}, int8_t(a < b ? 1 : -1)});
        }
    std::sort(all.begin(), all.end(),
              [](const directed_edge &a, const directed_edge &b) { return a.ends < b.ends; });
    bool closed = true;
    for (size_t i = 0; i < all.size();) {
        size_t end = i;
        int balance = 0;
        while (end < all.size() && all[end].ends == all[i].ends)
            balance += all[end++].along;
        closed = closed && balance == 0;
        edges.push_back(all[i].ends);
        i = end;
    }
    return closed;
}

shape::shape(std::vector<vec3> given, const std::vector<triangle> &all,
             const std::vector<edge> &outlines)
    : points(std::move(given)), triangles(visible_triangles(all)), normals(points.size())
{
    std::vector<bool> used(points.size());
    double volume = 0;
    for (const triangle &t : all)
        for (int32_t v : t)
            used[v] = true;
    for (const triangle &t : triangles) {
        vec3 a = points[t[0]], b = points[t[1]], c = points[t[2]];
        vec3 normal = cross(b - a, c - a);
        volume += dot(a, normal);
        for (int32_t v : t)
            normals[v] = normals[v] + normal;
    }
    for (vec3 &normal : normals)
        normal = normalised(normal);
    for (size_t v = 0; v < used.size(); v++)
        if (!used[v])
            isolated.push_back(int32_t(v));
    shows_inside = !triangles.empty() && (!collect_edges(triangles, edges) || volume < 0);
    if (!outlines.empty())
        edges = outlines;
    spacing = edge_spacing(points, triangles, edges);
}

double edge_spacing(const std::vector<vec3> &points, const std::vector<triangle> &triangles,
                    const std::vector<edge> &edges)
{
    double area = 0, sum = 0;
    for (const triangle &t : triangles)
        area += length(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]])) / 2;
    for (const edge &e : edges)
        sum += length(points[e[1]] - points[e[0]]);
    if (!(sum > 0))
        return 0;
    /* An even mesh has area sqrt(3)/6 of the edge length for a unit of edge. */
    return std::min(sum / double(edges.size()), area / sum * 2 * std::sqrt(3.0));
}

std::vector<int32_t> same_places(const std::vector<vec3> &points)
{
    std::vector<int32_t> order(points.size()), first(points.size());
    std::iota(order.begin(), order.end(), 0);
    auto place = [&](int32_t i) { return std::array{points[i].x, points[i].y, points[i].z}; };
    std::stable_sort(order.begin(), order.end(),
                     [&](int32_t a, int32_t b) { return place(a) < place(b); });
    for (size_t i = 0; i < order.size(); i++)
        first[order[i]] =
            i > 0 && place(order[i]) == place(order[i - 1]) ? first[order[i - 1]] : order[i];
    return first;
}
