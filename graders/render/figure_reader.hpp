/* Reading the figures of a scene; see figure.hpp. */
#ifndef GRADERS_RENDER_FIGURE_READER_HPP
#define GRADERS_RENDER_FIGURE_READER_HPP

#include "graders/render/scene.hpp"

#include <jansson.h>

/* Fills what the kind of the scene asks for. The scene's mesh and voxels have been read. Points and
 * bars that have no place on their axes are left out; throws not_showable for sizes that lie. */
void read_figure(const json_t *json, scene &out);

#endif
