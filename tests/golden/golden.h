/* What the makers of golden scenes share. The meshes are made by formula, so that a golden picture
 * changes only when the renderer does. */
#ifndef TESTS_GOLDEN_GOLDEN_H
#define TESTS_GOLDEN_GOLDEN_H

#include "graders/scene/scene.h"

enum { PICTURE_WIDTH = 480, PICTURE_HEIGHT = 360 };

extern const double pi;

struct golden {
    const char *folder;
    json_t *pictures;
};

void stop(const char *what);
void must(int result, const struct error *err);
void write_json(const struct golden *golden, const char *name, const json_t *json);
/* Adds what the engine adds, writes the scene, notes the picture, and releases the scene. */
void finish(struct golden *golden, struct scene *scene, const char *name, const char *title,
            const char *subtitle);
struct mesh new_mesh(int64_t vertices, int64_t triangles);
void set_vertex(struct mesh *mesh, int32_t v, double x, double y, double z);
void set_triangle(struct mesh *mesh, int32_t t, int32_t a, int32_t b, int32_t c);
/* Vertex (i, j) is i * n + j: i around the hole, j around the tube. */
struct mesh torus(int32_t m, int32_t n);
/* m rows of n cells over the unit square, gently waved; vertex (row, column) is row * (n + 1) +
 * column. */
struct mesh sheet(int32_t m, int32_t n, double wave);
/* Poles 0 and 1, then `rows` rows of n vertices. */
struct mesh sphere(int32_t n, int32_t rows);
/* Puts the mesh into the scene and releases it. */
void put_mesh(struct scene *scene, struct mesh *mesh);

/* The scenes of marked.c: arrows, paths, polygons and numbers. */
void marked_scenes(struct golden *golden);

#endif
