/* Showing what a student returned; see show.h. */
#include "graders/scene/show.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

static const float FARTHEST = 1000;

bool triangle_in_range(const int32_t *triangle, int64_t vertex_count)
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
        if (!triangle_in_range(triangles + 3 * t, vertex_count))
            continue;
        for (int64_t i = 0; i < 3; i++)
            mesh.triangles[3 * kept + i] = triangles[3 * t + i];
        kept++;
    }
    int failed = scene_set_mesh(scene, mesh.positions, vertex_count, mesh.triangles, kept, err);
    mesh_release(&mesh);
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
