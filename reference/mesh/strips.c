/* Triangle strips and what they decode to; see strips.h. */
#include "reference/mesh/strips.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int strips_init(struct strips *strips, int64_t strip_count, const int32_t *vertex_counts,
                struct error *err)
{
    *strips = (struct strips){0};
    int64_t vertex_count = 0;
    for (int64_t s = 0; s < strip_count; s++) {
        if (vertex_counts[s] < 3)
            return error_set(err, "strip %lld of %d vertices: a strip has at least 3", (long long)s,
                             vertex_counts[s]);
        vertex_count += vertex_counts[s];
    }
    if (strip_count < 0 || vertex_count > INT32_MAX / 3)
        return error_set(err, "%lld strips of %lld vertices: at most %d vertices are possible",
                         (long long)strip_count, (long long)vertex_count, INT32_MAX / 3);
    if (strip_count == 0)
        return 0;
    strips->positions = calloc((size_t)vertex_count, 3 * sizeof *strips->positions);
    strips->first_vertex = malloc(((size_t)strip_count + 1) * sizeof *strips->first_vertex);
    if (!strips->positions || !strips->first_vertex) {
        strips_release(strips);
        return error_set(err, "out of memory: strips of %lld vertices", (long long)vertex_count);
    }
    strips->first_vertex[0] = 0;
    for (int64_t s = 0; s < strip_count; s++)
        strips->first_vertex[s + 1] = strips->first_vertex[s] + vertex_counts[s];
    strips->vertex_count = (int32_t)vertex_count;
    strips->strip_count = (int32_t)strip_count;
    return 0;
}

void strips_release(struct strips *strips)
{
    free(strips->positions);
    free(strips->first_vertex);
    *strips = (struct strips){0};
}

int strips_check(const struct strips *strips, struct error *err)
{
    for (int64_t s = 0; s < strips->strip_count; s++) {
        int64_t first = strips->first_vertex[s], end = strips->first_vertex[s + 1];
        if ((s == 0 && first != 0) || end > strips->vertex_count || end - first < 3)
            return error_set(err, "strip %lld has vertices %lld to %lld of %d: at least 3 expected",
                             (long long)s, (long long)first, (long long)end - 1,
                             strips->vertex_count);
        for (int64_t i = 3 * first; i < 3 * end; i++)
            if (!isfinite(strips->positions[i]))
                return error_set(err, "strip %lld: %c of its vertex %lld is not finite",
                                 (long long)s, "xyz"[i % 3], (long long)(i / 3 - first));
    }
    if (strips->strip_count > 0 &&
        strips->first_vertex[strips->strip_count] != strips->vertex_count)
        return error_set(err, "the strips end at vertex %d of %d",
                         strips->first_vertex[strips->strip_count], strips->vertex_count);
    return 0;
}

int64_t strips_triangle_count(const struct strips *strips)
{
    return strips->vertex_count - 2 * (int64_t)strips->strip_count;
}

int64_t strips_bytes(int64_t strip_count, int64_t vertex_count)
{
    return 4 + 8 * strip_count + 12 * vertex_count;
}

int strips_to_soup(struct soup *soup, const struct strips *strips, struct error *err)
{
    if (soup_init(soup, strips_triangle_count(strips), err))
        return -1;
    float *to = soup->corners;
    for (int64_t s = 0; s < strips->strip_count; s++) {
        const float *p = strips->positions + 3 * (int64_t)strips->first_vertex[s];
        int64_t triangles = strips->first_vertex[s + 1] - strips->first_vertex[s] - 2;
        for (int64_t i = 0; i < triangles; i++, to += 9) {
            int64_t odd = i % 2;
            memcpy(to, p + 3 * (i + odd), 3 * sizeof *p);
            memcpy(to + 3, p + 3 * (i + 1 - odd), 3 * sizeof *p);
            memcpy(to + 6, p + 3 * (i + 2), 3 * sizeof *p);
        }
    }
    return 0;
}

int strips_to_mesh(struct mesh *mesh, const struct strips *strips, struct error *err)
{
    *mesh = (struct mesh){0};
    struct soup soup;
    if (strips_to_soup(&soup, strips, err))
        return -1;
    int result = soup_to_mesh(mesh, &soup, err);
    soup_release(&soup);
    return result;
}
