/* The faces of each vertex, vertex after vertex in one table. The face across an edge is the one
 * among those of its first vertex that runs the edge the other way. Building takes O(V + C) time and
 * 4 (V + C) bytes; a query O(k) for k faces listed, as vertices have a bounded number of faces. */
#include "own-structure.h"

#include <stdbool.h>
#include <stdlib.h>

struct structure {
    const int32_t *first_corner, *corners;
    int32_t *first; /* of vertex v: faces[first[v]] ... faces[first[v + 1] - 1] */
    int32_t *faces;
};

/* Counting sort of the corners by their vertices. */
static void list_faces(struct structure *s, int32_t face_count, int32_t vertex_count)
{
    for (int32_t c = 0; c < s->first_corner[face_count]; c++)
        s->first[s->corners[c] + 1]++;
    for (int32_t v = 0; v < vertex_count; v++)
        s->first[v + 1] += s->first[v];
    for (int32_t f = 0; f < face_count; f++)
        for (int32_t c = s->first_corner[f]; c < s->first_corner[f + 1]; c++)
            s->faces[s->first[s->corners[c]]++] = f;
    for (int32_t v = vertex_count; v > 0; v--) /* each has become the next one's first */
        s->first[v] = s->first[v - 1];
    s->first[0] = 0;
}

struct structure *structure_build(const int32_t *first_corner, const int32_t *corners,
                                  int32_t face_count, int32_t vertex_count)
{
    struct structure *s = malloc(sizeof *s);
    if (!s)
        return NULL;
    *s = (struct structure){first_corner, corners, NULL, NULL};
    s->first = calloc((size_t)vertex_count + 1, sizeof *s->first);
    s->faces = malloc(sizeof *s->faces * (size_t)first_corner[face_count]);
    if (!s->first || !s->faces) {
        structure_release(s);
        return NULL;
    }
    list_faces(s, face_count, vertex_count);
    return s;
}

void structure_release(struct structure *structure)
{
    free(structure->first);
    free(structure->faces);
    free(structure);
}

int32_t faces_of_vertex(const struct structure *s, int32_t vertex, int32_t *out, int32_t capacity)
{
    int32_t count = 0;
    for (int32_t i = s->first[vertex]; i < s->first[vertex + 1] && count < capacity; i++)
        out[count++] = s->faces[i];
    return count;
}

/* The corner after c in the face. */
static int32_t next_corner(const struct structure *s, int32_t face, int32_t c)
{
    return c + 1 < s->first_corner[face + 1] ? c + 1 : s->first_corner[face];
}

/* Whether a face runs from vertex a to vertex b. */
static bool runs(const struct structure *s, int32_t face, int32_t a, int32_t b)
{
    for (int32_t c = s->first_corner[face]; c < s->first_corner[face + 1]; c++)
        if (s->corners[c] == a && s->corners[next_corner(s, face, c)] == b)
            return true;
    return false;
}

int32_t faces_of_face(const struct structure *s, int32_t face, int32_t *out, int32_t capacity)
{
    int32_t count = 0;
    for (int32_t c = s->first_corner[face]; c < s->first_corner[face + 1] && count < capacity;
         c++) {
        int32_t a = s->corners[c], b = s->corners[next_corner(s, face, c)];
        for (int32_t i = s->first[a]; i < s->first[a + 1]; i++)
            if (runs(s, s->faces[i], b, a))
                out[count++] = s->faces[i];
    }
    return count;
}
