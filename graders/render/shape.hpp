/* The geometry of a mesh made ready for drawing: in a unit box around the origin, without what
 * cannot be seen or would flicker, and with its edges. No drawing here. */
#ifndef GRADERS_RENDER_SHAPE_HPP
#define GRADERS_RENDER_SHAPE_HPP

#include "graders/render/vec.hpp"

/* Moves and scales so that the given points lie in a box around the origin whose diagonal is 1.
 * Keeps meshes far from the origin, huge ones and tiny ones sharp in binary32. */
struct unit_box {
    vec3 centre;
    double scale = 1;
    bool flat_point = false; /* all points are one */

    unit_box() = default;
    explicit unit_box(const std::vector<vec3> &points);
    std::vector<vec3> apply(const std::vector<vec3> &points) const;
};

struct shape {
    std::vector<vec3> points;
    std::vector<triangle> triangles; /* no vertex twice, no triangle twice */
    std::vector<edge> edges;         /* every edge of every triangle once, smaller index first */
    std::vector<int32_t> isolated;   /* vertices that no triangle uses */
    std::vector<vec3> normals;       /* of the vertices; zero where there is none */
    double spacing = 0;              /* edge_spacing of it */
    bool shows_inside = false;       /* open, or wound incoherently or inside out */

    shape() = default;
    /* Outlines: the edges of the polygons that the triangles fill; none: the triangles' own. */
    shape(std::vector<vec3> points, const std::vector<triangle> &triangles,
          const std::vector<edge> &outlines = {});
};

/* How far edges lie apart, as the edge length of the even mesh that has as much edge on as much
 * surface: the mean edge length, but small for long edges close together. 0 when there are no
 * edges. */
double edge_spacing(const std::vector<vec3> &points, const std::vector<triangle> &triangles,
                    const std::vector<edge> &edges);

/* For each point the smallest index of a point at the same place. */
std::vector<int32_t> same_places(const std::vector<vec3> &points);

#endif
