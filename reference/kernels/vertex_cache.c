/* Tipsify, and vertices by first use; see vertex_cache.h. */
#include "reference/kernels/vertex_cache.h"

#include <stdlib.h>
#include <string.h>

static size_t rounded(size_t byte_count)
{
    return (byte_count + 63) & ~(size_t)63;
}

/* What tipsify keeps of a vertex. */
struct vertex_state {
    int32_t end;  /* of its row of triangles; it begins where that of the vertex before ends */
    int32_t live; /* its triangles that are not yet out */
    int32_t time; /* when it last entered the cache, in vertices entered so far */
};

size_t vertex_cache_scratch_bytes(int64_t vertex_count, int64_t triangle_count)
{
    return rounded((size_t)vertex_count * sizeof(struct vertex_state)) +
           rounded(12 * (size_t)triangle_count) * 2 + rounded((size_t)triangle_count);
}

size_t vertex_cache_output_bytes(int64_t vertex_count, int64_t triangle_count)
{
    (void)vertex_count;
    return 12 * (size_t)triangle_count + 64;
}

int64_t vertex_cache_moved_bytes(int64_t vertex_count, int64_t triangle_count,
                                 int64_t triangle_records)
{
    (void)vertex_count;
    return 12 * triangle_count + 12 * triangle_records;
}

struct tipsify {
    const struct mesh *mesh;
    struct vertex_state *vertex;
    int32_t *row;     /* triangles by vertex */
    int32_t *visited; /* vertices of the triangles that are out, latest last */
    uint8_t *is_out;  /* of each triangle */
    int32_t *to;      /* where the next triangle goes */
    int64_t visited_count;
    int32_t time, cursor; /* vertices before the cursor have no triangle left */
};

static void fill_rows(struct tipsify *s)
{
    const struct mesh *mesh = s->mesh;
    for (int32_t v = 0; v < mesh->vertex_count; v++)
        s->vertex[v] = (struct vertex_state){0, 0, -VERTEX_CACHE_SIZE - 1};
    for (int64_t i = 0; i < 3 * (int64_t)mesh->triangle_count; i++)
        s->vertex[mesh->triangles[i]].live++;
    int32_t total = 0;
    for (int32_t v = 0; v < mesh->vertex_count; v++) {
        s->vertex[v].end = total;
        total += s->vertex[v].live;
    }
    for (int32_t t = 0; t < mesh->triangle_count; t++)
        for (int corner = 0; corner < 3; corner++)
            s->row[s->vertex[mesh->triangles[3 * (int64_t)t + corner]].end++] = t;
}

static void put_out(struct tipsify *s, int32_t triangle)
{
    const int32_t *corner = s->mesh->triangles + 3 * (int64_t)triangle;
    s->is_out[triangle] = 1;
    for (int c = 0; c < 3; c++) {
        struct vertex_state *vertex = &s->vertex[corner[c]];
        *s->to++ = corner[c];
        s->visited[s->visited_count++] = corner[c];
        vertex->live--;
        if (s->time - vertex->time > VERTEX_CACHE_SIZE)
            vertex->time = s->time++;
    }
}

/* Of the vertices of the latest fan, that which will stay in the cache until its own fan is done
 * and has been there longest; else any with triangles left; -1 when there is none. */
static int32_t best_of_fan(const struct tipsify *s, int64_t from)
{
    int32_t best = -1, best_age = -1;
    for (int64_t i = from; i < s->visited_count; i++) {
        const struct vertex_state *vertex = &s->vertex[s->visited[i]];
        if (vertex->live == 0)
            continue;
        int32_t age = s->time - vertex->time;
        if (age + 2 * vertex->live > VERTEX_CACHE_SIZE)
            age = 0;
        if (age > best_age) {
            best_age = age;
            best = s->visited[i];
        }
    }
    return best;
}

/* Where to go on when the fan has nothing left: the latest vertex that has, else the first. */
static int32_t after_dead_end(struct tipsify *s)
{
    while (s->visited_count > 0) {
        int32_t v = s->visited[--s->visited_count];
        if (s->vertex[v].live > 0)
            return v;
    }
    while (s->cursor < s->mesh->vertex_count && s->vertex[s->cursor].live == 0)
        s->cursor++;
    return s->cursor < s->mesh->vertex_count ? s->cursor : -1;
}

int64_t vertex_cache_plain(const struct mesh *mesh, void *scratch, void *output)
{
    size_t vertex_bytes = (size_t)mesh->vertex_count * sizeof(struct vertex_state);
    size_t corner_bytes = rounded(12 * (size_t)mesh->triangle_count);
    char *memory = scratch;
    struct tipsify s = {.mesh = mesh, .vertex = scratch, .to = output};
    memory += rounded(vertex_bytes);
    s.row = (int32_t *)(void *)memory;
    s.visited = (int32_t *)(void *)(memory + corner_bytes);
    s.is_out = (uint8_t *)(memory + 2 * corner_bytes);
    memset(s.is_out, 0, (size_t)mesh->triangle_count);
    fill_rows(&s);
    for (int32_t v = after_dead_end(&s); v >= 0;) {
        int64_t fan = s.visited_count;
        for (int32_t i = v > 0 ? s.vertex[v - 1].end : 0; i < s.vertex[v].end; i++)
            if (!s.is_out[s.row[i]])
                put_out(&s, s.row[i]);
        v = best_of_fan(&s, fan);
        if (v < 0)
            v = after_dead_end(&s);
    }
    return mesh->triangle_count;
}

/* -- vertices --------------------------------------------------------------------------------- */

size_t vertex_fetch_output_bytes(int64_t vertex_count, int64_t triangle_count)
{
    (void)triangle_count;
    return 4 * (size_t)vertex_count + 64;
}

int64_t vertex_fetch_moved_bytes(int64_t vertex_count, int64_t triangle_count,
                                 int64_t vertex_records)
{
    (void)vertex_count;
    return 12 * triangle_count + 4 * vertex_records;
}

int64_t vertex_fetch_plain(const struct mesh *mesh, void *scratch, void *output)
{
    (void)scratch;
    int32_t *number = output, next = 0;
    for (int32_t v = 0; v < mesh->vertex_count; v++)
        number[v] = -1;
    for (int64_t i = 0; i < 3 * (int64_t)mesh->triangle_count; i++)
        if (number[mesh->triangles[i]] < 0)
            number[mesh->triangles[i]] = next++;
    for (int32_t v = 0; v < mesh->vertex_count; v++)
        if (number[v] < 0)
            number[v] = next++;
    return mesh->vertex_count;
}

/* -- both ------------------------------------------------------------------------------------- */

int64_t vertex_cache_misses(const struct mesh *mesh, int64_t cache_size, int64_t *scratch)
{
    int64_t misses = 0;
    for (int32_t v = 0; v < mesh->vertex_count; v++)
        scratch[v] = -cache_size - 1;
    for (int64_t i = 0; i < 3 * (int64_t)mesh->triangle_count; i++) {
        int64_t *entered = &scratch[mesh->triangles[i]];
        if (misses - *entered > cache_size)
            *entered = misses++;
    }
    return misses;
}

/* Renumbers the vertices in place of `mesh`, whose triangles are in their new order already. */
static void renumber(struct mesh *mesh, const int32_t *number, const float *old)
{
    for (int64_t v = 0; v < mesh->vertex_count; v++)
        memcpy(mesh->positions + 3 * (int64_t)number[v], old + 3 * v, 3 * sizeof *old);
    for (int64_t i = 0; i < 3 * (int64_t)mesh->triangle_count; i++)
        mesh->triangles[i] = number[mesh->triangles[i]];
}

int vertex_cache_order(struct mesh *mesh, struct error *err)
{
    int64_t vertex_count = mesh->vertex_count, triangle_count = mesh->triangle_count;
    size_t position_bytes = 12 * (size_t)vertex_count;
    size_t triangle_bytes = vertex_cache_output_bytes(vertex_count, triangle_count);
    void *scratch =
        aligned_alloc(64, rounded(vertex_cache_scratch_bytes(vertex_count, triangle_count) + 1));
    void *triangles = aligned_alloc(64, rounded(triangle_bytes));
    int32_t *number = aligned_alloc(64, rounded(vertex_fetch_output_bytes(vertex_count, 0)));
    float *old = malloc(position_bytes + 1);
    int result = 0;
    if (!scratch || !triangles || !number || !old) {
        result = error_set(err, "out of memory: ordering %d triangles for the vertex cache",
                           mesh->triangle_count);
    } else if (triangle_count > 0) {
        vertex_cache_plain(mesh, scratch, triangles);
        memcpy(mesh->triangles, triangles, 12 * (size_t)triangle_count);
        memcpy(old, mesh->positions, position_bytes);
        vertex_fetch_plain(mesh, NULL, number);
        renumber(mesh, number, old);
    }
    free(scratch);
    free(triangles);
    free(number);
    free(old);
    return result;
}
