/* Filling a scene; see scene.h. */
#include "graders/scene/polygon.h"
#include "graders/scene/show.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { VOXELS_PER_SIDE_LIMIT = 2048 };

static void raise_kind(struct scene *scene, enum scene_kind kind)
{
    if (kind > scene->kind)
        scene->kind = kind;
}

static int check_positions(const float *positions, int64_t vertex_count, struct error *err)
{
    for (int64_t i = 0; i < 3 * vertex_count; i++)
        if (!isfinite(positions[i]))
            return error_set(err, "vertex %lld of a scene is not finite", (long long)(i / 3));
    return 0;
}

static int check_triangles(const int32_t *triangles, int64_t triangle_count, int64_t vertex_count,
                           struct error *err)
{
    for (int64_t i = 0; i < 3 * triangle_count; i++)
        if (triangles[i] < 0 || triangles[i] >= vertex_count)
            return error_set(err, "triangle %lld of a scene names vertex %d of %lld",
                             (long long)(i / 3), triangles[i], (long long)vertex_count);
    return 0;
}

int scene_set_mesh(struct scene *scene, const float *positions, int64_t vertex_count,
                   const int32_t *triangles, int64_t triangle_count, struct error *err)
{
    struct mesh copy;
    if (mesh_init(&copy, vertex_count, triangle_count, err))
        return -1;
    if (check_positions(positions, vertex_count, err) ||
        check_triangles(triangles, triangle_count, vertex_count, err)) {
        mesh_release(&copy);
        return -1;
    }
    if (vertex_count > 0)
        memcpy(copy.positions, positions, 3 * sizeof *positions * (size_t)vertex_count);
    if (triangle_count > 0)
        memcpy(copy.triangles, triangles, 3 * sizeof *triangles * (size_t)triangle_count);
    mesh_release(&scene->mesh);
    scene_faces_release(&scene->faces);
    scene_drop_values(scene);
    scene->mesh = copy;
    raise_kind(scene, SCENE_MESH);
    return 0;
}

struct scene *scene_answer(struct scene *scene, struct error *err)
{
    if (!scene->answer)
        scene->answer = calloc(1, sizeof *scene->answer);
    if (scene->answer) {
        scene->answer->kind = SCENE_MESH;
        raise_kind(scene, SCENE_MESH);
    } else
        error_set(err, "out of memory for the answer of a scene");
    return scene->answer;
}

int scene_set_answer_mesh(struct scene *scene, const float *positions, int64_t vertex_count,
                          const int32_t *triangles, int64_t triangle_count, struct error *err)
{
    struct scene *answer = scene_answer(scene, err);
    return answer ? show_mesh(answer, positions, vertex_count, triangles, triangle_count, err) : -1;
}

int scene_add_strip(struct scene *scene, const float *positions, int64_t vertex_count,
                    struct error *err)
{
    if (vertex_count < 0 || vertex_count > INT32_MAX / 3)
        return error_set(err, "a strip of a scene has %lld vertices", (long long)vertex_count);
    if (check_positions(positions, vertex_count, err))
        return -1;
    struct strip *grown =
        realloc(scene->strips, ((size_t)scene->strip_count + 1) * sizeof *scene->strips);
    if (!grown)
        return error_set(err, "out of memory for the strips of a scene");
    scene->strips = grown;
    size_t bytes = 3 * sizeof *positions * (size_t)vertex_count;
    float *copy = malloc(bytes ? bytes : 1);
    if (!copy)
        return error_set(err, "out of memory for a strip of a scene");
    if (bytes)
        memcpy(copy, positions, bytes);
    scene->strips[scene->strip_count++] =
        (struct strip){.positions = copy, .vertex_count = (int32_t)vertex_count};
    raise_kind(scene, SCENE_STRIPS);
    return 0;
}

int scene_set_voxels(struct scene *scene, const uint8_t *bits, int32_t voxels_per_side,
                     struct error *err)
{
    if (voxels_per_side < 1 || voxels_per_side > VOXELS_PER_SIDE_LIMIT)
        return error_set(err, "%d voxels a side cannot be shown (1 to %d can)", voxels_per_side,
                         VOXELS_PER_SIDE_LIMIT);
    size_t side = (size_t)voxels_per_side;
    size_t bytes = (side * side * side + 7) / 8;
    uint8_t *copy = malloc(bytes);
    if (!copy)
        return error_set(err, "out of memory for %d voxels a side", voxels_per_side);
    memcpy(copy, bits, bytes);
    free(scene->voxel_bits);
    scene->voxel_bits = copy;
    scene->voxels_per_side = voxels_per_side;
    raise_kind(scene, SCENE_VOXELS);
    return 0;
}

int scene_set_wrong_voxels(struct scene *scene, const uint8_t *wrong_bits, int64_t named,
                           struct error *err)
{
    size_t side = (size_t)scene->voxels_per_side;
    size_t bytes = (side * side * side + 7) / 8;
    uint8_t *copy = malloc(bytes + 1);
    if (!copy)
        return error_set(err, "out of memory for %d voxels a side", scene->voxels_per_side);
    memcpy(copy, wrong_bits, bytes);
    free(scene->wrong_voxel_bits);
    scene->wrong_voxel_bits = copy;
    scene->named_voxel = named + 1;
    return 0;
}

void scene_add_fact(struct scene *scene, const char *name, const char *value)
{
    if (scene->fact_count == SCENE_FACT_LIMIT)
        return;
    struct fact *fact = &scene->facts[scene->fact_count++];
    snprintf(fact->name, sizeof fact->name, "%s", name);
    snprintf(fact->value, sizeof fact->value, "%s", value);
}

static int check_curve(const double *x, const double *y, int point_count, struct error *err)
{
    if (point_count < 0)
        return error_set(err, "a curve has %d points", point_count);
    for (int i = 0; i < point_count; i++)
        if (!(x[i] > 0 && y[i] > 0 && isfinite(x[i]) && isfinite(y[i])))
            return error_set(err, "point %d of a curve, (%g, %g), has no place on logarithmic axes",
                             i, x[i], y[i]);
    return 0;
}

int scene_add_curve(struct scene *scene, const char *name, const double *x, const double *y,
                    int point_count, double exponent, struct error *err)
{
    if (scene->curve_count >= SCENE_CURVE_LIMIT)
        return error_set(err, "a scene has at most %d curves", SCENE_CURVE_LIMIT);
    if (check_curve(x, y, point_count, err))
        return -1;
    size_t bytes = sizeof *x * (size_t)point_count;
    struct curve curve = {.x = malloc(bytes ? bytes : 1),
                          .y = malloc(bytes ? bytes : 1),
                          .point_count = point_count,
                          .exponent = isfinite(exponent) ? exponent : 0};
    if (!curve.x || !curve.y) {
        free(curve.x);
        free(curve.y);
        return error_set(err, "out of memory for a curve of %d points", point_count);
    }
    if (bytes) {
        memcpy(curve.x, x, bytes);
        memcpy(curve.y, y, bytes);
    }
    snprintf(curve.name, sizeof curve.name, "%s", name);
    scene->curves[scene->curve_count++] = curve;
    raise_kind(scene, SCENE_CHART);
    return 0;
}

void scene_release(struct scene *scene)
{
    mesh_release(&scene->mesh);
    scene_faces_release(&scene->faces);
    scene_drop_values(scene);
    if (scene->answer)
        scene_release(scene->answer);
    free(scene->answer);
    for (int m = 0; m < scene->kept_mark_count; m++)
        free(scene->marks[m].list);
    free(scene->marks);
    for (int l = 0; l < scene->label_count; l++)
        free(scene->labels[l].at.list);
    free(scene->labels);
    for (int i = 0; i < scene->strip_count; i++)
        free(scene->strips[i].positions);
    free(scene->strips);
    free(scene->voxel_bits);
    free(scene->wrong_voxel_bits);
    for (int i = 0; i < scene->curve_count; i++) {
        free(scene->curves[i].x);
        free(scene->curves[i].y);
    }
    *scene = (struct scene){0};
}
