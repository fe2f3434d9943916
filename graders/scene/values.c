/* Numbers, parts and vectors of a mesh; see values.h. */
#include "graders/scene/polygon.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int64_t face_count(const struct scene *scene)
{
    return scene->faces.count > 0 ? scene->faces.count : scene->mesh.triangle_count;
}

static int check_mesh(const struct scene *scene, struct error *err)
{
    if (scene->kind != SCENE_NONE) /* an empty mesh has no positions */
        return 0;
    return error_set(err, "a scene needs its mesh before what the mesh carries");
}

/* The triangles of a face: first ... end - 1. */
static void triangles_of_face(const struct scene *scene, int64_t face, int64_t *first, int64_t *end)
{
    bool polygons = scene->faces.count > 0;
    *first = polygons ? scene_triangles_before(&scene->faces, (int32_t)face) : face;
    *end = polygons ? scene_triangles_before(&scene->faces, (int32_t)face + 1) : face + 1;
}

/* The numbers as they are stored: one a vertex, or one a triangle. NULL: out of memory. */
static float *copy_numbers(const struct scene *scene, enum scene_part part, const float *values,
                           int64_t *count)
{
    *count = part == SCENE_PER_VERTEX ? scene->mesh.vertex_count : scene->mesh.triangle_count;
    float *numbers = malloc(((size_t)*count + 1) * sizeof *numbers);
    if (numbers && part == SCENE_PER_VERTEX && *count > 0)
        memcpy(numbers, values, (size_t)*count * sizeof *numbers);
    for (int64_t f = 0; numbers && part == SCENE_PER_FACE && f < face_count(scene); f++) {
        int64_t first, end;
        triangles_of_face(scene, f, &first, &end);
        for (int64_t t = first; t < end; t++)
            numbers[t] = values[f];
    }
    return numbers;
}

static void mark_worst(struct scene *scene, enum scene_part part, int64_t worst)
{
    static const struct phrase name = {"worst", "peor"};
    if (part == SCENE_PER_VERTEX)
        scene_mark_vertex(scene, MARK_WRONG, (int32_t)worst);
    else if (scene->faces.count > 0) {
        int32_t first = scene->faces.first_corner[worst];
        scene_mark_face(scene, MARK_WRONG, scene->faces.corners + first,
                        scene->faces.first_corner[worst + 1] - first);
    } else
        scene_mark_face(scene, MARK_WRONG, scene->mesh.triangles + 3 * worst, 3);
    if (!scene->mark_names[MARK_WRONG].en[0])
        scene_name_marks(scene, MARK_WRONG, name);
}

int scene_set_values(struct scene *scene, enum scene_part part, const float *values, double low,
                     double high, struct phrase unit, int64_t worst, struct error *err)
{
    struct scene_values *to = &scene->values;
    if (check_mesh(scene, err))
        return -1;
    if (!(isfinite(low) && isfinite(high) && low <= high))
        return error_set(err, "%g to %g is no scale of a scene: give finite ends, low <= high", low,
                         high);
    int64_t count,
        elements = part == SCENE_PER_VERTEX ? scene->mesh.vertex_count : face_count(scene);
    float *numbers = copy_numbers(scene, part, values, &count);
    if (!numbers)
        return error_set(err, "out of memory for the values of a scene");
    free(to->numbers);
    *to = (struct scene_values){.numbers = numbers,
                                .part = part,
                                .count = count,
                                .low = low,
                                .high = high,
                                .worst = (double)NAN};
    scene_set_text(&to->unit, unit);
    if (worst >= 0 && worst < elements) {
        to->worst = (double)values[worst];
        mark_worst(scene, part, worst);
    }
    return 0;
}

int scene_set_groups(struct scene *scene, const int32_t *group_of_face, struct error *err)
{
    if (check_mesh(scene, err))
        return -1;
    uint8_t *groups = malloc((size_t)scene->mesh.triangle_count + 1);
    if (!groups)
        return error_set(err, "out of memory for the parts of a scene");
    for (int64_t f = 0; f < face_count(scene); f++) {
        int32_t group = group_of_face[f];
        int64_t first, end;
        triangles_of_face(scene, f, &first, &end);
        for (int64_t t = first; t < end; t++)
            groups[t] = group < 0 ? SCENE_NO_GROUP : (uint8_t)(mark_turn(group) - MARK_TURN_0);
    }
    free(scene->groups);
    scene->groups = groups;
    return 0;
}

int scene_add_vectors(struct scene *scene, enum mark_kind kind, const float *vectors,
                      struct error *err)
{
    if (check_mesh(scene, err))
        return -1;
    if (scene->vector_set_count == SCENE_VECTORS_LIMIT)
        return error_set(err, "a scene has at most %d sets of vectors", SCENE_VECTORS_LIMIT);
    size_t count = 3 * (size_t)scene->mesh.vertex_count;
    float *xyz = malloc((count + 1) * sizeof *xyz);
    if (!xyz)
        return error_set(err, "out of memory for the vectors of a scene");
    if (count > 0)
        memcpy(xyz, vectors, count * sizeof *xyz);
    scene->vectors[scene->vector_set_count++] = (struct scene_vectors){kind, xyz};
    return 0;
}

void scene_drop_values(struct scene *scene)
{
    free(scene->values.numbers);
    scene->values = (struct scene_values){0};
    free(scene->groups);
    scene->groups = NULL;
    for (int i = 0; i < scene->vector_set_count; i++)
        free(scene->vectors[i].xyz);
    scene->vector_set_count = 0;
}
