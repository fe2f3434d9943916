/* Where to look from, and how to fill the picture. */
#ifndef GRADERS_RENDER_CAMERA_HPP
#define GRADERS_RENDER_CAMERA_HPP

#include "graders/render/paper.hpp"
#include "graders/render/vec.hpp"

class vtkCamera;

/* The directions of a look, as unit vectors in the world; z is up. */
struct view {
    vec3 toward; /* from the object to the eye */
    vec3 right, up;

    view() : view(-55, 22)
    {
    }
    view(double azimuth_degrees, double elevation_degrees);
};

/* A place on a surface within the unit box: which way is outwards (zero: unknown) and how much it
 * counts. */
struct place {
    vec3 point, normal;
    double weight;
};

/* Places all over a surface, some thousands, evenly by area; cost is linear in the triangles. */
std::vector<place> sample_surface(const std::vector<vec3> &points,
                                  const std::vector<triangle> &triangles);

/* How near to the eye a surface within the unit box comes, in the cells of a coarse picture. */
class depth_grid
{
  public:
    /* Asked about points that were moved by `aside` from where the surface was given. */
    depth_grid(const std::vector<place> &surface, const view &look, vec3 aside = {});
    bool hides(vec3 point) const; /* roughly */

  private:
    static constexpr int cells = 48;
    size_t cell(vec3 point) const;

    view look_;
    vec3 aside_;
    std::vector<double> nearest_;
};

/* The view, of a few dozen, from which the surface shows most of its outer side and most of the
 * marked places are seen and not hidden by the surface; the usual one when they do not differ much.
 * From below only when places are marked that are not seen from above. */
view best_view(const std::vector<place> &surface, const std::vector<place> &marked);

/* Whether some triangle turns its back to the eye and is not hidden. */
bool shows_a_back(const std::vector<vec3> &points, const std::vector<triangle> &triangles,
                  const view &look, const depth_grid &depths);

/* Room left free around the object, in units of paper. */
struct margins {
    double left, right, top, bottom;
};

/* A camera set up, which can also say where a point falls on the paper. */
class framing
{
  public:
    /* Sets the camera so that all points just fit between the margins. */
    framing(vtkCamera *camera, const std::vector<vec3> &points, const view &look,
            double paper_width, const margins &free);

    point2 on_paper(vec3 point) const;
    /* Units of paper a unit of the world, at the middle of the object. */
    double units_at_middle() const;

  private:
    vec3 focus_;
    double distance_ = 1;
    view look_;
    double paper_width_;
};

#endif
