/* Cutting a mesh into strips, greedily; see strips.h.
 *
 * Sides are numbered 3 * triangle + corner, as in edges.h. A strip that has just passed a triangle
 * leaves it through one of its sides; the next triangle is the one with the twin of that side. */
#include "reference/mesh/strips.h"

#include "reference/mesh/edges.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

struct stripper {
    const struct mesh *mesh;
    int32_t *twin;       /* of each side: the side that runs back along the same edge, or -1 */
    uint32_t *walk;      /* of each triangle: the walk that saw it last */
    uint8_t *is_used;    /* of each triangle: it lies in a strip */
    int32_t *indices;    /* vertices of all strips so far */
    int32_t *lengths;    /* of each strip, in vertices */
    int64_t index_count; /* entries of indices */
    int32_t strip_count;
    uint32_t walk_count;
};

/* Pairs the forward sides of each edge with its backward ones, one to one. */
static void pair_twins(const struct edge_list *list, const struct mesh *mesh, int32_t *twin)
{
    memset(twin, 0xff, 3 * (size_t)mesh->triangle_count * sizeof *twin);
    for (int64_t e = 0; e < list->edge_count; e++) {
        const struct edge *edge = &list->edges[e];
        const int32_t *uses = list->uses + edge->first_use;
        int64_t count = edge_use_count(edge), forward = 0, backward = 0;
        for (;;) {
            while (forward < count && mesh->triangles[uses[forward]] != edge->low)
                forward++;
            while (backward < count && mesh->triangles[uses[backward]] != edge->high)
                backward++;
            if (forward >= count || backward >= count)
                break;
            twin[uses[forward]] = uses[backward];
            twin[uses[backward]] = uses[forward];
            forward++;
            backward++;
        }
    }
}

static int32_t next_side(int32_t side)
{
    return side % 3 == 2 ? side - 2 : side + 1;
}

static int32_t previous_side(int32_t side)
{
    return side % 3 == 0 ? side + 2 : side - 1;
}

/* Walks from the triangle of `start`, whose corners from `start` on are the strip's first three
 * vertices. When `keep`, appends these vertices to the indices and marks the triangles as used.
 * Returns the number of vertices. */
static int64_t walk_strip(struct stripper *s, int32_t start, bool keep)
{
    const int32_t *corner = s->mesh->triangles;
    int32_t *out = s->indices + s->index_count;
    uint32_t walk = ++s->walk_count;
    int32_t enter = start, leave = next_side(start);
    if (keep) {
        out[0] = corner[start];
        out[1] = corner[leave];
    }
    for (int64_t count = 2;; count++) {
        s->walk[enter / 3] = walk;
        if (keep) {
            s->is_used[enter / 3] = 1;
            out[count] = corner[previous_side(enter)];
        }
        /* Left and right in turn: an even triangle is left through the side that starts at its
         * second vertex, an odd one through the side that starts at its newest. */
        leave = count % 2 == 0 ? next_side(enter) : previous_side(enter);
        enter = s->twin[leave];
        if (enter < 0 || s->is_used[enter / 3] || s->walk[enter / 3] == walk)
            return count + 1;
    }
}

/* The longest of the three walks from triangle t becomes a strip. Its length is at least a third of
 * what was walked, so that all walks together stay linear. */
static void add_strip(struct stripper *s, int32_t t)
{
    int32_t best = 3 * t;
    int64_t best_count = 0;
    for (int32_t start = 3 * t; start < 3 * t + 3; start++) {
        int64_t count = walk_strip(s, start, false);
        if (count > best_count) {
            best_count = count;
            best = start;
        }
    }
    s->index_count += walk_strip(s, best, true);
    s->lengths[s->strip_count++] = (int32_t)best_count;
}

static void stripper_release(struct stripper *s)
{
    free(s->twin);
    free(s->walk);
    free(s->is_used);
    free(s->indices);
    free(s->lengths);
}

static int stripper_init(struct stripper *s, const struct mesh *mesh, struct error *err)
{
    size_t count = (size_t)mesh->triangle_count;
    *s = (struct stripper){.mesh = mesh};
    s->twin = malloc(3 * count * sizeof *s->twin + 1);
    s->walk = calloc(count + 1, sizeof *s->walk);
    s->is_used = calloc(count + 1, 1);
    s->indices = malloc(3 * count * sizeof *s->indices + 1);
    s->lengths = malloc(count * sizeof *s->lengths + 1);
    struct edge_list list;
    if (!s->twin || !s->walk || !s->is_used || !s->indices || !s->lengths)
        error_set(err, "out of memory: making strips of %d triangles", mesh->triangle_count);
    else if (edge_list_init(&list, mesh, err) == 0) {
        pair_twins(&list, mesh, s->twin);
        edge_list_release(&list);
        return 0;
    }
    stripper_release(s);
    return -1;
}

int strip_numbers_from_mesh(struct strip_numbers *strips, const struct mesh *mesh,
                            struct error *err)
{
    *strips = (struct strip_numbers){0};
    struct stripper s;
    if (stripper_init(&s, mesh, err))
        return -1;
    for (int32_t t = 0; t < mesh->triangle_count; t++)
        if (!s.is_used[t])
            add_strip(&s, t);
    *strips = (struct strip_numbers){s.indices, s.lengths, s.index_count, s.strip_count};
    s.indices = s.lengths = NULL;
    stripper_release(&s);
    return 0;
}

void strip_numbers_release(struct strip_numbers *strips)
{
    free(strips->indices);
    free(strips->lengths);
    *strips = (struct strip_numbers){0};
}

int strips_from_mesh(struct strips *strips, const struct mesh *mesh, struct error *err)
{
    *strips = (struct strips){0};
    struct strip_numbers numbers;
    if (strip_numbers_from_mesh(&numbers, mesh, err))
        return -1;
    int result = strips_init(strips, numbers.strip_count, numbers.lengths, err);
    if (result == 0)
        for (int64_t i = 0; i < numbers.index_count; i++)
            memcpy(strips->positions + 3 * i, mesh->positions + 3 * (int64_t)numbers.indices[i],
                   3 * sizeof(float));
    strip_numbers_release(&numbers);
    return result;
}
