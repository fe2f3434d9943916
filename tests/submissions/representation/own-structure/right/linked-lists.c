/* A list of corners for each vertex, linked through the corners; the face of a corner is stored. */
#include "own-structure.h"

#include <stdlib.h>

struct structure {
    const int32_t *first_corner, *corners;
    int32_t *head; /* of each vertex: its last corner */
    int32_t *link; /* of each corner: the one before it at the vertex; -1 */
    int32_t *face; /* of each corner */
};

struct structure *structure_build(const int32_t *first_corner, const int32_t *corners,
                                  int32_t face_count, int32_t vertex_count)
{
    size_t corner_count = (size_t)first_corner[face_count];
    struct structure *s = malloc(sizeof *s);
    int32_t *room = malloc(sizeof *room * ((size_t)vertex_count + 2 * corner_count));
    if (!s || !room) {
        free(s);
        free(room);
        return NULL;
    }
    *s = (struct structure){first_corner, corners, room, room + vertex_count,
                            room + vertex_count + corner_count};
    for (int32_t v = 0; v < vertex_count; v++)
        s->head[v] = -1;
    for (int32_t f = 0; f < face_count; f++)
        for (int32_t c = first_corner[f]; c < first_corner[f + 1]; c++) {
            s->face[c] = f;
            s->link[c] = s->head[corners[c]];
            s->head[corners[c]] = c;
        }
    return s;
}

void structure_release(struct structure *s)
{
    free(s->head);
    free(s);
}

int32_t faces_of_vertex(const struct structure *s, int32_t vertex, int32_t *out, int32_t capacity)
{
    int32_t count = 0;
    for (int32_t c = s->head[vertex]; c >= 0 && count < capacity; c = s->link[c])
        out[count++] = s->face[c];
    return count;
}

/* The corner before c in its face. */
static int32_t previous(const struct structure *s, int32_t c)
{
    int32_t begin = s->first_corner[s->face[c]];
    return c > begin ? c - 1 : s->first_corner[s->face[c] + 1] - 1;
}

/* Across the edge that arrives at corner c: the face that leaves the vertex to the one before. */
int32_t faces_of_face(const struct structure *s, int32_t face, int32_t *out, int32_t capacity)
{
    int32_t count = 0;
    for (int32_t c = s->first_corner[face]; c < s->first_corner[face + 1] && count < capacity;
         c++) {
        int32_t from = s->corners[previous(s, c)];
        for (int32_t other = s->head[s->corners[c]]; other >= 0; other = s->link[other]) {
            int32_t end = s->first_corner[s->face[other] + 1];
            int32_t next = other + 1 < end ? other + 1 : s->first_corner[s->face[other]];
            if (s->corners[next] == from)
                out[count++] = s->face[other];
        }
    }
    return count;
}
