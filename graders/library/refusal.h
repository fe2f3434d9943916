/* Faces that a connected structure (winged edges, half edges) cannot hold, and why.
 *
 *     struct message why;
 *     const char *wanted = refusal_of(&topology, &why, &out->scene);
 *     if (answer_refuses_rightly(task->judge->answer, &task->answer, wanted, &why, out))
 *         ... it answered and should: look at its tables ... */
#ifndef GRADERS_LIBRARY_REFUSAL_H
#define GRADERS_LIBRARY_REFUSAL_H

#include "graders/library/topology.h"
#include "graders/scene/scene.h"
#include "reference/base/phrase.h"

/* The refusal that is right: "NOT_MANIFOLD" for an edge of more than two faces or a vertex of more
 * than one fan, "NOT_ORIENTABLE" for an edge that two faces run the same way. Sets `why`, and marks
 * the edge or vertex in the scene, with the numbers of its faces. NULL: nothing must be refused. */
const char *refusal_of(const struct face_topology *t, struct message *why, struct scene *scene);

#endif
