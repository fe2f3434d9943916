/* The close-up: the first element at fault, magnified in a frame beside the mesh, seen from its own
 * outer side, with the numbers of its vertices. */
#ifndef GRADERS_RENDER_MAGNIFIER_HPP
#define GRADERS_RENDER_MAGNIFIER_HPP

#include "graders/render/camera.hpp"
#include "graders/render/canvas.hpp"
#include "graders/render/scene.hpp"
#include "graders/render/shape.hpp"

#include <optional>

inline constexpr double close_up_side = 190; /* units of paper */

struct close_up {
    mark shown;
    vec3 middle;
    view look;
    double half_width; /* of what is shown, in the world */
};

/* None when nothing is marked or the first element at fault is seen and big enough in the picture
 * itself. */
std::optional<close_up> choose_close_up(const scene &from, const shape &mesh, const view &look,
                                        const depth_grid &depths);

void add_close_up(canvas &target, const close_up &inset, const scene &from, const shape &mesh,
                  const framing &frame);

#endif
