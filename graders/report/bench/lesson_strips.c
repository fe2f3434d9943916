/* Picture: the strips of a real model in turn colours. */
#include "graders/report/bench/lesson.h"

#include "graders/scene/scene.h"
#include "reference/formats/mesh_file.h"
#include "reference/mesh/generate.h"
#include "reference/mesh/strips.h"

#include <limits.h>

enum { STAND_IN_TRIANGLES = 4000 };

/* The bunny; where the tree with the models is not at hand, a torus. */
static int read_model(const struct study *study, struct mesh *mesh, struct error *err)
{
    char path[PATH_MAX];
    if (!study->root)
        return generate_torus(mesh, 1, STAND_IN_TRIANGLES, err);
    snprintf(path, sizeof path, "%s/exercises/models/bunny.ply", study->root);
    return mesh_file_read(path, mesh, err);
}

static int cut(const struct study *study, struct mesh *mesh, struct strips *strips)
{
    struct error ignored = {""};
    return read_model(study, mesh, &ignored) == 0 && strips_from_mesh(strips, mesh, &ignored) == 0
               ? 0
               : -1;
}

static json_t *scene(const struct study *study)
{
    struct mesh mesh = {0};
    struct strips strips = {0};
    struct scene scene = {0};
    struct error ignored = {""};
    json_t *json = NULL;
    int status = cut(study, &mesh, &strips);
    for (int32_t s = 0; status == 0 && s < strips.strip_count; s++)
        status = scene_add_strip(&scene, strips.positions + 3 * (size_t)strips.first_vertex[s],
                                 strips.first_vertex[s + 1] - strips.first_vertex[s], &ignored);
    if (status == 0)
        json = scene_to_json(&scene);
    if (json) {
        char subtitle[120];
        snprintf(subtitle, sizeof subtitle, "%d triangles in %d strips, %.1f triangles each",
                 mesh.triangle_count, strips.strip_count,
                 (double)mesh.triangle_count / strips.strip_count);
        json_object_set_new(json, "title", json_string("The strips of a model"));
        json_object_set_new(json, "subtitle", json_string(subtitle));
    }
    scene_release(&scene);
    strips_release(&strips);
    mesh_release(&mesh);
    return json;
}

static void finding(const struct study *study, FILE *to)
{
    struct mesh mesh = {0};
    struct strips strips = {0};
    if (cut(study, &mesh, &strips) == 0)
        fprintf(to,
                "Strips. %d triangles cut into %d strips take %d vertices: %.2f a triangle, where "
                "one long strip would take 1 and isolated triangles take 3.",
                mesh.triangle_count, strips.strip_count, strips.vertex_count,
                (double)strips.vertex_count / mesh.triangle_count);
    strips_release(&strips);
    mesh_release(&mesh);
}

const struct figure lesson_strips = {.name = "model-strips",
                                     .label = "The strips of a model in turn colours",
                                     .width = 1200,
                                     .height = 900,
                                     .scene = scene,
                                     .finding = finding,
                                     .absent = "the model could not be read"};
