/* What must be refused; see refusal.h. */
#include "graders/library/refusal.h"

static void number_faces(const struct face_topology *t, int64_t edge, struct scene *scene)
{
    for (int64_t i = 0; i < topology_side_count(&t->edges[edge]); i++) {
        int64_t count, face = topology_edge_face(t, edge, i),
                       first = topology_face(t, face, &count);
        scene_label_face(scene, t->table.corners + first, count, face);
    }
}

static const char *refuse_edge(const struct face_topology *t, int64_t e, bool is_manifold,
                               struct message *why, struct scene *scene)
{
    const struct face_edge *edge = &t->edges[e];
    scene_mark_edge(scene, MARK_WRONG, edge->low, edge->high);
    number_faces(t, e, scene);
    if (!is_manifold)
        message_say(why, "%d faces share the edge (%d,%d)", "%d caras comparten la arista (%d,%d)",
                    (int)topology_side_count(edge), edge->low, edge->high);
    else
        message_say(why, "faces %d and %d run the edge (%d,%d) the same way",
                    "las caras %d y %d recorren la arista (%d,%d) en el mismo sentido",
                    topology_edge_face(t, e, 0), topology_edge_face(t, e, 1), edge->low,
                    edge->high);
    return is_manifold ? "NOT_ORIENTABLE" : "NOT_MANIFOLD";
}

/* Numbers the faces at a vertex of several fans. */
static const char *refuse_vertex(const struct face_topology *t, const struct face_vertex *vertex,
                                 struct message *why, struct scene *scene)
{
    scene_mark_vertex(scene, MARK_WRONG, vertex->vertex);
    for (int64_t c = 0; c < t->table.corner_count; c++)
        if (t->table.corners[c] == vertex->vertex && t->corner_face[c] >= 0) {
            int64_t count, first = topology_face(t, t->corner_face[c], &count);
            scene_label_face(scene, t->table.corners + first, count, t->corner_face[c]);
        }
    message_say(why, "the faces at vertex %d are %d fans, not one",
                "las caras del vértice %d forman %d abanicos, no uno", vertex->vertex,
                vertex->fan_count);
    return "NOT_MANIFOLD";
}

const char *refusal_of(const struct face_topology *t, struct message *why, struct scene *scene)
{
    *why = (struct message){0};
    if (t->nonmanifold_edge.count > 0)
        return refuse_edge(t, t->nonmanifold_edge.first, false, why, scene);
    if (t->nonmanifold_vertex.count > 0)
        return refuse_vertex(t, &t->vertices[t->nonmanifold_vertex.first], why, scene);
    if (t->incoherent.count > 0)
        return refuse_edge(t, t->incoherent.first, true, why, scene);
    return NULL;
}
