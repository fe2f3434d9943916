/* The plain truth about a small mesh; see mesh_oracle.h. */
#include "tests/unit/mesh_oracle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool is_degenerate(const int32_t t[3])
{
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

void oracle_init(struct oracle *oracle, const struct mesh *mesh)
{
    size_t count = (size_t)mesh->vertex_count;
    oracle->mesh = mesh;
    oracle->sides = calloc(count * count + 1, sizeof *oracle->sides);
    if (!oracle->sides)
        abort();
    for (int64_t t = 0; t < mesh->triangle_count; t++) {
        const int32_t *corner = mesh->triangles + 3 * t;
        for (int i = 0; i < 3 && !is_degenerate(corner); i++)
            oracle->sides[(size_t)corner[i] * count + (size_t)corner[(i + 1) % 3]]++;
    }
}

void oracle_release(struct oracle *oracle)
{
    free(oracle->sides);
}

static int sides_from(const struct oracle *oracle, int32_t u, int32_t v)
{
    return oracle->sides[(int64_t)u * oracle->mesh->vertex_count + v];
}

int oracle_uses(const struct oracle *oracle, int32_t u, int32_t v)
{
    return sides_from(oracle, u, v) + sides_from(oracle, v, u);
}

bool oracle_has_crowded_edge(const struct oracle *oracle)
{
    for (int32_t u = 0; u < oracle->mesh->vertex_count; u++)
        for (int32_t v = 0; v < u; v++)
            if (oracle_uses(oracle, u, v) > 2)
                return true;
    return false;
}

bool oracle_is_coherent(const struct oracle *oracle)
{
    for (int32_t u = 0; u < oracle->mesh->vertex_count; u++)
        for (int32_t v = 0; v < oracle->mesh->vertex_count; v++)
            if (sides_from(oracle, u, v) > 1)
                return false;
    return true;
}

int64_t oracle_edge_count(const struct oracle *oracle, int uses)
{
    int64_t count = 0;
    for (int32_t u = 0; u < oracle->mesh->vertex_count; u++)
        for (int32_t v = 0; v < u; v++)
            count += uses == 0 ? oracle_uses(oracle, u, v) > 0 : oracle_uses(oracle, u, v) == uses;
    return count;
}

int32_t oracle_faces_around(const struct oracle *oracle, int32_t vertex, int32_t *faces)
{
    int32_t count = 0;
    for (int32_t t = 0; t < oracle->mesh->triangle_count; t++) {
        const int32_t *corner = oracle->mesh->triangles + 3 * (int64_t)t;
        if (corner[0] == vertex || corner[1] == vertex || corner[2] == vertex)
            faces[count++] = t;
    }
    return count;
}

int32_t oracle_vertices_around(const struct oracle *oracle, int32_t vertex, int32_t *vertices)
{
    int32_t count = 0;
    for (int32_t v = 0; v < oracle->mesh->vertex_count; v++)
        if (oracle_uses(oracle, vertex, v) > 0)
            vertices[count++] = v;
    return count;
}

void oracle_face_neighbours(const struct oracle *oracle, int32_t face, int32_t neighbours[3])
{
    const int32_t *own = oracle->mesh->triangles + 3 * (int64_t)face;
    for (int side = 0; side < 3; side++) {
        neighbours[side] = -1;
        int32_t u = own[side], v = own[(side + 1) % 3];
        for (int32_t t = 0; t < oracle->mesh->triangle_count && !is_degenerate(own); t++) {
            const int32_t *corner = oracle->mesh->triangles + 3 * (int64_t)t;
            int named = 0;
            for (int i = 0; i < 3; i++)
                named += corner[i] == u || corner[i] == v;
            if (t != face && named == 2 && !is_degenerate(corner)) {
                neighbours[side] = t;
                break;
            }
        }
    }
}

bool oracle_is_boundary_vertex(const struct oracle *oracle, int32_t vertex)
{
    for (int32_t v = 0; v < oracle->mesh->vertex_count; v++)
        if (oracle_uses(oracle, vertex, v) == 1)
            return true;
    return false;
}

void oracle_area_vector(const struct oracle *oracle, int32_t face, double vector[3])
{
    double p[3][3];
    for (int corner = 0; corner < 3; corner++)
        for (int axis = 0; axis < 3; axis++) {
            int64_t v = oracle->mesh->triangles[3 * (int64_t)face + corner];
            p[corner][axis] = (double)oracle->mesh->positions[3 * v + axis];
        }
    for (int axis = 0; axis < 3; axis++) {
        int y = (axis + 1) % 3, z = (axis + 2) % 3;
        vector[axis] = ((p[1][y] - p[0][y]) * (p[2][z] - p[0][z]) -
                        (p[1][z] - p[0][z]) * (p[2][y] - p[0][y])) /
                       2.0;
    }
}

void oracle_vertex_vector(const struct oracle *oracle, int32_t vertex, double vector[3],
                          double *scale)
{
    vector[0] = vector[1] = vector[2] = *scale = 0.0;
    for (int32_t t = 0; t < oracle->mesh->triangle_count; t++)
        for (int corner = 0; corner < 3; corner++)
            if (oracle->mesh->triangles[3 * (int64_t)t + corner] == vertex) {
                double part[3];
                oracle_area_vector(oracle, t, part);
                for (int axis = 0; axis < 3; axis++)
                    vector[axis] += part[axis];
                *scale += sqrt(part[0] * part[0] + part[1] * part[1] + part[2] * part[2]);
            }
}

/* -- comparing -------------------------------------------------------------------------------- */

/* A triangle as nine words that start with its least corner: comparable as bytes. */
struct key {
    uint32_t words[9];
};

static void corner_words(const struct mesh *mesh, int32_t v, bool by_place, uint32_t words[3])
{
    words[0] = (uint32_t)v;
    words[1] = words[2] = 0;
    for (int axis = 0; axis < 3 && by_place; axis++) {
        float value = mesh->positions[3 * (int64_t)v + axis] + 0.0F; /* -0 becomes 0 */
        memcpy(words + axis, &value, sizeof value);
    }
}

static int compare_keys(const void *a, const void *b)
{
    return memcmp(a, b, sizeof(struct key));
}

static struct key *sorted_keys(const struct mesh *mesh, bool by_place)
{
    struct key *keys = calloc((size_t)mesh->triangle_count + 1, sizeof *keys);
    if (!keys)
        abort();
    for (int64_t t = 0; t < mesh->triangle_count; t++)
        for (int first = 0; first < 3; first++) {
            struct key turned;
            for (int i = 0; i < 3; i++)
                corner_words(mesh, mesh->triangles[3 * t + (first + i) % 3], by_place,
                             turned.words + 3 * i);
            if (first == 0 || compare_keys(&turned, &keys[t]) < 0)
                keys[t] = turned;
        }
    qsort(keys, (size_t)mesh->triangle_count, sizeof *keys, compare_keys);
    return keys;
}

static bool same_keys(const struct mesh *a, const struct mesh *b, bool by_place)
{
    if (a->triangle_count != b->triangle_count)
        return false;
    struct key *keys_a = sorted_keys(a, by_place), *keys_b = sorted_keys(b, by_place);
    bool same = memcmp(keys_a, keys_b, (size_t)a->triangle_count * sizeof *keys_a) == 0;
    free(keys_a);
    free(keys_b);
    return same;
}

bool same_surface(const struct mesh *a, const struct mesh *b)
{
    return same_keys(a, b, true);
}

bool same_numbered_mesh(const struct mesh *a, const struct mesh *b)
{
    return a->vertex_count == b->vertex_count &&
           (a->vertex_count == 0 ||
            memcmp(a->positions, b->positions, 12 * (size_t)a->vertex_count) == 0) &&
           same_keys(a, b, false);
}
