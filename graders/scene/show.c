/* Showing what a student returned; see show.h. */
#include "graders/scene/show.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

static const float FARTHEST = 1000;

bool scene_triangle_in_range(const int32_t *triangle, int64_t vertex_count)
{
    for (int i = 0; i < 3; i++)
        if (triangle[i] < 0 || triangle[i] >= vertex_count)
            return false;
    return true;
}

static float drawable(float coordinate)
{
    return fabsf(coordinate) <= FARTHEST ? coordinate : 0;
}

int show_mesh(struct scene *scene, const float *positions, int64_t vertex_count,
              const int32_t *triangles, int64_t triangle_count, struct error *err)
{
    struct mesh mesh;
    if (mesh_init(&mesh, vertex_count, triangle_count, err))
        return -1;
    for (int64_t i = 0; i < 3 * vertex_count; i++)
        mesh.positions[i] = drawable(positions[i]);
    int64_t kept = 0;
    for (int64_t t = 0; t < triangle_count; t++) {
        if (!scene_triangle_in_range(triangles + 3 * t, vertex_count))
            continue;
        for (int64_t i = 0; i < 3; i++)
            mesh.triangles[3 * kept + i] = triangles[3 * t + i];
        kept++;
    }
    int failed = scene_set_mesh(scene, mesh.positions, vertex_count, mesh.triangles, kept, err);
    mesh_release(&mesh);
    return failed;
}

static bool in_range(const int32_t *corners, int32_t count, int64_t vertex_count)
{
    for (int32_t i = 0; i < count; i++)
        if (corners[i] < 0 || corners[i] >= vertex_count)
            return false;
    return true;
}

/* Copies the faces that can be shown; returns their number. */
static int64_t copy_faces(const int32_t *first_corner, const int32_t *corners, int64_t corner_count,
                          int64_t face_count, int64_t vertex_count, int32_t *to_first, int32_t *to)
{
    int64_t kept = 0;
    int32_t filled = 0;
    for (int64_t f = 0; f < face_count; f++) {
        int32_t begin = first_corner[f], end = first_corner[f + 1];
        if (begin < 0 || end < begin || end > corner_count || end - begin > corner_count - filled)
            break;
        if (end - begin < 3 || !in_range(corners + begin, end - begin, vertex_count))
            continue;
        for (int32_t c = begin; c < end; c++)
            to[filled++] = corners[c];
        to_first[++kept] = filled;
    }
    return kept;
}

int show_polygons(struct scene *scene, const float *positions, int64_t vertex_count,
                  const int32_t *first_corner, const int32_t *corners, int64_t corner_count,
                  int64_t face_count, struct error *err)
{
    float *clean = malloc(3 * sizeof *clean * (size_t)vertex_count + 1);
    int32_t *firsts = calloc((size_t)face_count + 1, sizeof *firsts);
    int32_t *kept_corners = malloc(sizeof *kept_corners * (size_t)corner_count + 1);
    int failed = -1;
    if (!clean || !firsts || !kept_corners)
        error_set(err, "out of memory for %" PRId64 " polygons of a scene", face_count);
    else {
        for (int64_t i = 0; i < 3 * vertex_count; i++)
            clean[i] = drawable(positions[i]);
        int64_t kept = copy_faces(first_corner, corners, corner_count, face_count, vertex_count,
                                  firsts, kept_corners);
        failed = scene_set_polygons(scene, clean, vertex_count, firsts, kept_corners, kept, err);
    }
    free(clean);
    free(firsts);
    free(kept_corners);
    return failed;
}

int show_strip(struct scene *scene, const float *positions, int64_t vertex_count, struct error *err)
{
    float *clean = malloc(3 * sizeof *clean * (size_t)vertex_count + 1);
    if (!clean)
        return error_set(err, "out of memory for a strip of %" PRId64 " vertices", vertex_count);
    for (int64_t i = 0; i < 3 * vertex_count; i++)
        clean[i] = drawable(positions[i]);
    int failed = scene_add_strip(scene, clean, vertex_count, err);
    free(clean);
    return failed;
}
