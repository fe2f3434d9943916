/* Stores for each corner the face on the other side of its edge, found by sorting the sides, and one
 * corner of each vertex: faces of a vertex are met by turning around it. */
#include "own-structure.h"

#include <stdlib.h>

struct side {
    int32_t low, high, corner;
};

struct structure {
    const int32_t *first_corner, *corners;
    int32_t *face, *twin; /* of each corner: its face, and the corner where the edge is run back */
    int32_t *corner_of;   /* of each vertex: one of its corners */
};

static int by_ends(const void *a, const void *b)
{
    const struct side *x = a, *y = b;
    if (x->low != y->low)
        return x->low < y->low ? -1 : 1;
    return (x->high > y->high) - (x->high < y->high);
}

static int32_t next_corner(const struct structure *s, int32_t c)
{
    int32_t face = s->face[c];
    return c + 1 < s->first_corner[face + 1] ? c + 1 : s->first_corner[face];
}

static int match(struct structure *s, int32_t corner_count)
{
    struct side *sides = malloc(sizeof *sides * (size_t)corner_count);
    if (!sides)
        return -1;
    for (int32_t c = 0; c < corner_count; c++) {
        int32_t a = s->corners[c], b = s->corners[next_corner(s, c)];
        sides[c] = (struct side){a < b ? a : b, a < b ? b : a, c};
    }
    qsort(sides, (size_t)corner_count, sizeof *sides, by_ends);
    for (int32_t i = 0; i + 1 < corner_count; i += 2) {
        s->twin[sides[i].corner] = sides[i + 1].corner;
        s->twin[sides[i + 1].corner] = sides[i].corner;
    }
    free(sides);
    return 0;
}

struct structure *structure_build(const int32_t *first_corner, const int32_t *corners,
                                  int32_t face_count, int32_t vertex_count)
{
    int32_t corner_count = first_corner[face_count];
    struct structure *s = calloc(1, sizeof *s);
    if (!s)
        return NULL;
    s->first_corner = first_corner;
    s->corners = corners;
    s->face = malloc(sizeof *s->face * (size_t)corner_count);
    s->twin = malloc(sizeof *s->twin * (size_t)corner_count);
    s->corner_of = malloc(sizeof *s->corner_of * (size_t)vertex_count);
    if (!s->face || !s->twin || !s->corner_of) {
        structure_release(s);
        return NULL;
    }
    for (int32_t f = 0; f < face_count; f++)
        for (int32_t c = first_corner[f]; c < first_corner[f + 1]; c++) {
            s->face[c] = f;
            s->corner_of[corners[c]] = c;
        }
    if (match(s, corner_count) != 0) {
        structure_release(s);
        return NULL;
    }
    return s;
}

void structure_release(struct structure *s)
{
    free(s->face);
    free(s->twin);
    free(s->corner_of);
    free(s);
}

int32_t faces_of_vertex(const struct structure *s, int32_t vertex, int32_t *out, int32_t capacity)
{
    int32_t first = s->corner_of[vertex], corner = first, count = 0;
    do {
        out[count++] = s->face[corner];
        corner =
            next_corner(s, s->twin[corner]); /* the face to the right leaves the vertex there */
    } while (corner != first && count < capacity);
    return count;
}

int32_t faces_of_face(const struct structure *s, int32_t face, int32_t *out, int32_t capacity)
{
    int32_t count = 0;
    for (int32_t c = s->first_corner[face]; c < s->first_corner[face + 1] && count < capacity; c++)
        out[count++] = s->face[s->twin[c]];
    return count;
}
