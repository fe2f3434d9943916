/* Arrows, half edges and paths as solids: edges whose direction is seen. */
#ifndef GRADERS_RENDER_ARROWS_HPP
#define GRADERS_RENDER_ARROWS_HPP

#include "graders/render/solids.hpp"

/* How thick a picture is drawn: the radius of a plain tube, and how long in the world a unit of the
 * paper is, so that heads of arrows stay big enough to be seen. */
struct pen {
    double radius, unit;
};

/* A tube with a head before its end; `dashed` for what is not there. */
void add_arrow(solids &out, vec3 from, vec3 to, const pen &how, bool dashed);

/* The half edge from corner 0 to corner 1 of a face, a little inside the face. */
void add_half_edge(solids &out, const std::vector<vec3> &corners, const pen &how, bool dashed);

/* The two ends of that half edge. */
std::array<vec3, 2> half_edge_ends(const std::vector<vec3> &corners, const pen &how);

/* A path with heads along it, as close as they are told apart and at least one; it begins with a
 * ball, or is closed back to its first place. */
void add_path(solids &out, const std::vector<vec3> &places, bool closed, const pen &how,
              bool dashed);

/* A tube in dashes of the same length as its gaps. */
void add_dashes(solids &out, vec3 from, vec3 to, double radius);

#endif
