/* The markers of curves, told apart by shape as well as by colour. */
#ifndef GRADERS_RENDER_MARKER_HPP
#define GRADERS_RENDER_MARKER_HPP

#include "graders/render/paper.hpp"

/* look  any number; the shapes repeat */
void draw_marker(paper &sheet, point2 at, size_t look, double size, colour paint);

#endif
