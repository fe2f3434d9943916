/* Strips by a walk over twins; see stripify.h. */
#include "reference/kernels/stripify.h"

#include "reference/kernels/twins.h"

#include <string.h>

/* Of the walk: a byte a triangle, and the stack. */
static size_t walk_bytes(int64_t triangle_count)
{
    return 9 * (size_t)triangle_count + 64;
}

size_t stripify_scratch_bytes(int64_t vertex_count, int64_t triangle_count)
{
    size_t twins = twins_scratch_bytes(vertex_count, triangle_count);
    size_t walk = walk_bytes(triangle_count);
    size_t output = (twins_output_bytes(vertex_count, triangle_count) + 63) & ~(size_t)63;
    return output + (twins > walk ? twins : walk);
}

size_t stripify_output_bytes(int64_t vertex_count, int64_t triangle_count)
{
    (void)vertex_count;
    return 16 * (size_t)triangle_count + 64;
}

int64_t stripify_moved_bytes(int64_t vertex_count, int64_t triangle_count, int64_t index_count)
{
    (void)vertex_count;
    return 12 * triangle_count + 4 * index_count;
}

struct walker {
    const int32_t *corner; /* the mesh's triangles */
    const int32_t *twin;
    uint8_t *is_used; /* of each triangle, and of one behind them, which stands for none: used */
    int32_t none;
    int32_t *passed; /* stack of triangles that strips have passed by */
    int64_t passed_count;
    int32_t *out; /* where the next index goes */
};

static inline int32_t next_side(int32_t side, int32_t triangle)
{
    return side - 3 * triangle == 2 ? side - 2 : side + 1;
}

static inline int32_t previous_side(int32_t side, int32_t triangle)
{
    return side == 3 * triangle ? side + 2 : side - 1;
}

/* The triangle behind a side. */
static inline int32_t neighbour(const struct walker *w, int32_t side)
{
    int32_t twin = w->twin[side];
    return twin < 0 ? w->none : (int32_t)((uint32_t)twin / 3);
}

static inline bool is_free(const struct walker *w, int32_t triangle)
{
    return !w->is_used[triangle];
}

/* Remembers a triangle as a place to start from, when it is free. */
static inline void pass_by(struct walker *w, int32_t triangle)
{
    w->passed[w->passed_count] = triangle;
    w->passed_count += is_free(w, triangle);
}

/* The side through which to leave the first triangle of a strip: its neighbour has the fewest free
 * neighbours, so that it is not left alone. -1 when no neighbour is free. */
static int32_t first_exit(const struct walker *w, int32_t triangle)
{
    int32_t best = -1;
    int fewest = 4;
    for (int32_t side = 3 * triangle; side < 3 * triangle + 3; side++) {
        int32_t t = neighbour(w, side);
        if (!is_free(w, t))
            continue;
        int count = 0;
        for (int32_t other = 3 * t; other < 3 * t + 3; other++)
            count += is_free(w, neighbour(w, other));
        if (count < fewest) {
            fewest = count;
            best = side;
        }
    }
    return best;
}

/* Goes on from the triangle behind the side `leave`, the second of the strip, until no neighbour is
 * free. The last two indices are those of that side, the older one first. */
static void walk(struct walker *w, int32_t leave)
{
    /* An even triangle is left through the side after the one that it was entered by, an odd one
     * through the side before it. */
    bool is_odd = true;
    int32_t triangle = neighbour(w, leave), enter = w->twin[leave];
    for (;;) {
        w->is_used[triangle] = 1;
        int32_t next = next_side(enter, triangle), previous = previous_side(enter, triangle);
        int32_t straight = is_odd ? previous : next, aside = is_odd ? next : previous;
        int32_t ahead = neighbour(w, straight), beside = neighbour(w, aside);
        if (is_free(w, ahead)) {
            pass_by(w, beside);
            is_odd = !is_odd;
            leave = straight;
            triangle = ahead;
        } else {
            if (!is_free(w, beside))
                break;
            /* The older vertex once more: this triangle then has the other parity. */
            w->out[0] = w->out[-2];
            w->out++;
            leave = aside;
            triangle = beside;
        }
        *w->out++ = w->corner[previous];
        enter = w->twin[leave];
    }
    *w->out++ = w->corner[previous_side(enter, triangle)];
}

static void add_strip(struct walker *w, int32_t triangle)
{
    w->is_used[triangle] = 1;
    int32_t leave = first_exit(w, triangle);
    int32_t exit = leave < 0 ? 3 * triangle : leave;
    int32_t next = next_side(exit, triangle), previous = previous_side(exit, triangle);
    w->out[0] = w->corner[previous];
    w->out[1] = w->corner[exit];
    w->out[2] = w->corner[next];
    w->out += 3;
    if (leave < 0)
        return;
    pass_by(w, neighbour(w, previous));
    pass_by(w, neighbour(w, next));
    walk(w, leave);
}

/* The triangle to start the next strip at; -1 when all are used. Triangles before *first are. */
static int32_t find_start(struct walker *w, int32_t triangle_count, int32_t *first)
{
    while (w->passed_count > 0) {
        int32_t triangle = w->passed[--w->passed_count];
        if (is_free(w, triangle))
            return triangle;
    }
    while (*first < triangle_count && w->is_used[*first])
        ++*first;
    return *first < triangle_count ? *first : -1;
}

static int64_t stripify(const struct mesh *mesh, void *scratch, void *output,
                        int64_t (*find_twins)(const struct mesh *, void *, void *))
{
    int64_t vertex_count = mesh->vertex_count, triangle_count = mesh->triangle_count;
    int32_t *indices = output, *twin = scratch;
    char *rest = scratch;
    rest += (twins_output_bytes(vertex_count, triangle_count) + 63) & ~(size_t)63;
    find_twins(mesh, rest, twin);
    /* Each strip passes by two triangles at its first and one at each further: at most 2 a
     * triangle, and 1 that is written but not kept. */
    struct walker w = {.corner = mesh->triangles, .twin = twin, .out = indices};
    w.none = mesh->triangle_count;
    w.passed = (int32_t *)(void *)rest;
    w.is_used = (uint8_t *)(w.passed + 2 * triangle_count + 1);
    memset(w.is_used, 0, (size_t)triangle_count);
    w.is_used[triangle_count] = 1;
    int32_t first = 0, start;
    while ((start = find_start(&w, mesh->triangle_count, &first)) >= 0) {
        if (w.out != indices)
            *w.out++ = STRIP_RESTART;
        add_strip(&w, start);
    }
    return w.out - indices;
}

int64_t stripify_plain(const struct mesh *mesh, void *scratch, void *output)
{
    return stripify(mesh, scratch, output, twins_plain);
}

#if defined(__x86_64__)
int64_t stripify_avx512(const struct mesh *mesh, void *scratch, void *output)
{
    return stripify(mesh, scratch, output, twins_avx512);
}
#endif

int64_t strips_join(const int32_t *indices, int64_t count, int32_t *joined)
{
    int64_t joined_count = 0;
    for (int64_t i = 0; i < count; i++) {
        if (indices[i] != STRIP_RESTART) {
            joined[joined_count++] = indices[i];
            continue;
        }
        /* The next strip has to start at an even place. */
        int32_t last = indices[i - 1], next = indices[i + 1];
        bool is_odd = joined_count % 2 == 1;
        joined[joined_count++] = last;
        joined[joined_count++] = next;
        if (is_odd)
            joined[joined_count++] = next;
    }
    return joined_count;
}

int64_t strips_triangles(const int32_t *indices, int64_t count, int32_t *triangles)
{
    int64_t triangle_count = 0, start = 0;
    for (int64_t i = 0; i < count; i++) {
        if (indices[i] == STRIP_RESTART)
            start = i + 1;
        if (i < start + 2)
            continue;
        int32_t a = indices[i - 2], b = indices[i - 1], c = indices[i];
        if (a == b || b == c || c == a)
            continue;
        bool is_odd = (i - start) % 2 == 1;
        int32_t *to = triangles + 3 * triangle_count++;
        to[0] = is_odd ? b : a;
        to[1] = is_odd ? a : b;
        to[2] = c;
    }
    return triangle_count;
}
