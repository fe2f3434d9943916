/* What stands over every picture of a thing in space: title, legend, axes. */
#ifndef GRADERS_RENDER_OVERLAY_HPP
#define GRADERS_RENDER_OVERLAY_HPP

#include "graders/render/camera.hpp"
#include "graders/render/paper.hpp"

#include <functional>
#include <string>
#include <vector>

/* One entry of a legend: draws its swatch into a box of the given width around `centre`. */
struct legend_entry {
    std::string name;
    std::string count; /* may be empty */
    std::function<void(paper &, point2 centre, double width)> swatch;
    bool muted = false;
};

/* The title in one line, smaller when it is long; the subtitle in at most two. */
void draw_title(paper &sheet, const std::string &title, const std::string &subtitle);

/* Entries from the right in as many rows as needed, growing upwards from the bottom edge. */
void draw_legend(paper &sheet, const std::vector<legend_entry> &entries);

/* A plain number beside a vertex; `away` is the direction to put it. Muted: the vertex is hidden,
 * and a ring shows where it is. */
void draw_label(paper &sheet, point2 at, point2 away, const std::string &words, bool muted);

/* The number of an edge in a box, of a face in a circle, over its middle. */
enum class sign { box, circle };
void draw_sign(paper &sheet, point2 at, const std::string &words, sign shape, bool muted);

/* The three axes as seen from the camera, in the lower left corner. */
void draw_axes(paper &sheet, const view &look);

#endif
