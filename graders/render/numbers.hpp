/* The numbers of vertices, edges and faces on a picture of a mesh. */
#ifndef GRADERS_RENDER_NUMBERS_HPP
#define GRADERS_RENDER_NUMBERS_HPP

#include "graders/render/canvas.hpp"
#include "graders/render/marks.hpp"

/* A number ready to be drawn. */
struct number {
    element what; /* at_vertex, at_edge or face */
    vec3 at;
    std::string words;
    bool hidden;
};

/* The scene's labels, and the numbers of vertices: of all when the mesh has few, else of the first
 * mark. Vertices that have a label get no other number. None of vertices when the mesh is cut:
 * there its numbers are others. */
std::vector<number> numbers_of(const scene &from, const shape &mesh, const view &look,
                               const depth_grid &depths);

/* Whether the mesh is so small that all its vertices are numbered. */
bool numbers_all(const shape &mesh);

/* Those of vertices outwards of `middle`. */
void draw_numbers(paper &sheet, const std::vector<number> &numbers,
                  const std::function<point2(vec3)> &on_paper, point2 middle);

/* What the signs mean; none when only vertices have numbers. */
std::vector<legend_entry> number_legend(const scene &from);

#endif
