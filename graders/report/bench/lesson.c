/* See lesson.h. */
#include "graders/report/bench/lesson.h"

#include "graders/scene/scene.h"
#include "reference/mesh/generate.h"

#include <math.h>

struct place lesson_vertex(const float *positions, int32_t vertex)
{
    const float *p = positions + 3 * (size_t)vertex;
    return (struct place){(double)p[0], (double)p[1], (double)p[2]};
}

struct place lesson_between(struct place a, struct place b, double t)
{
    return (struct place){a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

json_t *lesson_diagram(const struct mesh *mesh, const char *title, const char *subtitle)
{
    struct scene scene = {0};
    struct error ignored = {""};
    json_t *json = NULL;
    if (scene_set_mesh(&scene, mesh->positions, mesh->vertex_count, mesh->triangles,
                       mesh->triangle_count, &ignored) == 0)
        json = scene_to_json(&scene);
    scene_release(&scene);
    if (!json)
        return NULL;
    json_t *rest = json_pack("{s:s, s:s, s:s, s:{s:i, s:i}, s:[], s:[], s:[]}", "kind", "diagram",
                             "title", title, "subtitle", subtitle, "view", "azimuth_degrees", -90,
                             "elevation_degrees", 64, "faces", "arrows", "labels");
    json_object_update(json, rest);
    json_decref(rest);
    return json;
}

void lesson_face(json_t *scene, int32_t triangle, enum look look)
{
    json_array_append_new(json_object_get(scene, "faces"),
                          json_pack("{s:i, s:i}", "triangle", (int)triangle, "look", (int)look));
}

static json_t *coordinates(struct place at)
{
    return json_pack("[f, f, f]", at.x, at.y, at.z);
}

void lesson_arrow(json_t *scene, struct place from, struct place to, enum look look,
                  const char *label, bool dashed)
{
    json_array_append_new(json_object_get(scene, "arrows"),
                          json_pack("{s:o, s:o, s:i, s:s, s:b}", "from", coordinates(from), "to",
                                    coordinates(to), "look", (int)look, "label", label, "dashed",
                                    dashed));
}

void lesson_label(json_t *scene, struct place at, enum look look, const char *text)
{
    json_array_append_new(
        json_object_get(scene, "labels"),
        json_pack("{s:o, s:i, s:s}", "at", coordinates(at), "look", (int)look, "text", text));
}

int lesson_dome(struct mesh *mesh, int sectors)
{
    const float height = 0.35F, widened = 1.3F;
    const uint64_t seed = 5; /* such that edges run both ways */
    struct error ignored = {""};
    if (generate_disc(mesh, 2, sectors, &ignored) != 0)
        return -1;
    for (int32_t v = 1; v <= sectors; v++) /* the inner ring */
        for (int k = 0; k < 2; k++)
            mesh->positions[3 * (size_t)v + (size_t)k] *= widened;
    if (change_scramble(mesh, seed, &ignored) != 0) {
        mesh_release(mesh);
        return -1;
    }
    for (int32_t v = 0; v < mesh->vertex_count; v++) {
        float *p = mesh->positions + 3 * (size_t)v;
        p[2] = -height * (p[0] * p[0] + p[1] * p[1]);
    }
    return 0;
}

int32_t lesson_middle(const struct mesh *mesh)
{
    int32_t nearest = 0;
    float least = INFINITY;
    for (int32_t v = 0; v < mesh->vertex_count; v++) {
        const float *p = mesh->positions + 3 * (size_t)v;
        float distance = p[0] * p[0] + p[1] * p[1];
        if (distance < least) {
            least = distance;
            nearest = v;
        }
    }
    return nearest;
}
