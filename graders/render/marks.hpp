/* How the elements at fault look: colour, shape and words each tell the kinds apart. */
#ifndef GRADERS_RENDER_MARKS_HPP
#define GRADERS_RENDER_MARKS_HPP

#include "graders/render/arrows.hpp"
#include "graders/render/overlay.hpp"
#include "graders/render/scene.hpp"
#include "graders/render/shape.hpp"
#include "graders/render/solids.hpp"

#include <vtkMapper.h>
#include <vtkRenderer.h>

/* Adds the marks as solids: tubes for edges (dashed when missing, beaded when duplicate, ...), with
 * heads for arrows and paths, balls for vertices, filled patches with an outline for faces. The
 * pen's radius is that of a plain tube. */
void add_marks(vtkRenderer *renderer, const std::vector<vec3> &points,
               const std::vector<mark> &marks, const pen &how, finish look);

/* The pen that suits a mesh: thin against its edges, and yet seen in the picture. */
pen mark_pen(const shape &mesh, double paper_units_per_world_unit);

/* Outward direction at a mark: the mean of its vertices' normals. */
vec3 mark_normal(const shape &mesh, const mark &one);
/* A place on the mark: the mean of its vertices, of a path one of them, of a face within it. */
vec3 mark_middle(const std::vector<vec3> &points, const mark &one);

/* The triangles that no mark on a triangle covers. */
std::vector<triangle> without_marked(const std::vector<triangle> &triangles,
                                     const std::vector<mark> &marks);

/* Where the marks are, for choosing a view: the first counts as much as a third of all others. */
std::vector<place> places_of_marks(const shape &mesh, const std::vector<mark> &marks);

/* Legend entries of every kind that was counted or marked, then of what is right. */
std::vector<legend_entry> mark_legend(const scene &from);

/* A legend entry with a small square of a colour, or with a disc. */
legend_entry patch_entry(const std::string &name, colour paint);
legend_entry disc_entry(const std::string &name, const std::string &count, colour paint);

#endif
