/* Problem 4.6: the total area of an indexed triangle mesh. */
#ifndef MESH_AREA_H
#define MESH_AREA_H

#include <stdint.h>

/* What a function of these exercises returns when malloc, calloc or realloc gave NULL. */
enum { OUT_OF_MEMORY = -1 };

/* The sum of the areas of all triangles of a mesh, in the square of the unit of the positions.
 *
 * Every triangle counts with its area, which is never negative, however it is turned and wherever
 * it stands in the table. A triangle with a repeated vertex, or with its three vertices on a
 * line, has area 0. An empty mesh has area 0.
 *
 * vertices         vertex_count triples of coordinates: x y z of vertex 0, then of vertex 1, ...
 *                  All are finite. Cannot be written. Must not be followed when vertex_count is
 *                  0.
 * vertex_count     number of vertices, 0 or more
 * triangles        triangle_count triples of vertex numbers: triangle t joins triangles[3*t],
 *                  triangles[3*t+1] and triangles[3*t+2], each from 0 to vertex_count - 1. Cannot
 *                  be written. Must not be followed when triangle_count is 0.
 * triangle_count   number of triangles, 0 to some ten million
 *
 * returns          the area A, such that |A - exact area| <= 0.000001 * exact area, where the
 *                  exact area is that of the triangles between the given binary32 positions. It
 *                  needs no memory; a function that allocates and gets none returns
 *                  OUT_OF_MEMORY.
 * cost             time proportional to triangle_count */
double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count);

#endif
