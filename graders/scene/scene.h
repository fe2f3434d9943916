/* A scene: what a picture of a case shows. The judge fills it, the engine stores it as JSON, and
 * both the renderer (PNG) and the page (interactive view) draw from that.
 *
 * Meshes are copied into the scene; everything is released by scene_release. */
#ifndef GRADERS_SCENE_SCENE_H
#define GRADERS_SCENE_SCENE_H

#include "reference/base/error.h"
#include "reference/mesh/mesh.h"

#include <jansson.h>
#include <stdbool.h>
#include <stdint.h>

enum scene_kind {
    SCENE_NONE,   /* nothing to show (a wrong number, say) */
    SCENE_MESH,   /* a mesh with marks on its elements */
    SCENE_STRIPS, /* strips in turn colours, flipped triangles marked */
    SCENE_VOXELS, /* voxels beside a mesh */
    SCENE_CHART   /* curves, log-log */
};

/* What is the matter with an element. The colours are the renderer's. */
enum mark_kind {
    MARK_MISSING,    /* it is in the mesh and not in the answer */
    MARK_DUPLICATE,  /* it is in the answer more than once */
    MARK_EXTRA,      /* it is in the answer and not in the mesh */
    MARK_DEGENERATE, /* a triangle without area, or an edge from a vertex to itself */
    MARK_BOUNDARY,   /* no fault: a boundary edge, shown where it explains one */
    MARK_FLIPPED,    /* a triangle with the wrong winding */
    MARK_WRONG       /* any other element at fault */
};

enum element_kind { ELEMENT_VERTEX, ELEMENT_EDGE, ELEMENT_TRIANGLE };

struct mark {
    enum mark_kind kind;
    enum element_kind element;
    int32_t vertex[3]; /* indices into the scene's mesh: one, two or three are used */
    int64_t ordinal;   /* marks of its kind before it */
};

struct strip {
    float *positions; /* 3 * vertex_count: the strip's vertices in order */
    int32_t vertex_count;
};

struct curve {
    char name[48]; /* "submission", "reference", "voxels", ... */
    double *x;
    double *y; /* all positive: the axes are logarithmic */
    int point_count;
    double exponent; /* fitted growth, 0 when none was fitted */
};

/* A number that the legend tells: "expected" and "6", say. */
struct fact {
    char name[24], value[32];
};

enum { SCENE_MARK_LIMIT = 1200, SCENE_CURVE_LIMIT = 6, SCENE_FACT_LIMIT = 4 };

struct scene {
    enum scene_kind kind;
    struct mesh mesh;   /* MESH: the mesh; VOXELS: the mesh beside; STRIPS: what the marks name */
    struct mark *marks; /* at most SCENE_MARK_LIMIT are kept; mark_count[] counts all */
    int kept_mark_count;
    int64_t mark_count[MARK_WRONG + 1];
    uint32_t sampling[MARK_WRONG + 1]; /* of a kind one in 2^sampling is kept */
    int64_t ok_count; /* elements that are right, for the legend; 0 or less: not said */
    struct strip *strips;
    int strip_count;
    uint8_t
        *voxel_bits; /* k*k*k bits, cell (x,y,z) is bit number x + k * (y + k * z), low bit first */
    int32_t voxels_per_side;
    uint8_t *wrong_voxel_bits; /* the same cells: 1 where voxel_bits is wrong; NULL: not told */
    int64_t named_voxel;       /* number of the cell that the verdict names, plus 1; 0: none */
    struct curve curves[SCENE_CURVE_LIMIT];
    int curve_count;
    char x_label[48], y_label[48];
    struct fact facts[SCENE_FACT_LIMIT];
    int fact_count;
};

/* Each adds to a scene that starts zeroed and copies what it is given; on -1 (out of memory, an
 * index or a coordinate or a size that no picture can have) the scene is still valid, shows less,
 * and *err says why. The kind of the scene follows from what was added: curves before voxels before
 * strips before a mesh. Adding a mesh or voxels again replaces them; strips and curves are added
 * up. */
int scene_set_mesh(struct scene *scene, const float *positions, int64_t vertex_count,
                   const int32_t *triangles, int64_t triangle_count, struct error *err);
int scene_add_strip(struct scene *scene, const float *positions, int64_t vertex_count,
                    struct error *err);
int scene_set_voxels(struct scene *scene, const uint8_t *bits, int32_t voxels_per_side,
                     struct error *err);
/* Tells which cells of the voxels that were set are wrong, and which one the verdict names. */
int scene_set_wrong_voxels(struct scene *scene, const uint8_t *wrong_bits, int64_t named,
                           struct error *err);
/* Adds a number to the legend; texts that are too long are cut, facts above the limit dropped. */
void scene_add_fact(struct scene *scene, const char *name, const char *value);
int scene_add_curve(struct scene *scene, const char *name, const double *x, const double *y,
                    int point_count, double exponent, struct error *err);
/* Marks may come before or after the mesh; those that name no vertex of it are counted, not kept.
 *
 * The first mark of a scene is what the verdict names: pictures magnify it and turn it to the eye.
 * When there are more marks than are kept, those of the most frequent kind are thinned out, evenly
 * over the order in which they come and always in the same way; the first of each kind stays. */
void scene_mark_vertex(struct scene *scene, enum mark_kind kind, int32_t vertex);
void scene_mark_edge(struct scene *scene, enum mark_kind kind, int32_t a, int32_t b);
void scene_mark_triangle(struct scene *scene, enum mark_kind kind, int32_t a, int32_t b, int32_t c);

/* The scene as JSON (format in graders/render/README.md), a new reference; NULL when out of memory.
 * Meshes above 100,000 triangles are cut to the 20,000 nearest to the marks, counted in steps along
 * edges; strips are cut after 300,000 vertices; voxels above 128 a side are sampled at 128. */
json_t *scene_to_json(const struct scene *scene);

void scene_release(struct scene *scene);

#endif
