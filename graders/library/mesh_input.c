/* Triangle meshes in packets; see mesh_input.h. */
#include "graders/library/mesh_input.h"

#include <string.h>

enum { SOUP_BLOCK = 64 }; /* an even number: blocks then need no padding between them */

int mesh_input_write(const struct mesh *mesh, bool with_positions, struct writer *input,
                     struct error *err)
{
    write_int(input, mesh->vertex_count);
    write_int(input, mesh->triangle_count);
    write_int(input, with_positions);
    if (with_positions)
        write_array(input, mesh->positions, mesh->vertex_count, 3 * sizeof(float));
    write_array(input, mesh->triangles, mesh->triangle_count, 3 * sizeof(int32_t));
    if (input->failed)
        return error_set(err, "out of memory: writing a mesh of %d triangles",
                         mesh->triangle_count);
    return 0;
}

struct mesh_view mesh_input_read(struct reader *input)
{
    struct mesh_view view = {0};
    view.vertex_count = (int32_t)read_int(input);
    view.triangle_count = (int32_t)read_int(input);
    if (read_int(input))
        view.positions = read_array(input, view.vertex_count, 3 * sizeof(float));
    view.triangles = read_array(input, view.triangle_count, 3 * sizeof(int32_t));
    return view;
}

int soup_input_write(const struct mesh *mesh, struct writer *input, struct error *err)
{
    write_int(input, mesh->triangle_count);
    for (int64_t i = 0; i < 3 * (int64_t)mesh->triangle_count; i += 3 * SOUP_BLOCK) {
        float corners[9 * SOUP_BLOCK];
        int64_t left = 3 * (int64_t)mesh->triangle_count - i;
        int64_t count = left < 3 * SOUP_BLOCK ? left : 3 * SOUP_BLOCK;
        for (int64_t k = 0; k < count; k++)
            memcpy(corners + 3 * k, mesh->positions + 3 * (int64_t)mesh->triangles[i + k],
                   3 * sizeof *corners);
        write_array(input, corners, count, 3 * sizeof *corners);
    }
    return input->failed ? error_set(err, "out of memory for a soup") : 0;
}

struct soup_view soup_input_read(struct reader *input)
{
    struct soup_view view = {0};
    view.triangle_count = (int32_t)read_int(input);
    view.corners = read_array(input, view.triangle_count, 9 * sizeof(float));
    return view;
}

struct mesh_view mesh_input_view(const struct mesh *mesh)
{
    return (struct mesh_view){mesh->positions, mesh->triangles, mesh->vertex_count,
                              mesh->triangle_count};
}

int mesh_input_show(const struct mesh_view *view, struct scene *scene, struct error *err)
{
    if (!view->positions)
        return 0;
    return scene_set_mesh(scene, view->positions, view->vertex_count, view->triangles,
                          view->triangle_count, err);
}
