/* A scene as it stands in its file, checked: README.md has the format. */
#ifndef GRADERS_RENDER_SCENE_HPP
#define GRADERS_RENDER_SCENE_HPP

#include "graders/render/figure.hpp"
#include "graders/render/image.hpp"
#include "graders/render/vec.hpp"

#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

enum class scene_kind { none, mesh, strips, voxels, chart, panels, bars, heatmap, diagram };
enum mark_kind {
    missing,
    duplicate,
    extra,
    degenerate,
    boundary,
    flipped,
    wrong,
    right_one,
    turn_0,
    turn_last = turn_0 + 5,
    mark_kind_count
};
enum class element { at_vertex, at_edge, at_triangle, arrow, half_edge, path, loop, face };

extern const char *const mark_names[mark_kind_count];

struct mark {
    mark_kind kind;
    element what;
    std::vector<int32_t> vertex;
    std::vector<triangle> fill; /* of a face and a triangle */

    int vertex_count() const
    {
        return int(vertex.size());
    }
    bool is_face() const
    {
        return what == element::at_triangle || what == element::face;
    }
    bool is_fault() const
    {
        return kind != boundary && kind < right_one;
    }
};

/* The number of a vertex, an edge or a face, where it is seen. */
struct label {
    mark at; /* its kind is not used */
    int64_t number;
};

struct scene_mesh {
    std::vector<vec3> points;
    std::vector<triangle> triangles;
};

/* Numbers that colour a surface. */
struct value_scale {
    std::vector<float> numbers; /* one a vertex or triangle, NaN: none; empty: no values */
    bool of_vertices = true;
    double low = 0, high = 0;
    double worst = std::nan(""); /* NaN: none is named */
    std::string unit;
};

struct vector_set {
    mark_kind kind;
    std::vector<vec3> vectors; /* one a vertex; zero, too, for what is not finite */
    std::vector<bool> finite;
};

struct curve {
    std::string name;
    std::string label, grows; /* what the legend says of it, and before its exponent */
    std::string guide;        /* not empty: a line for the eye, "n lg n", not a measure */
    std::vector<double> x, y; /* as many, all in [1e-12, 1e18] */
    double exponent = 0;      /* 0: none was fitted */
};

/* A number that the legend tells. */
struct fact {
    std::string name, value;
};

struct drawn_world; /* canvas.hpp */

struct scene {
    scene_kind kind = scene_kind::none;
    std::string language;               /* of the picture's words, "en" or "es" */
    std::shared_ptr<drawn_world> world; /* of this scene in any language; may be null */
    std::string title, subtitle;
    scene_mesh mesh;
    std::vector<edge> outlines; /* of polygons; none: the mesh is one of triangles */
    std::vector<mark> marks;    /* every index is within the mesh */
    std::vector<label> labels;  /* likewise */
    value_scale values;
    std::vector<uint8_t> groups; /* the turn colour of each triangle, more than 5: none */
    bool has_groups = false;     /* parts of the whole mesh are in turn colours */
    std::vector<vector_set> vectors;
    std::shared_ptr<scene> answer; /* what a mesh has, of the answer's; shown beside */
    int64_t mark_counts[mark_kind_count] = {};
    std::string mark_words[mark_kind_count]; /* empty: the usual word */
    std::string turns_word;
    int64_t turn_count = 0;
    int64_t ok_count = -1; /* -1: not said */
    bool cut = false;
    std::vector<std::vector<vec3>> strips;
    int voxels_per_side = 0;
    std::vector<uint8_t> voxel_bits;
    std::vector<uint8_t> wrong_bits; /* of the same cells; empty: not told */
    int named_voxel = -1;            /* number of the cell that the verdict names */
    std::vector<fact> facts;
    std::vector<curve> curves;
    std::string x_label, y_label;
    figure shown; /* panels, bars, heat map, diagram; what else stands beside voxels */
    image_notes notes;

    /* The text in the picture's language. */
    const char *say(const char *en, const char *es) const
    {
        return language == "es" ? es : en;
    }
    bool voxel(int x, int y, int z) const /* false outside */
    {
        return bit_of(voxel_bits, x, y, z);
    }
    bool wrong_voxel(int x, int y, int z) const
    {
        return !wrong_bits.empty() && bit_of(wrong_bits, x, y, z);
    }

  private:
    bool bit_of(const std::vector<uint8_t> &bits, int x, int y, int z) const
    {
        if (x < 0 || y < 0 || z < 0 || x >= voxels_per_side || y >= voxels_per_side ||
            z >= voxels_per_side)
            return false;
        size_t bit = x + size_t(voxels_per_side) * (y + size_t(voxels_per_side) * z);
        return bits[bit / 8] >> bit % 8 & 1;
    }
};

/* The scene has no picture, but its title and notes are known: a tile can say why. */
struct not_showable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/* Reads a scene with its texts in a language, "en" or "es"; its file may hold anything. `out` gets
 * what could be read even when it throws. Throws not_showable (sizes that lie, indices out of
 * range, coordinates that are not finite, more than a picture can show) or std::runtime_error (no
 * file, not JSON). */
void read_scene(const std::string &path, const std::string &language, scene &out);

#endif
