/* Polygons in space: the triangles that fill one, concave or not. */
#ifndef GRADERS_SCENE_POLYGON_H
#define GRADERS_SCENE_POLYGON_H

#include "graders/scene/scene.h"

/* Fills a polygon of n >= 3 corners with n - 2 triangles, wound as it is, by cutting ears; where no
 * ear is found (corners that repeat, a polygon that crosses itself) as a fan. Corners are vertices
 * with positions; triangles gets 3 * (n - 2) entries; rest has room for n numbers.
 *
 * cost     quadratic in the corners, but linear where the polygon is convex or has more than 2000
 * source   G. H. Meisters, Polygons have ears, American Mathematical Monthly 82 (1975) */
void polygon_triangles(const float *positions, const int32_t *corners, int32_t n, int32_t *rest,
                       int32_t *triangles);

/* Whether the tables describe faces of at least three corners, all of them vertices; names the
 * first that is none. */
int polygons_check(const int32_t *first_corner, const int32_t *corners, int64_t face_count,
                   int64_t vertex_count, struct error *err) MUST_CHECK;

/* How many triangles of the scene's mesh belong to the faces before this one. */
int32_t scene_triangles_before(const struct scene_faces *faces, int32_t face);

void scene_faces_release(struct scene_faces *faces);

#endif
