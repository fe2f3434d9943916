/* What the two spheres of problem 4.1 take, as voxels (voxels.h) and as a mesh (sphere.h), and what
 * books do otherwise at the poles and the seam: a student who did that is told so.
 *
 * Formulas have one parameter, k; the second is 0. */
#ifndef GRADERS_LIBRARY_SPHERE_SIZES_H
#define GRADERS_LIBRARY_SPHERE_SIZES_H

#include "graders/library/mistakes.h"

int64_t sphere_voxel_bytes(int64_t k, int64_t unused);
int64_t sphere_mesh_bytes(int64_t k, int64_t unused);

/* Mistakes in these formulas. */
extern const struct formula_mistake sphere_voxel_mistakes[], sphere_mesh_mistakes[];

/* Counts of builders. */
extern const struct built_count sphere_byte_count, sphere_vertex_count, sphere_triangle_count;

/* clang-format off */

/* The same mistakes for other tables; value: a function or a number. */
#define MISTAKE_BYTE_A_CELL(value) \
    MISTAKE(CAUSE_BYTE_A_CELL, value, "A cell takes a bit, not a byte.", \
            "Una celda ocupa un bit, no un byte.")
#define MISTAKE_CLOSED_GRID(value) \
    MISTAKE(CAUSE("closed-grid", "closed grid", "rejilla cerrada"), value, \
            "That is with 2k^2 triangles: there are only k - 1 rows of cells between k parallels.", \
            "Eso es con 2k^2 triángulos: entre k paralelos solo hay k - 1 filas de celdas.")
#define MISTAKE_SHARED_POLES(value) \
    MISTAKE(CAUSE("shared-poles", "shared poles", "polos compartidos"), value, \
            "That is with one vertex at each pole; here each pole belongs to all k meridians.", \
            "Eso es con un vértice en cada polo; aquí cada polo pertenece a los k meridianos.")
#define MISTAKE_REPLICATED_SEAM(value) \
    MISTAKE(CAUSE("replicated-seam", "replicated seam", "costura duplicada"), value, \
            "That is with k - 1 cells around; here the last meridian is joined to the first, k cells.", \
            "Eso es con k - 1 celdas alrededor; aquí el último meridiano se une al primero: k celdas.")
#define MISTAKE_NO_FLAT_TRIANGLES(value) \
    MISTAKE(CAUSE("no-flat-triangles", "flat triangles left out", "sin los triángulos planos"), value, \
            "That is without the triangles at the poles that have no area; here they stay.", \
            "Eso es sin los triángulos de los polos que no tienen área; aquí se quedan.")

/* clang-format on */

#endif
