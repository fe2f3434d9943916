/* meshgrade-render: draws the pictures of a job; README.md is the contract. */
#include "graders/render/job.hpp"
#include "graders/render/paper.hpp"
#include "graders/render/window.hpp"

#include <cstdio>
#include <cstring>
#include <exception>

enum exit_code { all_drawn = 0, some_not_drawn = 1, nothing_drawn = 2, wrong_usage = 64 };

int main(int argc, char **argv)
{
    if (argc != 2 || argv[1][0] == '-') {
        bool asked = argc == 2 && std::strcmp(argv[1], "--help") == 0;
        std::fprintf(asked ? stdout : stderr,
                     "usage: meshgrade-render JOB.json    draws every picture of the job\n");
        return asked ? all_drawn : wrong_usage;
    }
    try {
        job work = read_job(argv[1]);
        choose_shader_cache();
        silence_vtk();
        keep_fonts();
        if (!has_opengl()) {
            std::fprintf(stderr, "meshgrade-render: no OpenGL here (no EGL driver of Mesa): no "
                                 "pictures; install libegl1 and libgl1-mesa-dri\n");
            return nothing_drawn;
        }
        int failures = run_job(work);
        size_t all = work.pictures.size() + work.sheets.size();
        if (failures > 0 && size_t(failures) == all)
            return nothing_drawn;
        return failures > 0 ? some_not_drawn : all_drawn;
    } catch (const std::exception &why) {
        std::fprintf(stderr, "meshgrade-render: %s\n", why.what());
        return nothing_drawn;
    }
}
