/* A mesh with its faults marked, and its picture; see mesh_report.h. */
#include "graders/scene/scene.h"
#include "graders/engine/base/files.h"
#include "graders/report/documents.h"
#include "graders/report/mesh/mesh_report.h"
#include "graders/report/renderer.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { PICTURE_WIDTH = 1120, PICTURE_HEIGHT = 840 };

/* What the legend calls the marks; a scene has fewer kinds of marks than a mesh has faults. */
static const struct {
    enum mark_kind mark;
    struct phrase name;
} mark_names[] = {
    {MARK_WRONG, {"not manifold", "no variedad"}},
    {MARK_FLIPPED, {"incoherent", "incoherente"}},
    {MARK_DUPLICATE, {"duplicate", "repetido"}},
    {MARK_DEGENERATE, {"without area", "sin área"}},
    {MARK_EXTRA, {"self-intersecting", "se atraviesa"}},
    {MARK_MISSING, {"crack or T-vertex", "grieta o vértice en T"}},
};

static void mark_triangle(struct scene *scene, enum mark_kind kind, const struct mesh *mesh,
                          int32_t triangle)
{
    const int32_t *corner = mesh->triangles + 3 * (int64_t)triangle;
    scene_mark_triangle(scene, kind, corner[0], corner[1], corner[2]);
}

static void mark_element(struct scene *scene, const struct mesh *mesh, enum survey_kind kind,
                         const int32_t at[4])
{
    switch (kind) {
    case SURVEY_DEGENERATE:
    case SURVEY_FLAT:
        mark_triangle(scene, MARK_DEGENERATE, mesh, at[0]);
        break;
    case SURVEY_DUPLICATE:
        mark_triangle(scene, MARK_DUPLICATE, mesh, at[0]);
        break;
    case SURVEY_ISOLATED: /* the renderer shows these by itself */
        break;
    case SURVEY_NONMANIFOLD_EDGE:
        scene_mark_edge(scene, MARK_WRONG, at[0], at[1]);
        break;
    case SURVEY_NONMANIFOLD_VERTEX:
        scene_mark_vertex(scene, MARK_WRONG, at[0]);
        break;
    case SURVEY_INCOHERENT:
        scene_mark_edge(scene, MARK_FLIPPED, at[0], at[1]);
        break;
    case SURVEY_CRACK:
        scene_mark_edge(scene, MARK_MISSING, at[0], at[1]);
        break;
    case SURVEY_T_VERTEX:
        scene_mark_vertex(scene, MARK_MISSING, at[0]);
        break;
    case SURVEY_CROSSING: /* mark_crossings */
    case SURVEY_KINDS:
        break;
    }
}

/* A triangle that runs through many others is marked once. */
static void mark_crossings(struct scene *scene, const struct mesh *mesh,
                           const struct survey_fault *fault)
{
    uint8_t *is_marked = calloc((size_t)mesh->triangle_count + 1, 1);
    for (int32_t k = 0; is_marked && k < fault->kept_count; k++)
        for (int i = 0; i < 2; i++) {
            int32_t triangle = fault->kept[k].at[i];
            if (!is_marked[triangle])
                mark_triangle(scene, MARK_EXTRA, mesh, triangle);
            is_marked[triangle] = 1;
        }
    free(is_marked);
}

/* The gravest first: the first mark is magnified. */
static void mark_faults(struct scene *scene, const struct mesh_report *report)
{
    static const enum survey_kind order[SURVEY_KINDS] = {SURVEY_NONMANIFOLD_EDGE,
                                                         SURVEY_NONMANIFOLD_VERTEX,
                                                         SURVEY_CROSSING,
                                                         SURVEY_INCOHERENT,
                                                         SURVEY_CRACK,
                                                         SURVEY_T_VERTEX,
                                                         SURVEY_DUPLICATE,
                                                         SURVEY_FLAT,
                                                         SURVEY_DEGENERATE,
                                                         SURVEY_ISOLATED};
    for (int i = 0; i < SURVEY_KINDS; i++) {
        const struct survey_fault *fault = &report->survey.faults[order[i]];
        if (order[i] == SURVEY_CROSSING)
            mark_crossings(scene, &report->mesh, fault);
        for (int32_t k = 0; k < fault->kept_count; k++)
            mark_element(scene, &report->mesh, order[i], fault->kept[k].at);
    }
    for (size_t i = 0; i < sizeof mark_names / sizeof *mark_names; i++)
        scene_name_marks(scene, mark_names[i].mark, mark_names[i].name);
}

/* Both edges and cracks come by their vertices' numbers. What is a crack is not marked a second time. */
static int mark_boundary(struct scene *scene, const struct mesh *mesh,
                         const struct survey_fault *cracks, struct error *err)
{
    struct edge_list list;
    if (edge_list_init(&list, mesh, err))
        return -1;
    int32_t next = 0;
    for (int64_t e = 0; e < list.edge_count; e++) {
        const struct edge *edge = &list.edges[e];
        bool is_crack = next < cracks->kept_count && cracks->kept[next].at[0] == edge->low &&
                        cracks->kept[next].at[1] == edge->high;
        next += is_crack;
        if (edge_use_count(edge) == 1 && !is_crack)
            scene_mark_edge(scene, MARK_BOUNDARY, edge->low, edge->high);
    }
    edge_list_release(&list);
    return 0;
}

/* The file's name and the size of the mesh. */
static void add_titles(json_t *json, const struct mesh_report *report)
{
    struct mesh_fact facts[MESH_REPORT_FACTS];
    const char *slash = strrchr(report->name, '/');
    mesh_report_facts(report, facts);
    json_t *title = json_string(slash ? slash + 1 : report->name);
    json_object_set_new(json, "title", title ? title : json_string("mesh"));
    json_object_set_new(json, "subtitle",
                        json_pack("{s:s, s:s}", "en", facts[0].text.en, "es", facts[0].text.es));
}

json_t *mesh_report_scene(const struct mesh_report *report, struct error *err)
{
    struct scene scene = {0};
    const struct mesh *mesh = &report->mesh;
    json_t *json = NULL;
    if (scene_set_mesh(&scene, mesh->positions, mesh->vertex_count, mesh->triangles,
                       mesh->triangle_count, err) == 0) {
        mark_faults(&scene, report);
        if (report->survey.topology.boundary.count == 0 ||
            mark_boundary(&scene, mesh, &report->survey.faults[SURVEY_CRACK], err) == 0)
            json = scene_to_json(&scene);
    }
    scene_release(&scene);
    if (json)
        add_titles(json, report);
    else
        error_set(err, "out of memory for a picture");
    return json;
}

/* -- drawing ---------------------------------------------------------------------------------- */

/* Draws the scene that stands in `folder` as scene.json. */
static int draw(const char *folder, const char *out, const char *renderer, enum language language,
                struct error *err)
{
    char job_path[DOCUMENT_PATH_BYTES];
    struct phrase reason = renderer_default_reason();
    json_t *job = json_pack("{s:[{s:s, s:s, s:s, s:i, s:i}]}", "pictures", "scene", "scene.json",
                            "out", out, "language", language == LANGUAGE_ES ? "es" : "en", "width",
                            PICTURE_WIDTH, "height", PICTURE_HEIGHT);
    if (!job)
        return error_set(err, "%s: a name that is not UTF-8 cannot be drawn to", out);
    int status = document_path(job_path, err, "%s/job.json", folder);
    if (status == 0)
        status = document_write_json(job_path, job, err);
    json_decref(job);
    if (status != 0)
        return -1;
    unlink(out);
    if (!renderer || access(renderer, X_OK) != 0)
        reason = renderer_absent_reason();
    else
        renderer_run(renderer, job_path, renderer_limits(1), &reason);
    unlink(job_path);
    return access(out, R_OK) == 0 ? 0 : error_set(err, "%s was not drawn: %s", out, reason.en);
}

/* Paths in a job are relative to its folder. */
static int absolute_path(const char *path, char absolute[PATH_MAX], struct error *err)
{
    char here[PATH_MAX];
    if (path[0] == '/' ? snprintf(absolute, PATH_MAX, "%s", path) < PATH_MAX
                       : getcwd(here, sizeof here) &&
                             snprintf(absolute, PATH_MAX, "%s/%s", here, path) < PATH_MAX)
        return 0;
    return error_set(err, "%.200s: too long a path", path);
}

int mesh_report_picture(const struct mesh_report *report, const char *path, const char *renderer,
                        enum language language, struct error *err)
{
    char folder[PATH_MAX] = "", scene_path[PATH_MAX], out[PATH_MAX];
    if (absolute_path(path, out, err) != 0)
        return -1;
    json_t *scene = mesh_report_scene(report, err);
    if (!scene)
        return -1;
    int status = folder_make_work(folder, err);
    if (status == 0)
        status = file_path(scene_path, err, "%s/scene.json", folder);
    if (status == 0)
        status = document_write_json(scene_path, scene, err);
    if (status == 0)
        status = draw(folder, out, renderer, language, err);
    folder_remove_work(folder);
    json_decref(scene);
    return status;
}
