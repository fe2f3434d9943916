/* See camera.hpp. */
#include "graders/render/camera.hpp"

#include <vtkCamera.h>

static const double view_angle_degrees = 24;

/* Half the picture's height seen at distance 1. */
static double half_height()
{
    return std::tan(view_angle_degrees / 2 * M_PI / 180);
}

static double radians(double degrees)
{
    return degrees * M_PI / 180;
}

view::view(double azimuth_degrees, double elevation_degrees)
    : toward{std::cos(radians(elevation_degrees)) * std::cos(radians(azimuth_degrees)),
             std::cos(radians(elevation_degrees)) * std::sin(radians(azimuth_degrees)),
             std::sin(radians(elevation_degrees))},
      right{-std::sin(radians(azimuth_degrees)), std::cos(radians(azimuth_degrees)), 0},
      up(cross(toward, right))
{
}

std::vector<place> sample_surface(const std::vector<vec3> &points,
                                  const std::vector<triangle> &triangles)
{
    const double enough = 12000;
    std::vector<place> samples;
    double total = 0, owed = 0;
    for (const triangle &t : triangles)
        total += length(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
    for (const triangle &t : triangles) {
        vec3 a = points[t[0]], ab = points[t[1]] - a, ac = points[t[2]] - a;
        vec3 normal = cross(ab, ac);
        /* The R2 sequence fills a triangle evenly; a sample is owed for each share of the area. */
        owed += total > 0 ? enough * length(normal) / total : 0;
        for (int i = 1; owed >= 1; owed -= 1, i++) {
            double u = std::fmod(.5 + i * .7548776662466927, 1);
            double v = std::fmod(.5 + i * .5698402909980532, 1);
            if (u + v > 1) {
                u = 1 - u;
                v = 1 - v;
            }
            samples.push_back({a + ab * u + ac * v, normalised(normal), 1});
        }
    }
    return samples;
}

depth_grid::depth_grid(const std::vector<place> &surface, const view &look, vec3 aside)
    : look_(look), aside_(aside), nearest_(cells * cells, -1e9)
{
    for (const place &sample : surface) {
        double &nearest = nearest_[cell(sample.point)];
        nearest = std::max(nearest, dot(sample.point, look.toward));
    }
}

bool depth_grid::hides(vec3 point) const
{
    const double near_enough = .05;
    point = point - aside_;
    return nearest_[cell(point)] > dot(point, look_.toward) + near_enough;
}

size_t depth_grid::cell(vec3 point) const
{
    auto column = [](double at) { return std::clamp(int((at + .5) * cells), 0, cells - 1); };
    return size_t(column(dot(point, look_.up))) * cells + column(dot(point, look_.right));
}

namespace
{
/* Weighted share of the marked places that are seen flat and not hidden, 0 ... 1. Which side of the
 * surface they turn to the eye does not count: it may be wound inside out. */
double share_seen(const std::vector<place> &surface, const std::vector<place> &marked,
                  const view &look)
{
    const double facing_enough = .5;
    if (marked.empty())
        return 0;
    depth_grid grid(surface, look);
    double sum = 0, weights = 0;
    for (const place &one : marked) {
        bool known = length(one.normal) > 0;
        double facing = std::min(std::fabs(dot(one.normal, look.toward)) / facing_enough, 1.0);
        weights += one.weight;
        if (!grid.hides(one.point))
            sum += one.weight * (known ? facing : 1);
    }
    return sum / weights;
}

double share_facing(const std::vector<place> &surface, const view &look)
{
    const double back_worth = .5;
    double sum = 0;
    for (const place &one : surface) {
        double facing = dot(one.normal, look.toward);
        sum += facing > 0 ? facing : -back_worth * facing;
    }
    return surface.empty() ? 0 : sum / double(surface.size());
}
} // namespace

view best_view(const std::vector<place> &surface, const std::vector<place> &marked)
{
    const double usual_azimuth = -55, usual_elevation = 22;
    const double usual_bonus = .12, cost_a_degree = .004, cost_from_below = .15, seen_worth = 1.3;
    view best;
    double best_score = -1e9;
    for (double elevation : {usual_elevation, 38.0, 54.0, -usual_elevation, -48.0})
        for (int step = 0; step < 12; step++) {
            if (elevation < 0 && marked.empty())
                continue;
            double azimuth = usual_azimuth + 30 * step;
            view candidate(azimuth, elevation);
            bool usual = step == 0 && elevation == usual_elevation;
            double score = share_facing(surface, view(azimuth, std::fabs(elevation))) +
                           seen_worth * share_seen(surface, marked, candidate) +
                           (usual ? usual_bonus : 0) -
                           (std::fabs(elevation) - usual_elevation) * cost_a_degree -
                           (elevation < 0 ? cost_from_below : 0);
            if (score > best_score + 1e-9) {
                best_score = score;
                best = candidate;
            }
        }
    return best;
}

bool shows_a_back(const std::vector<vec3> &points, const std::vector<triangle> &triangles,
                  const view &look, const depth_grid &depths)
{
    return std::any_of(triangles.begin(), triangles.end(), [&](const triangle &t) {
        vec3 a = points[t[0]], b = points[t[1]], c = points[t[2]];
        return dot(cross(b - a, c - a), look.toward) < 0 && !depths.hides((a + b + c) * (1.0 / 3));
    });
}

framing::framing(vtkCamera *camera, const std::vector<vec3> &points, const view &look,
                 double paper_width, const margins &free)
    : look_(look), paper_width_(paper_width)
{
    const int rounds = 6;
    double room_width = paper_width - free.left - free.right;
    double room_height = paper_height - free.top - free.bottom;
    double middle_x = free.left + room_width / 2, middle_y = free.top + room_height / 2;
    double reach = 0;
    for (vec3 p : points)
        reach = std::max(reach, length(p));
    distance_ = std::max(3 * reach, .1);
    for (int round = 0; round < rounds && reach > 0; round++) {
        double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
        for (vec3 p : points) {
            point2 at = on_paper(p);
            left = std::min(left, at.x);
            right = std::max(right, at.x);
            top = std::min(top, at.y);
            bottom = std::max(bottom, at.y);
        }
        double unit = 1 / units_at_middle();
        focus_ = focus_ + look_.right * ((left + right) / 2 - middle_x) * unit +
                 look_.up * (middle_y - (top + bottom) / 2) * unit;
        double over = std::max((right - left) / room_width, (bottom - top) / room_height);
        distance_ = std::max(distance_ * over, 1.3 * reach);
    }
    vec3 eye = focus_ + look_.toward * distance_;
    camera->SetFocalPoint(focus_.x, focus_.y, focus_.z);
    camera->SetPosition(eye.x, eye.y, eye.z);
    camera->SetViewUp(look_.up.x, look_.up.y, look_.up.z);
    camera->SetViewAngle(view_angle_degrees);
    camera->SetClippingRange(std::max(distance_ - 2.5 * reach, distance_ * .02),
                             distance_ + 3 * reach + .1);
}

double framing::units_at_middle() const
{
    return paper_height / 2 / (half_height() * distance_);
}

point2 framing::on_paper(vec3 point) const
{
    vec3 offset = point - focus_;
    double depth = std::max(distance_ - dot(offset, look_.toward), 1e-6);
    double units = paper_height / 2 / (half_height() * depth);
    return {paper_width_ / 2 + dot(offset, look_.right) * units,
            paper_height / 2 - dot(offset, look_.up) * units};
}
