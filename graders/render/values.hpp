/* What a mesh carries: values as colours with a bar, parts in turn colours, vectors as arrows. */
#ifndef GRADERS_RENDER_VALUES_HPP
#define GRADERS_RENDER_VALUES_HPP

#include "graders/render/marks.hpp"

/* The surface, in the colours of the scene's values or parts if it has some. */
vtkSmartPointer<vtkActor> scene_surface(const scene &from, const shape &mesh);

/* Whether each triangle has a colour that marks must not cover. */
bool has_coloured_faces(const scene &from);

/* The scene's marks; faces have only their outline where they would hide values. */
std::vector<mark> drawn_marks(const scene &from);

/* The arrows of all sets, thinned out where vertices lie close; those of the first mark are always
 * there, and only they have ghosts. */
void add_vectors(vtkRenderer *renderer, const scene &from, const shape &mesh, const pen &how,
                 finish look);
inline constexpr double vectors_reach = .13; /* how long nearly all are at most, in the world */

std::vector<legend_entry> vector_legend(const scene &from);

/* The bar of the values: their ends, the unit, and the worst. */
void draw_scale(paper &sheet, point2 corner, const value_scale &values);
inline constexpr double scale_room = 44; /* units of paper that the bar is high */

#endif
