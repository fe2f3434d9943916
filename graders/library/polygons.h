/* Meshes of polygons as inputs: made from recipes, written as packets, read back.
 *
 *     int vertex_count, int face_count, int32 first_corner[F + 1], int32 corners[C],
 *     float positions[3V] (for pictures; the runner leaves them alone)
 *
 * Every shape of recipe.h can be made: what is no shape of polygons becomes a mesh of triangles. */
#ifndef GRADERS_LIBRARY_POLYGONS_H
#define GRADERS_LIBRARY_POLYGONS_H

#include "graders/library/families.h"
#include "graders/scene/scene.h"
#include "graders/wire/packet.h"

/* Face f has the corners corners[first_corner[f]] ... corners[first_corner[f + 1] - 1],
 * counter-clockwise seen from outside. */
struct polygon_mesh {
    float *positions;
    int32_t *first_corner; /* face_count + 1 */
    int32_t *corners;
    int32_t vertex_count, face_count;
};

/* The same in a packet, in place. */
struct polygon_view {
    const float *positions;
    const int32_t *first_corner, *corners;
    int32_t vertex_count, face_count;
};

/* Makes the mesh of a recipe. All changes of order work (FLIPPED, REVERSED, SCRAMBLED,
 * HIGH_NUMBERS), and WITH_COMPONENTS, WITH_ISOLATED; the others only for shapes of triangles.
 *
 * mesh      on success the caller owns it (polygon_mesh_release)
 * returns   0, or -1 and *err */
int polygon_mesh_make(const struct mesh_recipe *recipe, uint64_t seed, const char *models,
                      struct polygon_mesh *mesh, struct error *err) MUST_CHECK;

/* A size of a family: of triangles, 3 corners each, or of quads; `corner_count` is rounded down to
 * what closes. */
int polygon_mesh_make_sized(const struct size_family *family, int64_t corner_count, uint64_t seed,
                            struct polygon_mesh *mesh, struct error *err) MUST_CHECK;

void polygon_mesh_release(struct polygon_mesh *mesh);

int polygon_mesh_write(const struct polygon_mesh *mesh, struct writer *input,
                       struct error *err) MUST_CHECK;
struct polygon_view polygon_view_read(struct reader *input);

static inline int64_t polygon_view_corner_count(const struct polygon_view *view)
{
    return view->face_count > 0 ? view->first_corner[view->face_count] : 0;
}

/* Corners of a face, and how many it has. */
static inline const int32_t *polygon_view_face(const struct polygon_view *view, int32_t face,
                                               int32_t *corner_count)
{
    *corner_count = view->first_corner[face + 1] - view->first_corner[face];
    return view->corners + view->first_corner[face];
}

/* Puts the faces into a scene. Returns 0, or -1 and *err. */
int polygon_view_show(const struct polygon_view *view, struct scene *scene,
                      struct error *err) MUST_CHECK;

#endif
