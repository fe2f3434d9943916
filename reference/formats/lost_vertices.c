/* Vertices that are not finite; see lost_vertices.h. */
#include "reference/formats/lost_vertices.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int remember(struct lost_vertices *lost, int64_t vertex, const struct scan *scan)
{
    if (lost->count == lost->capacity) {
        int64_t capacity = lost->capacity > 0 ? 2 * lost->capacity : 16;
        void *grown = realloc(lost->list, (size_t)capacity * sizeof *lost->list);
        if (!grown)
            return scan_error(scan, "out of memory: vertices that are not finite");
        lost->list = grown;
        lost->capacity = capacity;
    }
    lost->list[lost->count++] = (struct lost_vertex){vertex, scan_place(scan)};
    return 0;
}

int lost_vertices_add(struct lost_vertices *lost, struct growing_mesh *mesh,
                      const float position[3], const struct scan *scan)
{
    bool is_finite = isfinite(position[0]) && isfinite(position[1]) && isfinite(position[2]);
    if (!is_finite && remember(lost, mesh->vertex_count, scan))
        return -1;
    return growing_mesh_add_vertex(mesh, position, scan->err);
}

/* The lost vertices before this number; *is_lost: it is one itself. */
static int64_t lost_before(const struct lost_vertices *lost, int64_t vertex, bool *is_lost)
{
    int64_t low = 0, high = lost->count;
    while (low < high) {
        int64_t middle = low + (high - low) / 2;
        if (lost->list[middle].vertex < vertex)
            low = middle + 1;
        else
            high = middle;
    }
    *is_lost = low < lost->count && lost->list[low].vertex == vertex;
    return low;
}

static int renumber(const struct lost_vertices *lost, struct growing_mesh *mesh,
                    const struct scan *scan)
{
    for (int64_t i = 0; i < 3 * mesh->triangle_count; i++) {
        bool is_lost;
        int64_t before = lost_before(lost, mesh->triangles[i], &is_lost);
        if (is_lost)
            return scan_error_at(scan, lost->list[before].place,
                                 "a face uses this vertex, which has a coordinate that is not "
                                 "finite: give it a place, or take out the face");
        mesh->triangles[i] -= (int32_t)before;
    }
    return 0;
}

int lost_vertices_take_out(const struct lost_vertices *lost, struct growing_mesh *mesh,
                           const struct scan *scan)
{
    if (lost->count == 0)
        return 0;
    if (renumber(lost, mesh, scan))
        return -1;
    int64_t kept = 0, next = 0;
    for (int64_t v = 0; v < mesh->vertex_count; v++) {
        if (next < lost->count && lost->list[next].vertex == v)
            next++;
        else
            memmove(mesh->positions + 3 * kept++, mesh->positions + 3 * v, 12);
    }
    mesh->vertex_count = kept;
    scan_note_at(scan, READING_LOST_VERTEX, lost->count, lost->list[0].place);
    return 0;
}

void lost_vertices_release(struct lost_vertices *lost)
{
    free(lost->list);
    *lost = (struct lost_vertices){0};
}
