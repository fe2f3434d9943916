/* Triangle meshes in packets: what an exercise that takes an indexed mesh gets.
 *
 *     int vertex_count, int triangle_count, int has_positions,
 *     float positions[3V] (when it has them), int32 triangles[3F]
 *
 * Then stands what the exercise gives beside the mesh. */
#ifndef GRADERS_LIBRARY_MESH_INPUT_H
#define GRADERS_LIBRARY_MESH_INPUT_H

#include "graders/scene/scene.h"
#include "graders/wire/packet.h"

/* A mesh in a packet, in place. */
struct mesh_view {
    const float *positions; /* NULL: the packet carries none */
    const int32_t *triangles;
    int32_t vertex_count;
    int32_t triangle_count;
};

/* Writes a mesh. Returns 0, or -1 and *err when memory ran out. */
int mesh_input_write(const struct mesh *mesh, bool with_positions, struct writer *input,
                     struct error *err) MUST_CHECK;

/* Reads what mesh_input_write wrote; borrowed from the packet. */
struct mesh_view mesh_input_read(struct reader *input);

/* The same triangles as a soup, nine floats each, no vertex shared: what is welded and counted.
 *
 *     int triangle_count, float corners[9F] */
int soup_input_write(const struct mesh *mesh, struct writer *input, struct error *err) MUST_CHECK;

struct soup_view {
    const float *corners;
    int32_t triangle_count;
};
struct soup_view soup_input_read(struct reader *input);

/* A mesh as a view of it; borrowed. */
struct mesh_view mesh_input_view(const struct mesh *mesh);

/* Makes the mesh of a scene; a mesh without positions shows nothing. Returns 0, or -1 and *err. */
int mesh_input_show(const struct mesh_view *view, struct scene *scene,
                    struct error *err) MUST_CHECK;

#endif
