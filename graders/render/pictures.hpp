/* One function a kind of picture; each throws not_showable when there is nothing that it can show.
 */
#ifndef GRADERS_RENDER_PICTURES_HPP
#define GRADERS_RENDER_PICTURES_HPP

#include "graders/render/image.hpp"
#include "graders/render/scene.hpp"

#include <string>
#include <vector>

struct picture_size {
    int width = 1120;
    int height = 840;
};

image draw_mesh(const scene &from, picture_size size);
image draw_strips(const scene &from, picture_size size);
image draw_voxels(const scene &from, picture_size size);
image draw_chart(const scene &from, picture_size size);
image draw_panels(const scene &from, picture_size size);
image draw_bars(const scene &from, picture_size size);
image draw_heatmap(const scene &from, picture_size size);
image draw_diagram(const scene &from, picture_size size);

/* A tile with the title and a sentence in the middle, for what cannot be drawn. */
image draw_tile(const scene &from, const std::string &sentence, picture_size size);

/* The picture of a scene of any kind; a tile with the reason where it cannot be shown. */
image draw_scene(const scene &from, picture_size size);

struct sheet_cell {
    std::string picture_path; /* empty or unreadable: an empty frame */
    std::string caption;      /* a second line may follow a line end */
};

struct sheet {
    std::string language; /* of our own words in it */
    std::string title, subtitle;
    int columns = 3;
    std::vector<sheet_cell> cells;
};

image draw_sheet(const sheet &from);

#endif
