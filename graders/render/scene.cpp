/* Reading scenes with distrust; see scene.hpp. */
#include "graders/render/scene.hpp"
#include "graders/render/figure_reader.hpp"
#include "graders/render/json_values.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>

const char *const mark_names[mark_kind_count] = {
    "missing", "duplicate", "extra",  "degenerate", "boundary", "flipped", "wrong",
    "right",   "turn-0",    "turn-1", "turn-2",     "turn-3",   "turn-4",  "turn-5"};

namespace
{
const int64_t vertex_limit = 2000000, triangle_limit = 1000000, strip_limit = 100000;
const int64_t mark_limit = 4000, label_limit = 1000, path_limit = 10000, curve_limit = 12,
              voxel_side_limit = 256;
const uintmax_t file_bytes_limit = 256u << 20;
const double exponent_limit = 100;

struct json_releaser {
    void operator()(json_t *json) const
    {
        json_decref(json);
    }
};

std::vector<vec3> points_at(const json_t *json, int64_t count)
{
    std::vector<uint8_t> bytes = bytes_at(json, "positions", size_t(count) * 12);
    std::vector<vec3> points(count);
    for (int64_t i = 0; i < count; i++) {
        float xyz[3];
        std::memcpy(xyz, bytes.data() + 12 * i, 12);
        if (!std::isfinite(xyz[0]) || !std::isfinite(xyz[1]) || !std::isfinite(xyz[2]))
            throw not_showable("vertex " + std::to_string(i) + " is not finite");
        points[i] = {xyz[0], xyz[1], xyz[2]};
    }
    return points;
}

void mesh_file_read(const json_t *json, scene_mesh &mesh)
{
    int64_t vertices = integer_at(json, "vertex_count", vertex_limit, "number of vertices");
    int64_t count = integer_at(json, "triangle_count", triangle_limit, "number of triangles");
    mesh.points = points_at(json, vertices);
    std::vector<uint8_t> bytes = bytes_at(json, "triangles", size_t(count) * 12);
    mesh.triangles.resize(count);
    for (int64_t t = 0; t < count; t++) {
        std::memcpy(mesh.triangles[t].data(), bytes.data() + 12 * t, 12);
        for (int32_t v : mesh.triangles[t])
            if (v < 0 || v >= vertices)
                throw not_showable("triangle " + std::to_string(t) + " names vertex " +
                                   std::to_string(v) + " of " + std::to_string(vertices));
    }
}

std::vector<int32_t> integers_at(const json_t *json, const char *key, int64_t count)
{
    std::vector<uint8_t> bytes = bytes_at(json, key, size_t(count) * 4);
    std::vector<int32_t> numbers(count);
    std::memcpy(numbers.data(), bytes.data(), bytes.size());
    return numbers;
}

/* The sides of all polygons, each edge once. */
void read_polygons(const json_t *json, scene &out)
{
    int64_t count = integer_at(json, "face_count", triangle_limit, "number of polygons");
    int64_t corners = integer_at(json, "corner_count", 3 * triangle_limit, "number of corners");
    std::vector<int32_t> sizes = integers_at(json, "sizes", count);
    std::vector<int32_t> corner = integers_at(json, "corners", corners);
    for (int32_t v : corner)
        if (v < 0 || size_t(v) >= out.mesh.points.size())
            throw not_showable("a polygon names vertex " + std::to_string(v));
    int64_t first = 0;
    for (int32_t size : sizes) {
        if (size < 1 || size > corners - first)
            throw not_showable("a polygon has " + std::to_string(size) + " corners");
        for (int64_t i = 0; i < size; i++) {
            int32_t a = corner[first + i], b = corner[first + (i + 1) % size];
            if (a != b)
                out.outlines.push_back({std::min(a, b), std::max(a, b)});
        }
        first += size;
    }
    std::sort(out.outlines.begin(), out.outlines.end());
    out.outlines.erase(std::unique(out.outlines.begin(), out.outlines.end()), out.outlines.end());
}

/* False when the list is longer than `limit` or holds what is no vertex. */
bool read_vertices(const json_t *list, size_t limit, const scene &from, std::vector<int32_t> &out)
{
    if (json_array_size(list) > limit)
        return false;
    for (size_t i = 0; i < json_array_size(list); i++) {
        const json_t *index = json_array_get(list, i);
        json_int_t v = json_is_integer(index) ? json_integer_value(index) : -1;
        if (v < 0 || size_t(v) >= from.mesh.points.size())
            return false;
        out.push_back(int32_t(v));
    }
    return true;
}

/* False for what names no known element or no vertex of the mesh: it is left out. */
bool read_element(const json_t *json, const scene &from, mark &out)
{
    struct rule {
        const char *name;
        size_t least, most;
    };
    const size_t many = size_t(path_limit);
    const rule rules[] = {{"vertex", 1, 1},  {"edge", 2, 2},         {"triangle", 3, 3},
                          {"arrow", 2, 2},   {"half-edge", 3, many}, {"path", 1, many},
                          {"loop", 1, many}, {"face", 3, many}};
    std::string what = text_at(json, "element");
    size_t e = 0;
    while (e < std::size(rules) && what != rules[e].name)
        e++;
    const json_t *list = json_object_get(json, "vertex");
    if (e == std::size(rules) || json_array_size(list) < rules[e].least ||
        !read_vertices(list, rules[e].most, from, out.vertex))
        return false;
    out.what = element(e);
    std::vector<int32_t> fill = out.vertex;
    if (out.vertex.size() > 3) {
        fill.clear();
        if (!read_vertices(json_object_get(json, "fill"), 3 * many, from, fill))
            return false;
    }
    for (size_t i = 0; out.is_face() && i + 2 < fill.size(); i += 3)
        out.fill.push_back({fill[i], fill[i + 1], fill[i + 2]});
    return true;
}

/* mark_kind_count when there is none. */
mark_kind kind_named(const std::string &name)
{
    int k = 0;
    while (k < mark_kind_count && name != mark_names[k])
        k++;
    return mark_kind(k);
}

void read_labels(const json_t *json, scene &out)
{
    const json_t *labels = json_object_get(json, "labels");
    for (size_t i = 0; i < json_array_size(labels) && i < size_t(label_limit); i++) {
        const json_t *from = json_array_get(labels, i), *number = json_object_get(from, "number");
        label one;
        one.number = json_integer_value(number);
        if (json_is_integer(number) && read_element(from, out, one.at))
            out.labels.push_back(one);
    }
}

void read_marks(const json_t *json, scene &out)
{
    const json_t *marks = json_object_get(json, "marks");
    for (size_t i = 0; i < json_array_size(marks) && i < size_t(mark_limit); i++) {
        mark one;
        one.kind = kind_named(text_at(json_array_get(marks, i), "kind"));
        if (one.kind < mark_kind_count && read_element(json_array_get(marks, i), out, one))
            out.marks.push_back(one);
    }
    const json_t *counts = json_object_get(json, "mark_counts");
    const json_t *names = json_object_get(json, "mark_names");
    for (int k = 0; k < mark_kind_count; k++) {
        out.mark_counts[k] =
            std::max<int64_t>(0, json_integer_value(json_object_get(counts, mark_names[k])));
        out.mark_words[k] = text_at(names, mark_names[k]);
    }
    out.turns_word = text_at(names, "turns");
    out.turn_count = std::max<int64_t>(0, json_integer_value(json_object_get(json, "turn_count")));
    const json_t *ok = json_object_get(json, "ok_count");
    out.ok_count = json_is_integer(ok) ? json_integer_value(ok) : -1;
}

void read_values(const json_t *json, scene &out)
{
    const json_t *values = json_object_get(json, "values");
    value_scale &to = out.values;
    to.of_vertices = text_at(values, "of") == "vertex";
    to.low = number_at(values, "low");
    to.high = number_at(values, "high");
    to.worst = number_at(values, "worst");
    to.unit = text_at(values, "unit");
    if (!(to.low <= to.high))
        throw not_showable("the scale of the values has no ends");
    size_t count = to.of_vertices ? out.mesh.points.size() : out.mesh.triangles.size();
    std::vector<uint8_t> bytes = bytes_at(values, "numbers", count * 4);
    to.numbers.resize(count);
    std::memcpy(to.numbers.data(), bytes.data(), bytes.size());
    for (float &number : to.numbers)
        number = std::isfinite(number) ? number : std::nanf("");
}

void read_vectors(const json_t *json, scene &out)
{
    const size_t most = 4;
    const json_t *sets = json_object_get(json, "vectors");
    for (size_t i = 0; i < json_array_size(sets) && i < most; i++) {
        const json_t *from = json_array_get(sets, i);
        size_t count = out.mesh.points.size();
        std::vector<uint8_t> bytes = bytes_at(from, "xyz", count * 12);
        vector_set to = {kind_named(text_at(from, "kind")), {}, {}};
        for (size_t v = 0; v < count && to.kind < mark_kind_count; v++) {
            float xyz[3];
            std::memcpy(xyz, bytes.data() + 12 * v, 12);
            bool finite = std::isfinite(xyz[0]) && std::isfinite(xyz[1]) && std::isfinite(xyz[2]);
            to.finite.push_back(finite);
            to.vectors.push_back(finite ? vec3{xyz[0], xyz[1], xyz[2]} : vec3());
        }
        if (to.kind < mark_kind_count)
            out.vectors.push_back(to);
    }
}

/* A mesh and all that lies on it. */
void read_mesh_parts(const json_t *json, scene &out)
{
    out.cut = json_is_true(json_object_get(json, "cut"));
    if (const json_t *mesh = json_object_get(json, "mesh"))
        mesh_file_read(mesh, out.mesh);
    if (const json_t *polygons = json_object_get(json, "polygons"))
        read_polygons(polygons, out);
    read_marks(json, out);
    read_labels(json, out);
    if (json_object_get(json, "values"))
        read_values(json, out);
    out.has_groups = json_object_get(json, "parts");
    if (out.has_groups)
        out.groups = bytes_at(json, "parts", out.mesh.triangles.size());
    read_vectors(json, out);
}

void read_strips(const json_t *json, scene &out)
{
    const json_t *strips = json_object_get(json, "strips");
    if (json_array_size(strips) > size_t(strip_limit))
        throw not_showable("more strips than a picture can show");
    int64_t left = vertex_limit;
    for (size_t i = 0; i < json_array_size(strips); i++) {
        const json_t *strip = json_array_get(strips, i);
        int64_t count = integer_at(strip, "vertex_count", left, "vertices of a strip");
        left -= count;
        out.strips.push_back(points_at(strip, count));
    }
}

void read_voxels(const json_t *json, scene &out)
{
    const json_t *voxels = json_object_get(json, "voxels");
    int64_t side = integer_at(voxels, "per_side", voxel_side_limit, "voxels a side");
    out.voxel_bits = bytes_at(voxels, "bits", size_t((side * side * side + 7) / 8));
    out.voxels_per_side = int(side);
    if (!json_object_get(voxels, "wrong"))
        return;
    out.wrong_bits = bytes_at(voxels, "wrong", size_t((side * side * side + 7) / 8));
    json_int_t named = json_integer_value(json_object_get(voxels, "named"));
    out.named_voxel = named >= 0 && named < side * side * side ? int(named) : -1;
}

void read_facts(const json_t *json, scene &out)
{
    const size_t limit = 8;
    const json_t *facts = json_object_get(json, "facts");
    for (size_t i = 0; i < json_array_size(facts) && i < limit; i++) {
        const json_t *from = json_array_get(facts, i);
        out.facts.push_back({text_at(from, "name"), text_at(from, "value")});
    }
}

/* Whether a number has a place on the axes of a chart. */
bool is_chartable(double number)
{
    const double least = 1e-12, most = 1e18;
    return number >= least && number <= most;
}

/* The curves of every growth chart have names in both languages; others stand as they are. */
std::string curve_word(const scene &from, const std::string &name)
{
    static const char *const known[][2] = {{"submission", "entrega"},
                                           {"reference", "referencia"},
                                           {"right", "correcto"},
                                           {"allowed", "permitido"}};
    for (const auto &pair : known)
        if (name == pair[0])
            return from.say(pair[0], pair[1]);
    return name;
}

/* Points without a place on logarithmic axes are left out. */
void read_curves(const json_t *json, scene &out)
{
    const json_t *curves = json_object_get(json, "curves");
    for (size_t i = 0; i < json_array_size(curves) && i < size_t(curve_limit); i++) {
        const json_t *from = json_array_get(curves, i);
        curve to;
        to.name = text_at(from, "name");
        to.guide = text_at(from, "guide");
        to.label = curve_word(out, to.name);
        if (!to.guide.empty())
            to.label =
                out.say("", "crecimiento ") + to.label + out.say(" growth: ", ": ") + to.guide;
        to.grows = out.say("grows as n", "crece como n");
        to.exponent = json_number_value(json_object_get(from, "exponent"));
        if (!(std::fabs(to.exponent) < exponent_limit))
            to.exponent = 0;
        std::vector<double> x = numbers_at(from, "x"), y = numbers_at(from, "y");
        if (x.size() != y.size())
            throw not_showable("curve \"" + to.name + "\" has " + std::to_string(x.size()) +
                               " x and " + std::to_string(y.size()) + " y");
        for (size_t p = 0; p < x.size(); p++)
            if (is_chartable(x[p]) && is_chartable(y[p])) {
                to.x.push_back(x[p]);
                to.y.push_back(y[p]);
            }
        out.curves.push_back(to);
    }
    out.x_label = text_at(json, "x_label");
    out.y_label = text_at(json, "y_label");
}

void read_notes(const json_t *json, scene &out)
{
    static const char *const keys[] = {"exercise", "case", "verdict", "seed", "student"};
    out.title = text_at(json, "title");
    out.subtitle = text_at(json, "subtitle");
    out.notes.title = out.title;
    const json_t *metadata = json_object_get(json, "metadata");
    for (const char *key : keys) {
        std::string text = text_at(metadata, key);
        if (!text.empty())
            out.notes.metadata[key] = text;
    }
}

scene_kind kind_of(const json_t *json)
{
    static const char *const names[] = {"none",   "mesh", "strips",  "voxels", "chart",
                                        "panels", "bars", "heatmap", "diagram"};
    std::string name = text_at(json, "kind");
    for (size_t k = 0; k < std::size(names); k++)
        if (name == names[k])
            return scene_kind(k);
    throw not_showable("no known kind of scene: \"" + name + "\"");
}
} // namespace

void read_scene(const std::string &path, const std::string &language, scene &out)
{
    std::error_code failed;
    uintmax_t bytes = std::filesystem::file_size(path, failed);
    if (failed || bytes > file_bytes_limit)
        throw std::runtime_error(path + ": " +
                                 (failed ? failed.message() : "bigger than any scene"));
    json_error_t error;
    std::unique_ptr<json_t, json_releaser> json(json_load_file(path.c_str(), 0, &error));
    if (!json || !json_is_object(json.get()))
        throw std::runtime_error(path + ": not a scene: " + (json ? "no object" : error.text));
    choose_language(json.get(), language);
    out.language = language;
    read_notes(json.get(), out);
    out.kind = kind_of(json.get());
    read_mesh_parts(json.get(), out);
    if (const json_t *answer = json_object_get(json.get(), "answer")) {
        out.answer = std::make_shared<scene>();
        out.answer->language = language;
        read_mesh_parts(answer, *out.answer);
    }
    read_facts(json.get(), out);
    if (out.kind == scene_kind::strips)
        read_strips(json.get(), out);
    if (out.kind == scene_kind::voxels)
        read_voxels(json.get(), out);
    if (out.kind == scene_kind::chart)
        read_curves(json.get(), out);
    read_figure(json.get(), out);
}
