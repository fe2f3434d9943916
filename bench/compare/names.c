/* Names of vertices and faces; see names.h. */
#include "bench/compare/names.h"

#include "bench/compare/answers.h"

#include <stdlib.h>

uint64_t names_triangle(const struct mesh *mesh, int32_t triangle)
{
    const int32_t *corners = mesh->triangles + 3 * (int64_t)triangle;
    uint64_t names[3];
    for (int k = 0; k < 3; k++)
        names[k] = answer_position_name(mesh->positions + 3 * (int64_t)corners[k]);
    return answer_triangle_name(names[0], names[1], names[2]);
}

static int number_vertices(struct names *names, const struct representation *kind, const void *self,
                           struct error *err)
{
    for (int32_t v = 0; v < names->mesh.vertex_count; v++) {
        names->points[v] = answer_position_name(names->mesh.positions + 3 * (int64_t)v);
        names->numbers[v] = v;
    }
    if (kind->vertex_names && kind->vertex_names(self, &names->mesh, names->numbers, err) != 0)
        return -1;
    for (int32_t v = 0; v < names->mesh.vertex_count; v++)
        names->vertices[names->numbers[v]] = names->points[v];
    for (int32_t f = 0; f < names->face_count; f++)
        names->faces[f] = names_triangle(&names->mesh, f);
    return 0;
}

int names_of(struct names *names, const struct representation *kind, const void *self,
             struct error *err)
{
    *names = (struct names){.vertex_count = kind->vertex_count(self),
                            .face_count = kind->face_count(self)};
    if (kind->to_mesh(self, &names->mesh, err) != 0)
        return -1;
    names->points = calloc((size_t)names->mesh.vertex_count + 1, sizeof *names->points);
    names->numbers = calloc((size_t)names->mesh.vertex_count + 1, sizeof *names->numbers);
    names->vertices = calloc((size_t)names->vertex_count + 1, sizeof *names->vertices);
    names->faces = calloc((size_t)names->face_count + 1, sizeof *names->faces);
    int result = names->points && names->numbers && names->vertices && names->faces
                     ? number_vertices(names, kind, self, err)
                     : error_set(err, "out of memory: names");
    if (result != 0)
        names_release(names);
    return result;
}

void names_release(struct names *names)
{
    mesh_release(&names->mesh);
    free(names->points);
    free(names->numbers);
    free(names->vertices);
    free(names->faces);
    *names = (struct names){0};
}

static int32_t find(const uint64_t *names, int32_t count, uint64_t name)
{
    for (int32_t i = 0; i < count; i++)
        if (names[i] == name)
            return i;
    return -1;
}

int32_t names_vertex(const struct names *names, uint64_t name)
{
    return find(names->vertices, names->vertex_count, name);
}

int32_t names_face(const struct names *names, uint64_t name)
{
    return find(names->faces, names->face_count, name);
}
