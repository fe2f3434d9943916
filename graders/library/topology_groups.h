/* What hangs together: the second half of topology_build (topology.h). */
#ifndef GRADERS_LIBRARY_TOPOLOGY_GROUPS_H
#define GRADERS_LIBRARY_TOPOLOGY_GROUPS_H

#include "graders/library/topology.h"

/* Finds components, patches, orientability, fans and boundary loops.
 *
 * t           with its corners, vertices and edges
 * of_corner   the index (t->vertices) of each corner's vertex, where its face is not broken
 * returns     0, or -1 and *err (out of memory); then t is still to be released */
int topology_join_groups(struct face_topology *t, const int32_t *of_corner,
                         struct error *err) MUST_CHECK;

#endif
