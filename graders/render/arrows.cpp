/* See arrows.hpp. */
#include "graders/render/arrows.hpp"

namespace
{
const double head_length = 2.3; /* radii of the head */

double head_radius(const pen &how)
{
    const double tubes = 2.7, units = 5.2;
    return std::max(tubes * how.radius, units * how.unit);
}

void add_shaft(solids &out, vec3 from, vec3 to, double radius, bool dashed)
{
    if (dashed)
        add_dashes(out, from, to, radius);
    else
        out.tube(from, to, radius);
}

void add_head(solids &out, vec3 middle, vec3 along, double radius)
{
    vec3 way = normalised(along) * (head_length * radius / 2);
    out.cone(middle - way, middle + way, radius);
}
} // namespace

void add_dashes(solids &out, vec3 a, vec3 b, double radius)
{
    const double period = 7;     /* radii: a dash and the gap after it, round ends included */
    const double half_dash = .2; /* periods */
    int dashes = std::clamp(int(length(b - a) / (period * radius) + .5), 1, 40);
    for (int i = 0; i < dashes; i++)
        out.tube(a + (b - a) * ((i + .5 - half_dash) / dashes),
                 a + (b - a) * ((i + .5 + half_dash) / dashes), radius);
}

void add_arrow(solids &out, vec3 from, vec3 to, const pen &how, bool dashed)
{
    const double most_head = .45; /* of the arrow */
    double whole = length(to - from), radius = head_radius(how);
    double head = std::min(head_length * radius, most_head * whole);
    if (!(whole > 0))
        return out.ball(from, 2 * how.radius);
    vec3 neck = to - (to - from) * (head / whole);
    add_shaft(out, from, neck, how.radius, dashed);
    out.cone(neck, to, std::max(head / head_length, 1.6 * how.radius));
}

std::array<vec3, 2> half_edge_ends(const std::vector<vec3> &corners, const pen &how)
{
    const double end_share = .1, inside_share = .3, inside_tubes = 4.2;
    vec3 a = corners[0], b = corners[1], normal;
    for (size_t i = 0; i < corners.size(); i++)
        normal = normal + cross(corners[i] - a, corners[(i + 1) % corners.size()] - a);
    vec3 inwards = normalised(cross(normal, b - a));
    double depth = 0; /* of the face behind the edge */
    for (vec3 corner : corners)
        depth = std::max(depth, dot(corner - a, inwards));
    double inset = std::min(inside_tubes * how.radius, inside_share * depth);
    vec3 aside = inwards * inset + normalised(normal) * (.5 * how.radius);
    return {a + (b - a) * end_share + aside, b - (b - a) * end_share + aside};
}

void add_half_edge(solids &out, const std::vector<vec3> &corners, const pen &how, bool dashed)
{
    std::array<vec3, 2> ends = half_edge_ends(corners, how);
    add_arrow(out, ends[0], ends[1], how, dashed);
}

void add_path(solids &out, const std::vector<vec3> &places, bool closed, const pen &how,
              bool dashed)
{
    const double head_distance = 4.2; /* lengths of a head */
    double distance = head_distance * head_length * head_radius(how);
    size_t steps = places.size() - (closed ? 0 : 1);
    double since = distance / 2, whole = 0; /* the first head comes early */
    std::vector<std::array<vec3, 2>> heads; /* where, and which way */
    for (size_t i = 0; i < steps; i++) {
        vec3 a = places[i], b = places[(i + 1) % places.size()];
        double step = length(b - a);
        add_shaft(out, a, b, how.radius, dashed);
        whole += step;
        since += step;
        if (!(step > 0) || (since < distance && !(heads.empty() && i + 1 == steps)))
            continue;
        int count = std::max(1, int(step / distance));
        for (int h = 0; h < count; h++)
            heads.push_back({a + (b - a) * ((h + .5) / count), b - a});
        since = 0;
    }
    double radius = std::min(head_radius(how), .3 * whole / head_length);
    for (const std::array<vec3, 2> &head : heads)
        add_head(out, head[0], head[1], radius);
    if (!closed || !(whole > 0))
        out.ball(places[0], 2 * how.radius);
}
