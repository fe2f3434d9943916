/* Stores both answers as tables: the queries copy. Sides are matched by a hash table. */
#include "own-structure.h"

#include <stdlib.h>
#include <string.h>

struct structure {
    const int32_t *first_corner;
    int32_t *first, *faces; /* of vertex v: faces[first[v]] ... faces[first[v + 1] - 1] */
    int32_t *across;        /* of each corner: the face across its edge */
};

/* Where a side was met first. */
struct entry {
    int32_t from, to, face, corner; /* from -1: free */
};

/* The place of the side from a to b, or where it belongs. */
static size_t find(const struct entry *table, size_t mask, int32_t a, int32_t b)
{
    size_t at = ((size_t)a * 2654435761u ^ (size_t)b * 40503u) & mask;
    while (table[at].from >= 0 && (table[at].from != a || table[at].to != b))
        at = (at + 1) & mask;
    return at;
}

static int match(struct structure *s, const int32_t *corners, int32_t face_count)
{
    size_t size = 16;
    while (size < 2 * (size_t)s->first_corner[face_count])
        size *= 2;
    struct entry *table = malloc(sizeof *table * size);
    if (!table)
        return -1;
    memset(table, 0xff, sizeof *table * size);
    for (int32_t f = 0; f < face_count; f++) {
        int32_t begin = s->first_corner[f], end = s->first_corner[f + 1];
        for (int32_t c = begin; c < end; c++) {
            int32_t a = corners[c], b = corners[c + 1 < end ? c + 1 : begin];
            size_t back = find(table, size - 1, b, a);
            if (table[back].from >= 0) {
                s->across[c] = table[back].face;
                s->across[table[back].corner] = f;
            } else {
                table[find(table, size - 1, a, b)] = (struct entry){a, b, f, c};
            }
        }
    }
    free(table);
    return 0;
}

struct structure *structure_build(const int32_t *first_corner, const int32_t *corners,
                                  int32_t face_count, int32_t vertex_count)
{
    size_t corner_count = (size_t)first_corner[face_count];
    struct structure *s = calloc(1, sizeof *s);
    if (!s)
        return NULL;
    s->first_corner = first_corner;
    s->first = calloc((size_t)vertex_count + 2, sizeof *s->first);
    s->faces = malloc(sizeof *s->faces * corner_count);
    s->across = malloc(sizeof *s->across * corner_count);
    if (!s->first || !s->faces || !s->across || match(s, corners, face_count) != 0) {
        structure_release(s);
        return NULL;
    }
    for (size_t c = 0; c < corner_count; c++)
        s->first[corners[c] + 2]++;
    for (int32_t v = 0; v <= vertex_count; v++)
        s->first[v + 1] += s->first[v];
    for (int32_t f = 0; f < face_count; f++)
        for (int32_t c = first_corner[f]; c < first_corner[f + 1]; c++)
            s->faces[s->first[corners[c] + 1]++] = f;
    return s;
}

void structure_release(struct structure *s)
{
    free(s->first);
    free(s->faces);
    free(s->across);
    free(s);
}

static int32_t copy(const int32_t *from, int32_t count, int32_t *out, int32_t capacity)
{
    if (count > capacity)
        count = capacity;
    memcpy(out, from, sizeof *out * (size_t)count);
    return count;
}

int32_t faces_of_vertex(const struct structure *s, int32_t vertex, int32_t *out, int32_t capacity)
{
    return copy(s->faces + s->first[vertex], s->first[vertex + 1] - s->first[vertex], out,
                capacity);
}

int32_t faces_of_face(const struct structure *s, int32_t face, int32_t *out, int32_t capacity)
{
    int32_t first = s->first_corner[face];
    return copy(s->across + first, s->first_corner[face + 1] - first, out, capacity);
}
