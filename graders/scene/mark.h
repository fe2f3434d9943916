/* Marks and labels: what a picture of a mesh points at. Each is given by vertices of the scene's
 * mesh, so that it stays right when the picture shows a part of the mesh only.
 *
 *     static const struct phrase loops = {"loops found", "bucles hallados"};
 *
 *     scene_mark_path(scene, MARK_WRONG, loop, count, true);          named by the verdict: first
 *     for (int64_t l = 0; l < loop_count; l++)
 *         scene_mark_path(scene, mark_turn(l), loops[l].vertices, loops[l].count, true);
 *     scene_name_turns(scene, loops, loop_count);
 *
 * Numbers of vertices may be anything: a mark that names no vertex of the mesh is counted and not
 * drawn. The first mark of a scene is what the verdict names: pictures magnify it and turn it to
 * the eye. When there are more marks than are kept, those of the most frequent kind are thinned
 * out, evenly over the order in which they come and always in the same way; the first of each kind
 * stays. */
#ifndef GRADERS_SCENE_MARK_H
#define GRADERS_SCENE_MARK_H

#include "reference/base/phrase.h"

#include <stdbool.h>
#include <stdint.h>

struct scene;

/* What is the matter with an element. The colours are the renderer's. */
enum mark_kind {
    MARK_MISSING,    /* it is in the mesh and not in the answer */
    MARK_DUPLICATE,  /* it is in the answer more than once */
    MARK_EXTRA,      /* it is in the answer and not in the mesh */
    MARK_DEGENERATE, /* a triangle without area, or an edge from a vertex to itself */
    MARK_BOUNDARY,   /* no fault: a boundary edge, shown where it explains one */
    MARK_FLIPPED,    /* a triangle with the wrong winding */
    MARK_WRONG,      /* any other element at fault */
    MARK_RIGHT,      /* no fault: what should stand in the place of a wrong one */
    MARK_TURN_0,     /* no fault: one of several things in turn colours; see mark_turn */
    MARK_TURN_LAST = MARK_TURN_0 + 5,
    MARK_KINDS
};

/* The kind that shows thing `number` of a row of loops, parts, fans or strips: neighbours in the
 * row differ in colour. Any number will do. */
static inline enum mark_kind mark_turn(int64_t number)
{
    const int64_t turns = MARK_TURN_LAST - MARK_TURN_0 + 1;
    return (enum mark_kind)(MARK_TURN_0 + (number % turns + turns) % turns);
}

enum element_kind {
    ELEMENT_VERTEX,
    ELEMENT_EDGE,
    ELEMENT_TRIANGLE,
    ELEMENT_ARROW,     /* from its first vertex to its second */
    ELEMENT_HALF_EDGE, /* the corners of a face; the half edge goes from the first to the second */
    ELEMENT_PATH,      /* from vertex to vertex */
    ELEMENT_LOOP,      /* a path back to its first vertex */
    ELEMENT_FACE,      /* a polygon */
    ELEMENT_KINDS
};

struct mark {
    enum mark_kind kind;
    enum element_kind element;
    int32_t count;     /* of its vertices */
    int32_t vertex[3]; /* its vertices when they are at most three, */
    int32_t *list;     /* else they are here, owned by the scene */
    int64_t ordinal;   /* marks of its kind before it */
};

/* The number of an element, written where it is seen. */
struct label {
    struct mark at; /* its kind is not used */
    int64_t number;
};

/* A text of a picture, copied. */
struct scene_text {
    char en[64], es[64];
};

enum {
    SCENE_MARK_LIMIT = 1200,
    SCENE_LABEL_LIMIT = 400,
    SCENE_PATH_LIMIT = 8192, /* vertices of a mark: longer paths are cut, longer faces not kept */
    SCENE_PATH_LIMIT_ALL = 1 << 16 /* of all marks and labels with more than three */
};

void scene_mark_vertex(struct scene *scene, enum mark_kind kind, int32_t vertex);
void scene_mark_edge(struct scene *scene, enum mark_kind kind, int32_t a, int32_t b);
void scene_mark_triangle(struct scene *scene, enum mark_kind kind, int32_t a, int32_t b, int32_t c);

/* An edge with its direction, from a to b. */
void scene_mark_arrow(struct scene *scene, enum mark_kind kind, int32_t a, int32_t b);

/* Side `side` of a face: an arrow from corners[side] to the corner after it (the first after the
 * last), drawn a little inside the face, so that the two half edges of an edge lie apart. */
void scene_mark_half_edge(struct scene *scene, enum mark_kind kind, const int32_t *corners,
                          int64_t count, int64_t side);

/* A path from vertex to vertex, with arrow heads along it; closed: and back to the first. Its steps
 * need not be edges of the mesh. */
void scene_mark_path(struct scene *scene, enum mark_kind kind, const int32_t *vertices,
                     int64_t count, bool closed);

/* A polygon with three corners or more. */
void scene_mark_face(struct scene *scene, enum mark_kind kind, const int32_t *corners,
                     int64_t count);

/* Numbers as the message names them ("edge 0", "face 2"): those of vertices stand plain, of edges
 * in a box, of faces in a circle, and the legend says so. Pictures of small meshes, and of the
 * first mark, number the vertices by themselves. At most SCENE_LABEL_LIMIT; later ones are dropped,
 * and so are those that name no vertex of the mesh. */
void scene_label_vertex(struct scene *scene, int32_t vertex, int64_t number);
void scene_label_edge(struct scene *scene, int32_t a, int32_t b, int64_t number);
void scene_label_face(struct scene *scene, const int32_t *corners, int64_t count, int64_t number);

/* What the legend of this scene calls the marks of a kind, where the usual word ("wrong") says too
 * little: "next edge of the answer". */
void scene_name_marks(struct scene *scene, enum mark_kind kind, struct phrase name);

/* What the legend calls the things in turn colours, and how many there are in all: one entry for
 * all turn colours without a name of their own. */
void scene_name_turns(struct scene *scene, struct phrase name, int64_t count);

/* Copies a text, cut where it is too long. */
void scene_set_text(struct scene_text *text, struct phrase phrase);

/* The vertices of a mark. */
const int32_t *mark_vertices(const struct mark *mark);

#endif
