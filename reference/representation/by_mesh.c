/* Operations by way of an indexed mesh; see by_mesh.h. */
#include "reference/representation/by_mesh.h"

#include "reference/representation/by_faces.h"
#include "reference/representation/indexed_mesh.h"
#include "reference/representation/mesh_sweeps.h"
#include "reference/representation/triangle_sweeps.h"

#include <stdlib.h>
#include <string.h>

/* The mesh of a structure, and how the structure calls the mesh's vertices. */
struct view {
    const struct representation *kind;
    const void *self;
    struct mesh mesh;
    int32_t *names; /* NULL: the same numbers */
};

static void view_release(struct view *view)
{
    mesh_release(&view->mesh);
    free(view->names);
}

static int view_init(struct view *view, const struct representation *kind, const void *self,
                     struct error *err)
{
    *view = (struct view){.kind = kind, .self = self};
    if (kind->to_mesh(self, &view->mesh, err))
        return -1;
    if (!kind->vertex_names)
        return 0;
    view->names = malloc((size_t)view->mesh.vertex_count * sizeof *view->names + 1);
    int result = view->names
                     ? kind->vertex_names(self, &view->mesh, view->names, err)
                     : error_set(err, "out of memory: naming %d vertices", view->mesh.vertex_count);
    if (result)
        view_release(view);
    return result;
}

static int32_t name_of(const struct view *view, int32_t vertex)
{
    return view->names ? view->names[vertex] : vertex;
}

int lowest_corners(const struct representation *kind, const void *self, const struct mesh *mesh,
                   int32_t *names, struct error *err)
{
    (void)err;
    for (int64_t v = 0; v < mesh->vertex_count; v++)
        names[v] = INT32_MAX;
    for (int32_t f = 0; f < mesh->triangle_count; f++) {
        int32_t corners[3];
        kind->face_vertices(self, f, 1, corners);
        for (int i = 0; i < 3; i++) {
            int32_t *name = &names[mesh->triangles[3 * (int64_t)f + i]];
            if (corners[i] < *name)
                *name = corners[i];
        }
    }
    return 0;
}

int64_t by_mesh_edges(const struct representation *kind, const void *self, int32_t *pairs,
                      struct error *err)
{
    struct view view;
    if (view_init(&view, kind, self, err))
        return -1;
    int64_t count = mesh_edges(&view.mesh, pairs, err);
    for (int64_t e = 0; e < count; e++) {
        int32_t u = name_of(&view, pairs[2 * e]), v = name_of(&view, pairs[2 * e + 1]);
        pairs[2 * e] = u < v ? u : v;
        pairs[2 * e + 1] = u < v ? v : u;
    }
    view_release(&view);
    return count;
}

int32_t by_mesh_boundary_loops(const struct representation *kind, const void *self,
                               int32_t *vertices, int32_t *loop_starts, struct error *err)
{
    struct view view;
    if (view_init(&view, kind, self, err))
        return -1;
    int32_t count = mesh_boundary_loops(&view.mesh, vertices, loop_starts, err);
    for (int32_t i = 0; count > 0 && i < loop_starts[count]; i++)
        vertices[i] = name_of(&view, vertices[i]);
    view_release(&view);
    return count;
}

/* Copies three floats a vertex of the mesh to every number that the structure has for it. */
static void spread(const struct view *view, const float *of_mesh, float *of_self)
{
    for (int32_t f = 0; f < view->mesh.triangle_count; f++) {
        int32_t corners[3];
        view->kind->face_vertices(view->self, f, 1, corners);
        for (int i = 0; i < 3; i++) {
            int64_t vertex = view->mesh.triangles[3 * (int64_t)f + i];
            memcpy(of_self + 3 * (int64_t)corners[i], of_mesh + 3 * vertex, 3 * sizeof *of_self);
        }
    }
}

int by_mesh_vertex_normals(const struct representation *kind, const void *self, float *normals,
                           struct error *err)
{
    struct view view;
    if (view_init(&view, kind, self, err))
        return -1;
    float *welded = malloc(3 * (size_t)view.mesh.vertex_count * sizeof *welded + 1);
    if (welded) {
        mesh_vertex_normals(&view.mesh, welded);
        spread(&view, welded, normals);
    }
    view_release(&view);
    if (!welded)
        return error_set(err, "out of memory: normals of vertices");
    free(welded);
    return 0;
}

int by_mesh_smooth(const struct representation *kind, const void *self, float *positions,
                   struct error *err)
{
    struct view view;
    if (view_init(&view, kind, self, err))
        return -1;
    int result = mesh_smooth(&view.mesh, err);
    if (result == 0)
        spread(&view, view.mesh.positions, positions);
    view_release(&view);
    return result;
}

int32_t by_mesh_vertices_around(const struct representation *kind, const void *self,
                                const float *positions, int32_t vertex, int32_t *vertices,
                                int32_t capacity)
{
    struct view view;
    if (view_init(&view, kind, self, NULL))
        return -1;
    int32_t own = 0;
    while (!same_position(view.mesh.positions + 3 * (int64_t)own, positions + 3 * (int64_t)vertex))
        own++;
    int32_t count = faces_search_vertices_around(&representation_indexed_mesh, &view.mesh, own,
                                                 vertices, capacity);
    for (int32_t i = 0; i < count && i < capacity; i++)
        vertices[i] = name_of(&view, vertices[i]);
    view_release(&view);
    return count;
}
