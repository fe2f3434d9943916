/* Showing what a student returned: tables that may hold anything become a scene that may be drawn.
 */
#ifndef GRADERS_SCENE_SHOW_H
#define GRADERS_SCENE_SHOW_H

#include "graders/scene/scene.h"

/* Puts a mesh into the scene as scene_set_mesh does, but leaves out triangles with an index out of
 * range and puts coordinates that are not finite, or are beyond 1000, to zero. Tables may be NULL
 * with a count of 0. Returns 0, or -1 and *err (out of memory). */
int show_mesh(struct scene *scene, const float *positions, int64_t vertex_count,
              const int32_t *triangles, int64_t triangle_count, struct error *err) MUST_CHECK;

/* The same for polygons as scene_set_polygons takes them, of any size: leaves out those with fewer
 * than three corners, with an index out of range, and all from the first whose entries of
 * first_corner are not in order within corner_count. */
int show_polygons(struct scene *scene, const float *positions, int64_t vertex_count,
                  const int32_t *first_corner, const int32_t *corners, int64_t corner_count,
                  int64_t face_count, struct error *err) MUST_CHECK;

/* The same for one strip more. */
int show_strip(struct scene *scene, const float *positions, int64_t vertex_count,
               struct error *err) MUST_CHECK;

/* Whether all three indices of a triangle are in [0, vertex_count). */
bool scene_triangle_in_range(const int32_t *triangle, int64_t vertex_count);

#endif
