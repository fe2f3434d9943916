/* Triangle meshes in packets; see mesh_input.h. */
#include "graders/library/mesh_input.h"

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
