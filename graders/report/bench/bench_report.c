/* From bench.json to a folder with a page; see bench_report.h. */
#include "graders/report/bench/bench_report.h"

#include "graders/report/bench/page.h"
#include "graders/report/documents.h"
#include "graders/report/renderer.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { STYLE_LIMIT_BYTES = 1 << 20 };

/* Whether `made` is there and not older than `from`. */
static bool is_up_to_date(const char *made, const char *from)
{
    struct stat a, b;
    if (stat(made, &a) != 0 || stat(from, &b) != 0 || a.st_size == 0)
        return false;
    return a.st_mtim.tv_sec != b.st_mtim.tv_sec ? a.st_mtim.tv_sec > b.st_mtim.tv_sec
                                                : a.st_mtim.tv_nsec >= b.st_mtim.tv_nsec;
}

/* Writes the scene of a figure, or removes what an earlier run left of it. */
static int write_scene(const struct study *study, const struct figure *figure, const char *folder,
                       const char *renderer, json_t *pictures, struct error *err)
{
    char scene_path[DOCUMENT_PATH_BYTES], picture_path[DOCUMENT_PATH_BYTES];
    char scene_name[64], picture_name[64];
    snprintf(scene_name, sizeof scene_name, "%s.json", figure->name);
    snprintf(picture_name, sizeof picture_name, "%s.png", figure->name);
    if (document_path(scene_path, err, "%s/pictures/%s", folder, scene_name) != 0 ||
        document_path(picture_path, err, "%s/pictures/%s", folder, picture_name) != 0)
        return -1;
    json_t *scene = figure->scene(study);
    if (!scene) {
        unlink(scene_path);
        unlink(picture_path);
        return 0;
    }
    int status = document_write_json(scene_path, scene, err);
    json_decref(scene);
    bool fresh =
        is_up_to_date(picture_path, scene_path) &&
        (!renderer || access(renderer, R_OK) != 0 || is_up_to_date(picture_path, renderer));
    if (status == 0 && !fresh)
        json_array_append_new(pictures, json_pack("{s:s, s:s, s:i, s:i}", "scene", scene_name,
                                                  "out", picture_name, "width", figure->width,
                                                  "height", figure->height));
    return status;
}

static int draw(const char *folder, const char *renderer, json_t *pictures, struct phrase *reason,
                struct error *err)
{
    char path[DOCUMENT_PATH_BYTES];
    size_t count = json_array_size(pictures);
    if (count == 0)
        return 0;
    if (document_path(path, err, "%s/pictures/job.json", folder) != 0)
        return -1;
    json_t *job = json_pack("{s:O}", "pictures", pictures);
    int status = document_write_json(path, job, err);
    json_decref(job);
    if (status != 0)
        return -1;
    if (!renderer || access(renderer, X_OK) != 0)
        *reason = renderer_absent_reason();
    else
        renderer_run(renderer, path, renderer_limit_ms(count), reason);
    unlink(path);
    return 0;
}

/* Scenes and pictures of all figures. */
static int make_pictures(const struct study *study, const char *folder, const char *renderer,
                         struct phrase *reason, struct error *err)
{
    char path[DOCUMENT_PATH_BYTES];
    if (document_path(path, err, "%s/pictures", folder) != 0 ||
        document_make_folders(path, err) != 0)
        return -1;
    json_t *pictures = json_array();
    int status = 0;
    for (size_t i = 0; study_figures[i] && status == 0; i++)
        status = write_scene(study, study_figures[i], folder, renderer, pictures, err);
    if (status == 0)
        status = draw(folder, renderer, pictures, reason, err);
    json_decref(pictures);
    return status;
}

static int copy_style(const char *folder, const char *root, struct error *err)
{
    char from[DOCUMENT_PATH_BYTES], to[DOCUMENT_PATH_BYTES];
    size_t length = 0;
    if (document_path(to, err, "%s/assets", folder) != 0 || document_make_folders(to, err) != 0 ||
        document_path(from, err, "%s/graders/report/bench/bench.css", root) != 0 ||
        document_path(to, err, "%s/assets/bench.css", folder) != 0)
        return -1;
    char *bytes = document_read(from, STYLE_LIMIT_BYTES, &length, err);
    int status = bytes ? document_write(to, bytes, length, err) : -1;
    free(bytes);
    return status;
}

static int write_page(const struct study *study, const char *folder, const char *reason,
                      struct error *err)
{
    char path[DOCUMENT_PATH_BYTES];
    struct html page;
    if (document_path(path, err, "%s/index.html", folder) != 0 || html_start(&page, err) != 0)
        return -1;
    struct bench_page context = {.study = study, .folder = folder, .pictures_reason = reason};
    bench_page_write(&page, &context);
    int status = html_finish(&page, err);
    if (status == 0)
        status = document_write(path, page.text, page.length, err);
    html_release(&page);
    return status;
}

int bench_report(const char *folder, const char *renderer, const char *root, char *reason,
                 size_t capacity, struct error *err)
{
    char path[DOCUMENT_PATH_BYTES];
    struct study study;
    struct phrase why = {"", ""};
    if (document_path(path, err, "%s/bench.json", folder) != 0)
        return -1;
    json_t *document = document_read_json(path, err);
    if (!document)
        return -1;
    int status = study_take(&study, document, err);
    study.root = root;
    if (status == 0)
        status = make_pictures(&study, folder, renderer, &why, err);
    if (status == 0)
        status = copy_style(folder, root, err);
    if (status == 0)
        status = write_page(&study, folder, why.en, err);
    if (reason)
        snprintf(reason, capacity, "%s", why.en);
    study_release(&study);
    return status;
}
