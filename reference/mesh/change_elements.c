/* Changes that add and remove elements: what broken files are made of. See generate.h. */
#include "reference/mesh/generate.h"

#include "reference/base/random.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* A copy of the mesh with room for more after the old elements, for the caller to fill. */
static int make_grown(struct mesh *made, const struct mesh *mesh, int64_t more_vertices,
                      int64_t more_triangles, struct error *err)
{
    if (mesh_init(made, mesh->vertex_count + more_vertices, mesh->triangle_count + more_triangles,
                  err))
        return -1;
    if (mesh->vertex_count > 0)
        memcpy(made->positions, mesh->positions, 12 * (size_t)mesh->vertex_count);
    if (mesh->triangle_count > 0)
        memcpy(made->triangles, mesh->triangles, 12 * (size_t)mesh->triangle_count);
    return 0;
}

static void replace(struct mesh *mesh, const struct mesh *made)
{
    mesh_release(mesh);
    *mesh = *made;
}

static int check_count(int64_t count, int64_t most, const char *change, struct error *err)
{
    if (count < 0 || count > most)
        return error_set(err, "%s: the count is %lld and must be 0 to %lld", change,
                         (long long)count, (long long)most);
    return 0;
}

int change_append(struct mesh *mesh, const struct mesh *other, float dx, float dy, float dz,
                  struct error *err)
{
    struct mesh made;
    if (make_grown(&made, mesh, other->vertex_count, other->triangle_count, err))
        return -1;
    for (int64_t v = 0; v < other->vertex_count; v++) {
        const float *from = other->positions + 3 * v;
        float *to = made.positions + 3 * (mesh->vertex_count + v);
        to[0] = from[0] + dx;
        to[1] = from[1] + dy;
        to[2] = from[2] + dz;
    }
    for (int64_t corner = 0; corner < 3 * (int64_t)other->triangle_count; corner++)
        made.triangles[3 * (int64_t)mesh->triangle_count + corner] =
            other->triangles[corner] + mesh->vertex_count;
    replace(mesh, &made);
    return 0;
}

/* Fills all positions of `made`, old vertices in their order and isolated ones at random places
 * between them, and the new number of each old vertex. */
static void mix_in_isolated(struct mesh *made, const struct mesh *mesh, int32_t *number,
                            struct random *rng)
{
    int64_t old = 0;
    for (int32_t v = 0; v < made->vertex_count; v++) {
        float *p = made->positions + 3 * (int64_t)v;
        int64_t places = made->vertex_count - v, old_left = mesh->vertex_count - old;
        if ((int64_t)random_below(rng, (uint64_t)places) < old_left) {
            memcpy(p, mesh->positions + 3 * old, 3 * sizeof(float));
            number[old++] = v;
        } else {
            for (int axis = 0; axis < 3; axis++)
                p[axis] = random_float(rng, -0.5F, 0.5F);
        }
    }
}

int change_add_isolated_vertices(struct mesh *mesh, int64_t count, uint64_t seed, struct error *err)
{
    struct mesh made;
    if (check_count(count, INT32_MAX / 3, "adding isolated vertices", err) ||
        make_grown(&made, mesh, count, 0, err))
        return -1;
    int32_t *number = calloc((size_t)mesh->vertex_count + 1, sizeof *number);
    if (!number) {
        mesh_release(&made);
        return error_set(err, "out of memory: numbering %d vertices", mesh->vertex_count);
    }
    struct random rng;
    random_init(&rng, seed);
    mix_in_isolated(&made, mesh, number, &rng);
    for (int64_t corner = 0; corner < 3 * (int64_t)made.triangle_count; corner++)
        made.triangles[corner] = number[made.triangles[corner]];
    free(number);
    replace(mesh, &made);
    return 0;
}

int change_add_duplicate_triangles(struct mesh *mesh, int64_t count, uint64_t seed,
                                   struct error *err)
{
    struct mesh made;
    if (check_count(count, mesh->triangle_count > 0 ? INT32_MAX / 3 : 0,
                    "listing triangles of a mesh twice", err) ||
        make_grown(&made, mesh, 0, count, err))
        return -1;
    struct random rng;
    random_init(&rng, seed);
    for (int64_t i = 0; i < count; i++) {
        int64_t chosen = (int64_t)random_below(&rng, (uint64_t)mesh->triangle_count);
        int turn = (int)random_below(&rng, 3), direction = 1 + (int)random_below(&rng, 2);
        int32_t *to = made.triangles + 3 * (mesh->triangle_count + i);
        for (int corner = 0; corner < 3; corner++)
            to[corner] = mesh->triangles[3 * chosen + (turn + direction * corner) % 3];
    }
    replace(mesh, &made);
    return 0;
}

/* Two different vertices of one triangle, looked for from a random triangle on. */
static bool find_edge(const struct mesh *mesh, struct random *rng, int32_t edge[2])
{
    if (mesh->triangle_count == 0)
        return false;
    int64_t start = (int64_t)random_below(rng, (uint64_t)mesh->triangle_count);
    int first = (int)random_below(rng, 3);
    for (int64_t i = 0; i < mesh->triangle_count; i++) {
        const int32_t *t = mesh->triangles + 3 * ((start + i) % mesh->triangle_count);
        for (int corner = 0; corner < 3; corner++) {
            edge[0] = t[(first + corner) % 3];
            edge[1] = t[(first + corner + 1) % 3];
            if (edge[0] != edge[1])
                return true;
        }
    }
    return false;
}

int change_add_degenerate_triangles(struct mesh *mesh, int64_t count, uint64_t seed,
                                    struct error *err)
{
    struct random rng;
    random_init(&rng, seed);
    int32_t edge[2] = {0};
    struct mesh made;
    if (check_count(count, find_edge(mesh, &rng, edge) ? INT32_MAX / 3 : 0,
                    "adding degenerate triangles on the edges of a mesh", err) ||
        make_grown(&made, mesh, 0, count, err))
        return -1;
    for (int64_t i = 0; i < count; i++) {
        find_edge(mesh, &rng, edge);
        int32_t *t = made.triangles + 3 * (mesh->triangle_count + i);
        t[0] = edge[0];
        t[1] = i % 3 == 1 ? edge[1] : edge[0];
        t[2] = i % 3 == 0 ? edge[1] : edge[0];
    }
    replace(mesh, &made);
    return 0;
}

int change_remove_triangles(struct mesh *mesh, int64_t count, uint64_t seed, struct error *err)
{
    struct mesh made;
    if (check_count(count, mesh->triangle_count, "removing triangles", err) ||
        mesh_init(&made, mesh->vertex_count, mesh->triangle_count - count, err))
        return -1;
    if (mesh->vertex_count > 0)
        memcpy(made.positions, mesh->positions, 12 * (size_t)mesh->vertex_count);
    struct random rng;
    random_init(&rng, seed);
    int64_t kept = 0;
    for (int64_t t = 0; t < mesh->triangle_count; t++) {
        /* Each set of `made.triangle_count` triangles is equally likely (Knuth's algorithm S). */
        uint64_t left = (uint64_t)(mesh->triangle_count - t);
        if ((int64_t)random_below(&rng, left) < made.triangle_count - kept)
            memcpy(made.triangles + 3 * kept++, mesh->triangles + 3 * t, 3 * sizeof(int32_t));
    }
    replace(mesh, &made);
    return 0;
}
