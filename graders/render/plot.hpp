/* What the figures share: legends by key, guides and texts on white. */
#ifndef GRADERS_RENDER_PLOT_HPP
#define GRADERS_RENDER_PLOT_HPP

#include "graders/render/axis.hpp"
#include "graders/render/figure.hpp"
#include "graders/render/overlay.hpp"

/* The colour of a look, and one of it dark enough for text on white. */
colour look_colour(size_t look);
colour look_ink(size_t look);

/* Where the figure may begin below the title and subtitle. */
double draw_figure_title(paper &sheet, const std::string &title, const std::string &subtitle);

/* The entries as the pictures' legend, at the bottom right. */
void draw_key(paper &sheet, const std::vector<key_entry> &entries);

/* Places of `heights`-high things wished at `wished`, moved as little as keeps them apart and
 * within low ... high where there is room. In order of the wishes. */
std::vector<double> spread(std::vector<double> wished, double height, double low, double high);

/* A label that reads upwards along a guide, from y = top down or up to y = bottom; beyond the guide
 * where the plot's left edge is near. */
void draw_guide_label(paper &sheet, double x, double left, double top, double bottom, bool at_top,
                      const std::string &words);

#endif
