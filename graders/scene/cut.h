/* The neighbourhood of a scene's marks: what is kept of a mesh that is too big to be shown whole.
 */
#ifndef GRADERS_SCENE_CUT_H
#define GRADERS_SCENE_CUT_H

#include "graders/scene/scene.h"

enum {
    SCENE_TRIANGLE_LIMIT = 100000, /* meshes above this are cut, */
    SCENE_VERTEX_LIMIT = 300000,   /* and so are meshes with more vertices than this */
    SCENE_CUT_TRIANGLES = 20000    /* and have at most so many triangles afterwards */
};

/* Whether the scene's mesh is too big to be shown whole. */
bool scene_needs_cut(const struct scene *scene);

/* Makes the mesh of the SCENE_CUT_TRIANGLES triangles nearest to the marked vertices, counted in
 * steps along edges and in the order of the tables (from the first triangle when nothing is
 * marked).
 *
 * to       starts zeroed; gets the cut mesh and the marks, renumbered; every mark that named
 * vertices of the mesh is kept. The caller owns it (scene_release). returns  0, or -1 and *err (out
 * of memory) Linear in the mesh; 13 bytes a triangle and 12 a vertex while it runs. */
int scene_cut(const struct scene *from, struct scene *to, struct error *err) MUST_CHECK;

/* Whether all vertices of a mark are in the scene's mesh. */
bool scene_mark_fits(const struct scene *scene, const struct mark *mark);

#endif
