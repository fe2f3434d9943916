/* What tests ask of a mesh, computed in the plainest way. */
#ifndef TESTS_UNIT_MESH_MEASURES_H
#define TESTS_UNIT_MESH_MEASURES_H

#include "reference/mesh/mesh.h"

#include <stdbool.h>

/* Volume to the inner side of a closed mesh; positive when its normals point outwards. */
double signed_volume(const struct mesh *mesh);

/* A number that depends on the set of triangles (as positions, with their winding) and neither on
 * numbering nor order nor first corner: equal for equal surfaces, different for others but by a
 * chance of 2^-64. */
uint64_t surface_hash(const struct mesh *mesh);

/* Whether both have the same tables, bit for bit. */
bool same_mesh(const struct mesh *a, const struct mesh *b);

/* A mesh for property tests: kind and size follow from the seed; any topology, changed at random.
 * Aborts when memory runs out. The caller owns it. */
struct mesh random_mesh(uint64_t seed);

#endif
