/* A scene: what a picture of a case shows. The judge fills it, the engine stores it as JSON, and
 * both the renderer (PNG) and the page (interactive view) draw from that.
 *
 * Meshes are copied into the scene; everything is released by scene_release. */
#ifndef GRADERS_SCENE_SCENE_H
#define GRADERS_SCENE_SCENE_H

#include "graders/scene/values.h"
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

/* Polygons over a mesh that holds their triangles, a polygon of n corners n - 2 of them, in order.
 */
struct scene_faces {
    int32_t *first_corner; /* count + 1: face f has corners first_corner[f] ... */
    int32_t *corners;      /* vertices of the mesh */
    int32_t count;         /* 0: the mesh is one of triangles */
};

enum { SCENE_CURVE_LIMIT = 6, SCENE_FACT_LIMIT = 4 };

struct scene {
    enum scene_kind kind;
    struct mesh mesh; /* MESH: the mesh; VOXELS: the mesh beside; STRIPS: what the marks name */
    struct scene_faces faces;
    struct mark *marks; /* at most SCENE_MARK_LIMIT are kept; mark_count[] counts all */
    int kept_mark_count;
    int64_t mark_count[MARK_KINDS];
    uint32_t sampling[MARK_KINDS]; /* of a kind one in 2^sampling is kept */
    struct label *labels;
    int label_count;
    int64_t listed_vertex_count;                         /* in the lists of marks and labels */
    struct scene_text mark_names[MARK_KINDS], turn_name; /* empty: the usual word */
    int64_t turn_count;
    struct scene_values values;
    uint8_t *groups; /* a triangle's turn colour or SCENE_NO_GROUP; NULL: none */
    struct scene_vectors vectors[SCENE_VECTORS_LIMIT];
    int vector_set_count;
    struct scene *answer; /* shown beside; NULL: none. It has only what a mesh has */
    int64_t ok_count;     /* elements that are right, for the legend; 0 or less: not said */
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
/* A mesh of polygons, drawn without diagonals, concave ones too. Face f has the corners
 * corners[first_corner[f]] ... corners[first_corner[f + 1] - 1], three or more; first_corner has
 * face_count + 1 entries. What is no such table is refused: show_polygons takes it as well. */
int scene_set_polygons(struct scene *scene, const float *positions, int64_t vertex_count,
                       const int32_t *first_corner, const int32_t *corners, int64_t face_count,
                       struct error *err);

/* The answer's mesh beside the input's: a scene of its own, of which the mesh, its marks, labels,
 * values and vectors are shown, under the word "answer". Made when first asked for; it belongs to
 * the scene. NULL and *err when out of memory.
 *
 *     struct scene *answer = scene_answer(scene, err);
 *     if (!answer || show_mesh(answer, positions, vertex_count, triangles, triangle_count, err))
 *         return -1;
 *     scene_mark_triangle(answer, MARK_EXTRA, a, b, c); */
struct scene *scene_answer(struct scene *scene, struct error *err);

/* The same for a mesh of triangles whose tables may hold anything (see show_mesh). */
int scene_set_answer_mesh(struct scene *scene, const float *positions, int64_t vertex_count,
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
/* The scene as JSON (format in graders/render/README.md), a new reference; NULL when out of memory.
 * Meshes above 100,000 triangles are cut to the 20,000 nearest to the marks, counted in steps along
 * edges; strips are cut after 300,000 vertices; voxels above 128 a side are sampled at 128. */
json_t *scene_to_json(const struct scene *scene);

void scene_release(struct scene *scene);

#endif
