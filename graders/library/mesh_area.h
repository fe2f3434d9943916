/* The area of a mesh for a judge: exact, and as the usual mistakes would compute it. */
#ifndef GRADERS_LIBRARY_MESH_AREA_H
#define GRADERS_LIBRARY_MESH_AREA_H

#include "graders/library/mesh_input.h"

/* Sums over all triangles. */
struct area_sums {
    double exact;         /* to 10^-9: see mesh_area_exact */
    double without_first; /* without the first triangle */
    double without_last;
    double squares;        /* half the squared length of the cross products: no square root */
    double by_float;       /* double areas added up in a float */
    double all_float;      /* everything in float */
    double absolute_float; /* a x b + b x c + c x a of the positions, in float */
    double seen_from_z;    /* of the projections onto the plane z = 0 */
    double facing_up;      /* of the triangles seen counter-clockwise from above */
    double vector;         /* length of the sum of the cross products, halved */
    int32_t first_flat;    /* the first triangle of area 0, -1: none */
};

/* The exact area only; the error is below 10^-9 of it, needles included. O(F). */
double mesh_area_exact(const struct mesh_view *view);

/* Which way a triangle faces, for pictures. */
enum area_facing { AREA_FLAT, AREA_UPWARDS, AREA_NOT_UPWARDS };
enum area_facing mesh_area_facing(const struct mesh_view *view, int32_t triangle);

/* All sums. */
struct area_sums mesh_area_sums(const struct mesh_view *view);

#endif
