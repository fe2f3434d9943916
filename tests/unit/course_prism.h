/* The worked example of course document 001: a prism of 6 vertices, 9 edges and 5 faces, as faces
 * and as the tables that the document derives from them. */
#ifndef TESTS_UNIT_COURSE_PRISM_H
#define TESTS_UNIT_COURSE_PRISM_H

#include "reference/representation/sides.h"

#include <stdint.h>

enum { PRISM_VERTICES = 6, PRISM_EDGES = 9, PRISM_FACES = 5, PRISM_HALF_EDGES = 18 };

extern const float prism_positions[3 * PRISM_VERTICES];

/* The faces in the order in which the document reads them; read i is its face prism_reading[i]. */
extern const struct polygons prism_polygons;
extern const int32_t prism_reading[PRISM_FACES];

/* Vi Vf Cd Ci Ada Ads Aia Ais. */
extern const int32_t prism_winged_edges[PRISM_EDGES][8];

/* One edge of each face and of each vertex, any of several. */
extern const int32_t prism_face_edge[PRISM_FACES];
extern const int32_t prism_vertex_edge[PRISM_VERTICES];

/* Vi Vf H C Aa As, the last two as the document writes them: numbers of edges. The second half of
 * edge e is half edge 9 + e. */
extern const int32_t prism_half_edges[PRISM_HALF_EDGES][6];

/* What Aa and As are when they number half edges, derived by hand from the cycles of the faces. */
extern const int32_t prism_half_edge_links[PRISM_HALF_EDGES][2];

#endif
