/* Normals of half-winged edges by groups of faces around a vertex; see half_winged_edge.h. */
#include "reference/representation/half_winged_edge.h"
#include "reference/representation/vector.h"

#include <stdlib.h>

static const double PI = 3.14159265358979323846;

static struct vector area_vector(const struct half_winged_edge_mesh *hw, int32_t face)
{
    int32_t first = hw->face_half_edge[face];
    struct vector origin = vector_at(hw->positions, hw->half_edges[first].start);
    struct vector sum = {0.0, 0.0, 0.0};
    for (int32_t h = hw->half_edges[first].next;
         hw->half_edges[h].end != hw->half_edges[first].start; h = hw->half_edges[h].next) {
        struct vector a = vector_at(hw->positions, hw->half_edges[h].start);
        struct vector b = vector_at(hw->positions, hw->half_edges[h].end);
        sum = vector_add(sum, vector_cross(vector_subtract(a, origin), vector_subtract(b, origin)));
    }
    return sum;
}

void half_winged_edge_area_vector(const struct half_winged_edge_mesh *hw, int32_t face,
                                  double vector[3])
{
    struct vector sum = area_vector(hw, face);
    vector[0] = sum.x;
    vector[1] = sum.y;
    vector[2] = sum.z;
}

/* Whether the faces on both sides of a half edge are too far from one plane, or one is missing. */
static bool is_crease(const struct half_winged_edge_mesh *hw, const struct vector *areas, int32_t h,
                      double crease_cosine)
{
    int32_t f = hw->half_edges[h].face, g = hw->half_edges[hw->half_edges[h].twin].face;
    if (f < 0 || g < 0)
        return true;
    double lengths = vector_length(areas[f]) * vector_length(areas[g]);
    return vector_dot(areas[f], areas[g]) < crease_cosine * lengths;
}

/* Gives the corners from `first` on, counter-clockwise up to the next crease, the unit sum of their
 * faces' area vectors. Returns the first half edge after them. */
static int32_t shade_group(struct half_winged_edge_mesh *hw, const struct vector *areas,
                           int32_t first, double crease_cosine)
{
    struct vector sum = {0.0, 0.0, 0.0};
    int32_t h = first;
    do {
        sum = vector_add(sum, areas[hw->half_edges[h].face]);
        h = half_winged_edge_turn_left(hw, h);
    } while (h != first && !is_crease(hw, areas, h, crease_cosine));
    int32_t after = h;
    h = first;
    do {
        vector_put(hw->half_edges[h].normal, 0, vector_unit(sum));
        h = half_winged_edge_turn_left(hw, h);
    } while (h != after);
    return after;
}

/* Groups start at creases; where a vertex has none, all its faces are one group. */
static void shade_vertex(struct half_winged_edge_mesh *hw, const struct vector *areas,
                         int32_t vertex, double crease_cosine)
{
    int32_t first = hw->vertex_half_edge[vertex], h = first;
    while (!is_crease(hw, areas, h, crease_cosine)) {
        h = half_winged_edge_turn_left(hw, h);
        if (h == first)
            break;
    }
    first = h;
    do {
        h = shade_group(hw, areas, h, crease_cosine);
    } while (h != first && hw->half_edges[h].face >= 0);
}

int half_winged_edge_shade(struct half_winged_edge_mesh *hw, double crease_degrees,
                           struct error *err)
{
    struct vector *areas = malloc((size_t)hw->face_count * sizeof *areas + 1);
    if (!areas)
        return error_set(err, "out of memory: normals of %d faces", hw->face_count);
    for (int32_t f = 0; f < hw->face_count; f++)
        areas[f] = area_vector(hw, f);
    /* No two faces turn by more than 180 degrees; rounding must not say otherwise. */
    double crease_cosine = crease_degrees < 180.0 ? cos(crease_degrees * PI / 180.0) : -2.0;
    for (int32_t v = 0; v < hw->vertex_count; v++)
        if (hw->vertex_half_edge[v] >= 0)
            shade_vertex(hw, areas, v, crease_cosine);
    free(areas);
    return 0;
}

static bool looks_alike(const struct half_winged_edge *a, const struct half_winged_edge *b)
{
    return a->normal[0] == b->normal[0] && a->normal[1] == b->normal[1] &&
           a->normal[2] == b->normal[2] && a->texture[0] == b->texture[0] &&
           a->texture[1] == b->texture[1];
}

int64_t half_winged_edge_render_vertices(const struct half_winged_edge_mesh *hw)
{
    int64_t count = 0;
    for (int32_t v = 0; v < hw->vertex_count; v++) {
        int32_t first = hw->vertex_half_edge[v], h = first, changes = 0;
        if (first < 0) {
            count++;
            continue;
        }
        bool is_open = half_winged_edge_on_boundary(hw, v);
        do {
            int32_t left = half_winged_edge_turn_left(hw, h);
            bool at_end = hw->half_edges[left].face < 0;
            changes += at_end || !looks_alike(hw->half_edges + h, hw->half_edges + left);
            h = at_end ? first : left;
        } while (h != first);
        count += is_open || changes > 0 ? changes : 1;
    }
    return count;
}
