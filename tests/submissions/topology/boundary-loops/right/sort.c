/* Sorts the sides by their two vertices, so that the two of an inner edge come together; then the
 * boundary sides, which are left, by where they begin, so that bsearch finds the next one. */
#include "boundary-loops.h"

#include <stdlib.h>

struct side {
    int32_t begin, end, used;
};

static int compare_edges(const void *a, const void *b)
{
    const struct side *p = a, *q = b;
    int32_t p_low = p->begin < p->end ? p->begin : p->end, p_high = p->begin ^ p->end ^ p_low;
    int32_t q_low = q->begin < q->end ? q->begin : q->end, q_high = q->begin ^ q->end ^ q_low;
    if (p_low != q_low)
        return p_low < q_low ? -1 : 1;
    return (p_high > q_high) - (p_high < q_high);
}

static int compare_begins(const void *a, const void *b)
{
    const struct side *p = a, *q = b;
    return (p->begin > q->begin) - (p->begin < q->begin);
}

/* Keeps what has no partner. */
static size_t drop_pairs(struct side *sides, size_t count)
{
    size_t kept = 0;
    for (size_t s = 0; s < count; s++)
        if (s + 1 < count && compare_edges(&sides[s], &sides[s + 1]) == 0)
            s++;
        else
            sides[kept++] = sides[s];
    return kept;
}

/* An unused side that begins at v. */
static struct side *find(struct side *sides, size_t count, int32_t v)
{
    struct side wanted = {v, 0, 0};
    struct side *side = bsearch(&wanted, sides, count, sizeof *sides, compare_begins);
    while (side > sides && side[-1].begin == v)
        side--;
    while (side->used)
        side++;
    return side;
}

int32_t boundary_loops(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **first, int32_t **vertices)
{
    (void)vertex_count;
    size_t count = 3 * (size_t)triangle_count;
    struct side *sides = malloc(count * sizeof *sides + 1);
    *first = malloc((count + 1) * sizeof **first);
    *vertices = malloc(count * sizeof **vertices + 1);
    if (!sides || !*first || !*vertices) {
        free(sides);
        free(*first);
        free(*vertices);
        return OUT_OF_MEMORY;
    }
    for (size_t s = 0; s < count; s++)
        sides[s] = (struct side){triangles[s], triangles[s % 3 == 2 ? s - 2 : s + 1], 0};
    if (count > 0)
        qsort(sides, count, sizeof *sides, compare_edges);
    count = drop_pairs(sides, count);
    if (count > 0)
        qsort(sides, count, sizeof *sides, compare_begins);
    int32_t loops = 0, length = 0;
    (*first)[0] = 0;
    for (size_t s = 0; s < count; s++) {
        if (sides[s].used)
            continue;
        struct side *at = &sides[s];
        for (;;) {
            at->used = 1;
            (*vertices)[length++] = at->begin;
            if (at->end == sides[s].begin)
                break;
            at = find(sides, count, at->end);
        }
        (*first)[++loops] = length;
    }
    free(sides);
    return loops;
}
