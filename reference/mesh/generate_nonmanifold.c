/* Surfaces that are no manifold at one vertex or one edge. See generate.h. */
#include "reference/mesh/generate.h"

#include "reference/mesh/builder.h"
#include "reference/mesh/circle.h"

/* A cone from vertex 0 to a ring and its centre at height z; s vertices from `first`, then the
 * centre. The lower cone is the upper one turned upside down: its triangles are reversed. */
static void add_cone(struct builder *b, int64_t sectors, double z)
{
    int64_t first = b->vertex_count, centre = first + sectors;
    for (int64_t s = 0; s < sectors; s++) {
        struct circle_point p = circle_point(s, sectors);
        add_vertex(b, 0.4 * p.cosine, 0.4 * p.sine, z);
    }
    add_vertex(b, 0.0, 0.0, z);
    for (int64_t s = 0; s < sectors; s++) {
        int64_t here = first + s, next = first + (s + 1) % sectors;
        add_triangle(b, 0, z > 0 ? next : here, z > 0 ? here : next);
        add_triangle(b, centre, z > 0 ? here : next, z > 0 ? next : here);
    }
}

int generate_two_cones(struct mesh *mesh, int64_t sectors, struct error *err)
{
    *mesh = (struct mesh){0};
    if (sectors < 3 || sectors > INT32_MAX / 12)
        return error_set(err, "generating two cones: %lld sectors, it must be 3 to %d",
                         (long long)sectors, INT32_MAX / 12);
    if (mesh_init(mesh, 2 * sectors + 3, 4 * sectors, err))
        return -1;
    struct builder b = {.mesh = mesh};
    add_vertex(&b, 0.0, 0.0, 0.0);
    add_cone(&b, sectors, 0.5);
    add_cone(&b, sectors, -0.5);
    return 0;
}

int generate_two_cubes(struct mesh *mesh, struct error *err)
{
    /* Corner k of a cube is at bit 0 of k in x, bit 1 in y, bit 2 in z. The first cube's upper edge
     * (corners 3 and 7) is the second cube's lower one (corners 0 and 4). */
    static const signed char corners[2][8] = {{0, 1, 2, 3, 4, 5, 6, 7},
                                              {3, 8, 9, 10, 7, 11, 12, 13}};
    static const signed char faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                            {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    if (mesh_init(mesh, 14, 24, err))
        return -1;
    struct builder b = {.mesh = mesh};
    for (int cube = 0; cube < 2; cube++) {
        const signed char *v = corners[cube];
        for (int k = 0; k < 8; k++)
            if (v[k] == b.vertex_count)
                add_vertex(&b, 0.5 * ((k & 1) + cube - 1), 0.5 * ((k >> 1 & 1) + cube - 1),
                           0.5 * (k >> 2) - 0.25);
        for (int f = 0; f < 6; f++)
            add_quad(&b, v[faces[f][0]], v[faces[f][1]], v[faces[f][2]], v[faces[f][3]]);
    }
    return 0;
}

int generate_book(struct mesh *mesh, int64_t leaves, struct error *err)
{
    *mesh = (struct mesh){0};
    if (leaves < 3 || leaves > INT32_MAX / 3 - 2)
        return error_set(err, "generating a book: %lld leaves, it must be 3 to %d",
                         (long long)leaves, INT32_MAX / 3 - 2);
    if (mesh_init(mesh, leaves + 2, leaves, err))
        return -1;
    struct builder b = {.mesh = mesh};
    add_vertex(&b, 0.0, 0.0, -0.5);
    add_vertex(&b, 0.0, 0.0, 0.5);
    for (int64_t i = 0; i < leaves; i++) {
        struct circle_point p = circle_point(i, leaves);
        add_vertex(&b, 0.5 * p.cosine, 0.5 * p.sine, 0.0);
        add_triangle(&b, 0, 1, 2 + i);
    }
    return 0;
}
