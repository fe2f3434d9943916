/* A job: which pictures and sheets to make of which files; README.md has the format. */
#ifndef GRADERS_RENDER_JOB_HPP
#define GRADERS_RENDER_JOB_HPP

#include "graders/render/pictures.hpp"

#include <string>
#include <vector>

/* A file in a language, "en" or "es". */
struct picture_out {
    std::string language, path;
};

struct picture_job {
    std::string scene_path;
    std::vector<picture_out> outs; /* the same scene with words in each language */
    picture_size size;
};

struct sheet_job {
    sheet content;
    std::string out_path;
};

struct job {
    std::vector<picture_job> pictures;
    std::vector<sheet_job> sheets;
};

/* Reads a job; the paths in it come out relative to the working folder. Throws std::runtime_error.
 */
job read_job(const std::string &path);

/* Makes everything, pictures first. Returns how many were not made; each is said on stderr. */
int run_job(const job &work);

#endif
