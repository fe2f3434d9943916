/* A list of sides for each vertex: those that leave it and have not met their twin.
 *
 * Side (a,b) looks for (b,a) in the list of b. If it is there, both are inside the surface, and it
 * is taken out; if not, (a,b) joins the list of a. What stays is the boundary. At every vertex as
 * many boundary sides arrive as leave, so that a walk that takes each side once can end only where
 * it began. Time O(V + F) for bounded valence, memory 4 V + 28 F bytes with the two tables. */
#include "boundary-loops.h"

#include <stdlib.h>
#include <string.h>

struct lists {
    const int32_t *triangles;
    int32_t *side_of; /* for each vertex, a side that leaves it; -1: none */
    int32_t *next;    /* for each side, the next one in its list, or -1 */
};

/* Side s leaves vertex triangles[s]; this is where it ends. */
static int32_t end_of(const struct lists *lists, int32_t s)
{
    return lists->triangles[s % 3 == 2 ? s - 2 : s + 1];
}

/* What is in the lists afterwards is the boundary. */
static void list_boundary(struct lists *lists, int32_t side_count)
{
    for (int32_t s = 0; s < side_count; s++) {
        int32_t begin = lists->triangles[s], end = end_of(lists, s);
        int32_t *twin = &lists->side_of[end];
        while (*twin >= 0 && end_of(lists, *twin) != begin)
            twin = &lists->next[*twin];
        if (*twin >= 0) {
            *twin = lists->next[*twin];
        } else {
            lists->next[s] = lists->side_of[begin];
            lists->side_of[begin] = s;
        }
    }
}

/* Empties the lists into loops. Returns how many loops there are. */
static int32_t walk(struct lists *lists, int32_t vertex_count, int32_t *first, int32_t *vertices)
{
    int32_t loop_count = 0, count = 0;
    first[0] = 0;
    for (int32_t v = 0; v < vertex_count; v++)
        while (lists->side_of[v] >= 0) {
            int32_t at = v;
            do {
                int32_t side = lists->side_of[at];
                lists->side_of[at] = lists->next[side];
                vertices[count++] = at;
                at = end_of(lists, side);
            } while (at != v);
            first[++loop_count] = count;
        }
    return loop_count;
}

int32_t boundary_loops(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **first, int32_t **vertices)
{
    size_t side_count = 3 * (size_t)triangle_count, vertex_bytes = (size_t)vertex_count * 4;
    struct lists lists = {triangles, malloc(vertex_bytes + 1), malloc(side_count * 4 + 1)};
    int32_t count = OUT_OF_MEMORY;
    *first = malloc((side_count / 3 + 1) * sizeof **first); /* a loop has three vertices or more */
    *vertices = malloc(side_count * sizeof **vertices + 1);
    if (lists.side_of && lists.next && *first && *vertices) {
        memset(lists.side_of, -1, vertex_bytes);
        list_boundary(&lists, (int32_t)side_count);
        count = walk(&lists, vertex_count, *first, *vertices);
    } else {
        free(*first);
        free(*vertices);
    }
    free(lists.side_of);
    free(lists.next);
    return count;
}
