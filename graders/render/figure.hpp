/* Figures of a study as they stand in a scene: panels of curves, bars, heat maps, diagrams. All are
 * checked while reading; README.md has the format. */
#ifndef GRADERS_RENDER_FIGURE_HPP
#define GRADERS_RENDER_FIGURE_HPP

#include "graders/render/vec.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

inline constexpr double absent = std::numeric_limits<double>::quiet_NaN();

/* A line across a plot at a value of one axis. */
struct guide {
    bool on_x = true;
    double value = 1;
    std::string label;
};

enum class key_shape { bar, tick, line, arrow, face, point };

/* An entry of a legend. */
struct key_entry {
    key_shape shape = key_shape::bar;
    size_t look = 0; /* into palette::looks */
    std::string name;
};

struct series {
    std::string name;
    size_t look = 0;
    bool dashed = false;
    std::vector<double> x, y;      /* as many, within the axes' range */
    std::vector<double> low, high; /* as many as y, or none */
};

struct panel {
    std::string title, x_label, y_label;
    bool x_linear = false, y_linear = false;
    std::vector<series> lines;
    std::vector<guide> guides;
};

struct panel_figure {
    size_t columns = 1;
    bool shared_axes = false; /* all panels show the same range */
    std::vector<panel> panels;
};

struct bar {
    std::string name, label; /* the label stands at its end */
    double value = absent;   /* absent: only the label */
    double low = absent, high = absent, tick = absent;
    size_t look = 0;
};

struct bar_group {
    std::string title;
    std::vector<bar> bars;
};

struct bar_figure {
    bool logarithmic = false;
    std::string x_label;
    std::vector<guide> guides;
    std::vector<bar_group> groups;
};

struct heat_cell {
    double value = absent; /* absent: an empty cell */
    std::string label;
};

struct heat_figure {
    std::vector<std::string> rows, columns;
    std::vector<heat_cell> cells; /* rows x columns */
    double low = 1, high = 10;    /* of the colours, logarithmic */
    std::string low_label, high_label;
};

struct diagram_face {
    size_t triangle;
    size_t look;
};

struct diagram_arrow {
    vec3 from, to;
    size_t look;
    std::string label; /* at its middle */
    bool dashed;
};

struct diagram_label {
    vec3 at;
    size_t look;
    std::string text; /* empty: only a point */
};

struct diagram_figure {
    bool has_view = false;
    double azimuth_degrees = 0, elevation_degrees = 0;
    std::vector<diagram_face> faces;
    std::vector<diagram_arrow> arrows;
    std::vector<diagram_label> labels;
};

/* A full cube of cells, for octrees: its lowest cell and its side, in cells. */
struct cell_box {
    int32_t x, y, z, side;
};

struct figure {
    panel_figure curves;
    bar_figure bars;
    heat_figure heat;
    diagram_figure diagram;
    std::vector<key_entry> legend;
    std::vector<cell_box> boxes; /* within voxels_per_side of the scene */
    std::vector<std::pair<std::string, std::string>> captions; /* under things side by side */
};

#endif
