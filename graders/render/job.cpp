/* See job.hpp. */
#include "graders/render/job.hpp"
#include "graders/render/canvas.hpp"
#include "graders/render/json_values.hpp"
#include "graders/render/text.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <jansson.h>
#include <memory>
#include <stdexcept>

namespace
{
const int side_least = 64, side_most = 4096;

/* As it stands: paths may be long. */
std::string string_at(const json_t *json, const char *key)
{
    const json_t *value = json_object_get(json, key);
    return json_is_string(value) ? std::string(json_string_value(value)) : "";
}

int bounded_at(const json_t *json, const char *key, int otherwise, int least, int most)
{
    const json_t *value = json_object_get(json, key);
    if (!json_is_integer(value))
        return otherwise;
    return int(std::clamp<json_int_t>(json_integer_value(value), least, most));
}

/* A path as seen from the job's folder; empty stays empty. */
std::string located(const std::filesystem::path &folder, const std::string &path)
{
    return path.empty() ? "" : (folder / path).string();
}

/* The languages in which a part of the job is made: those of {"out": {"en": ..., "es": ...}}, or
 * the one that it names. */
std::vector<std::string> languages_of(const json_t *json)
{
    const json_t *out = json_object_get(json, "out");
    std::vector<std::string> languages;
    for (const char *language : {"en", "es"})
        if (!string_at(out, language).empty())
            languages.push_back(language);
    if (languages.empty())
        languages.push_back(string_at(json, "language"));
    return languages;
}

std::string out_in(const json_t *json, const std::string &language)
{
    const json_t *out = json_object_get(json, "out");
    return string_at(json_is_object(out) ? out : json,
                     json_is_object(out) ? language.c_str() : "out");
}

picture_job read_picture(const json_t *json, const std::filesystem::path &folder)
{
    picture_job one;
    one.scene_path = located(folder, string_at(json, "scene"));
    for (const std::string &language : languages_of(json))
        one.outs.push_back({language, located(folder, out_in(json, language))});
    one.size.width = bounded_at(json, "width", one.size.width, side_least, side_most);
    one.size.height = bounded_at(json, "height", one.size.height, side_least, side_most);
    return one;
}

sheet_job read_sheet(const json_t *both, const std::string &language,
                     const std::filesystem::path &folder)
{
    sheet_job one;
    json_t *json = json_deep_copy(both);
    choose_language(json, language);
    one.content.language = language;
    one.content.title = string_at(json, "title");
    one.content.subtitle = string_at(json, "subtitle");
    one.content.columns = bounded_at(json, "columns", one.content.columns, 1, 100);
    one.out_path = located(folder, string_at(json, "out"));
    const json_t *cells = json_object_get(json, "cells");
    for (size_t i = 0; i < json_array_size(cells); i++) {
        const json_t *cell = json_array_get(cells, i);
        one.content.cells.push_back(
            {located(folder, string_at(cell, "picture")), string_at(cell, "caption")});
    }
    json_decref(json);
    return one;
}

/* A picture of a scene; `world` is what those in other languages have drawn, or null. */
void make_picture(const picture_job &one, const picture_out &out,
                  const std::shared_ptr<drawn_world> &world)
{
    scene shown;
    image picture;
    try {
        shown.world = world;
        read_scene(one.scene_path, out.language, shown);
        picture = draw_scene(shown, one.size);
    } catch (const not_showable &why) {
        picture = draw_tile(shown,
                            shown.say("Cannot be shown: ", "No se puede mostrar: ") +
                                std::string(why.what()),
                            one.size);
    }
    write_image(picture, shown.notes, out.path);
}

void make_sheet(const sheet_job &one)
{
    image_notes notes;
    notes.title = one.content.title;
    write_image(draw_sheet(one.content), notes, one.out_path);
}

/* Makes one file; a failure is said in a line and counted. */
int attempt(const std::string &out_path, const std::function<void()> &make)
{
    try {
        if (out_path.empty())
            throw std::runtime_error("the job names no \"out\"");
        make();
        return 0;
    } catch (const std::exception &why) {
        std::string text = clean_text(why.what(), 300);
        std::string path = clean_text(out_path, 300);
        std::fprintf(stderr, "meshgrade-render: %s: not drawn: %s\n", path.c_str(), text.c_str());
        return 1;
    }
}

int make_pictures(const picture_job &one)
{
    std::shared_ptr<drawn_world> world =
        one.outs.size() > 1 ? std::make_shared<drawn_world>() : nullptr;
    int failures = 0;
    for (const picture_out &out : one.outs)
        failures += attempt(out.path, [&] { make_picture(one, out, world); });
    return failures;
}
} // namespace

job read_job(const std::string &path)
{
    json_error_t error;
    json_t *json = json_load_file(path.c_str(), 0, &error);
    if (!json)
        throw std::runtime_error(path + ": " + error.text);
    std::filesystem::path folder = std::filesystem::path(path).parent_path();
    job work;
    const json_t *pictures = json_object_get(json, "pictures");
    for (size_t i = 0; i < json_array_size(pictures); i++)
        work.pictures.push_back(read_picture(json_array_get(pictures, i), folder));
    const json_t *sheets = json_object_get(json, "sheets");
    for (size_t i = 0; i < json_array_size(sheets); i++)
        for (const std::string &language : languages_of(json_array_get(sheets, i)))
            work.sheets.push_back(read_sheet(json_array_get(sheets, i), language, folder));
    bool is_job = json_is_object(json);
    json_decref(json);
    if (!is_job)
        throw std::runtime_error(path + ": not a job: no object");
    return work;
}

int run_job(const job &work)
{
    int failures = 0;
    for (const picture_job &one : work.pictures)
        failures += make_pictures(one);
    for (const sheet_job &one : work.sheets)
        failures += attempt(one.out_path, [&] { make_sheet(one); });
    return failures;
}
