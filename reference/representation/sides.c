/* Twins by kernel or by bucketing on the smaller vertex, and one fan a vertex; see sides.h. */
#include "reference/representation/sides.h"

#include "reference/kernels/twins.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* One side as its bucket sees it. The bucket is the smaller of its two vertices. */
struct entry {
    int32_t other; /* the larger vertex when the side starts at the smaller one, else ~larger */
    int32_t side;
};

enum { SCAN_LIMIT = 32 }; /* longer buckets are matched by marks, so that no valence is quadratic */

struct polygons polygons_of_mesh(const struct mesh *mesh)
{
    return (struct polygons){mesh->triangles, NULL, mesh->vertex_count, mesh->triangle_count};
}

static int32_t larger_vertex(struct entry entry)
{
    return entry.other < 0 ? ~entry.other : entry.other;
}

/* -- faces that name a vertex twice --------------------------------------------------------- */

static int face_error(int32_t face, int32_t vertex, struct error *err)
{
    return error_set(err, "face %d is degenerate: it names vertex %d twice", face, vertex);
}

static int check_triangles(const struct polygons *polygons, struct error *err)
{
    for (int32_t f = 0; f < polygons->face_count; f++) {
        const int32_t *c = polygons->corners + 3 * (int64_t)f;
        if (c[0] == c[1] || c[0] == c[2])
            return face_error(f, c[0], err);
        if (c[1] == c[2])
            return face_error(f, c[1], err);
    }
    return 0;
}

/* `mark` has a place for every vertex, all 0 at first: 1 + the last face that named it. */
static int check_faces(const struct polygons *polygons, int32_t *mark, struct error *err)
{
    for (int32_t f = 0; f < polygons->face_count; f++)
        for (int32_t s = polygons_start(polygons, f); s < polygons_start(polygons, f + 1); s++) {
            if (mark[polygons->corners[s]] == f + 1)
                return face_error(f, polygons->corners[s], err);
            mark[polygons->corners[s]] = f + 1;
        }
    return 0;
}

/* -- twins ---------------------------------------------------------------------------------- */

static int32_t face_of_side(const struct polygons *polygons, int32_t side)
{
    if (!polygons->face_starts)
        return side / 3;
    int32_t low = 0, high = polygons->face_count - 1;
    while (low < high) {
        int32_t middle = low + (high - low + 1) / 2;
        if (polygons->face_starts[middle] <= side)
            low = middle;
        else
            high = middle - 1;
    }
    return low;
}

/* Sorts the sides into buckets; afterwards bucket v ends at end[v] and starts where v - 1 ends. */
static void fill_buckets(const struct polygons *polygons, int32_t *end, struct entry *entries)
{
    const int32_t *corners = polygons->corners;
    for (int32_t f = 0; f < polygons->face_count; f++) {
        int32_t first = polygons_start(polygons, f), stop = polygons_start(polygons, f + 1);
        for (int32_t s = first, from = corners[stop - 1]; s < stop; from = corners[s++])
            end[from < corners[s] ? from : corners[s]]++;
    }
    int32_t sum = 0;
    for (int32_t v = 0; v < polygons->vertex_count; v++) {
        int32_t count = end[v];
        end[v] = sum;
        sum += count;
    }
    for (int32_t f = 0; f < polygons->face_count; f++) {
        int32_t first = polygons_start(polygons, f), stop = polygons_start(polygons, f + 1);
        for (int32_t s = stop - 1, to = corners[first]; s >= first; to = corners[s--]) {
            int32_t from = corners[s];
            struct entry entry = {from < to ? to : ~from, s};
            entries[end[from < to ? from : to]++] = entry;
        }
    }
}

/* Makes two sides of one edge twins; false when the edge has more sides or they run alike. */
static bool join(struct entry a, struct entry b, int32_t *twin)
{
    bool fits = a.other != b.other && twin[a.side] < 0 && twin[b.side] < 0;
    twin[a.side] = b.side;
    twin[b.side] = a.side;
    return fits;
}

/* Both matchers return the larger vertex of an edge at fault, or -1. */
static int32_t match_by_scan(const struct entry *bucket, int32_t count, int32_t *twin)
{
    int32_t fault = -1;
    for (int32_t i = 1; i < count; i++)
        for (int32_t j = 0; j < i; j++)
            if (larger_vertex(bucket[j]) == larger_vertex(bucket[i]))
                if (!join(bucket[j], bucket[i], twin))
                    fault = larger_vertex(bucket[i]);
    return fault;
}

/* `mark` has a place for every vertex: 1 + the last entry that named it, 0 at first; entries of
 * earlier buckets are older than `first`. */
static int32_t match_by_marks(const struct entry *entries, int32_t first, int32_t stop,
                              int32_t *mark, int32_t *twin)
{
    int32_t fault = -1;
    for (int32_t i = first; i < stop; i++) {
        int32_t *last = mark + larger_vertex(entries[i]);
        if (*last > first && !join(entries[*last - 1], entries[i], twin))
            fault = larger_vertex(entries[i]);
        *last = i + 1;
    }
    return fault;
}

/* Says what is wrong with the edge low-high, all of whose sides are in the bucket. */
static int edge_error(const struct polygons *polygons, const struct entry *bucket, int32_t count,
                      int32_t low, int32_t high, struct error *err)
{
    int32_t uses = 0, first_face = INT32_MAX, last_face = -1;
    for (int32_t i = 0; i < count; i++) {
        if (larger_vertex(bucket[i]) != high)
            continue;
        int32_t face = face_of_side(polygons, bucket[i].side);
        first_face = face < first_face ? face : first_face;
        last_face = face > last_face ? face : last_face;
        uses++;
    }
    if (uses > 2)
        return error_set(err, "edge {%d, %d} is non-manifold: it has %d faces", low, high, uses);
    return error_set(err, "edge {%d, %d}: faces %d and %d run through it in the same direction",
                     low, high, first_face, last_face);
}

static int match_buckets(const struct polygons *polygons, const int32_t *end,
                         const struct entry *entries, int32_t *mark, int32_t *twin,
                         struct error *err)
{
    for (int32_t v = 0, first = 0; v < polygons->vertex_count; first = end[v++]) {
        int32_t count = end[v] - first;
        int32_t fault = count <= SCAN_LIMIT ? match_by_scan(entries + first, count, twin)
                                            : match_by_marks(entries, first, end[v], mark, twin);
        if (fault >= 0)
            return edge_error(polygons, entries + first, count, v, fault, err);
    }
    return 0;
}

static int check_corners(const struct polygons *polygons, int32_t *mark, struct error *err)
{
    if (!polygons->face_starts)
        return check_triangles(polygons, err);
    int result = check_faces(polygons, mark, err);
    memset(mark, 0, (size_t)polygons->vertex_count * sizeof *mark);
    return result;
}

/* Any faces; names what is wrong. */
static int match_faces(const struct polygons *polygons, int32_t *twin, struct error *err)
{
    size_t vertex_count = (size_t)polygons->vertex_count;
    size_t side_count = (size_t)polygons_side_count(polygons);
    int32_t *end = calloc(vertex_count + 1, sizeof *end);
    int32_t *mark = calloc(vertex_count + 1, sizeof *mark); /* touched by long buckets only */
    struct entry *entries = calloc(side_count + 1, sizeof *entries);
    int result = -1;
    if (!end || !mark || !entries) {
        error_set(err, "out of memory: matching the sides of %d faces", polygons->face_count);
    } else if (!check_corners(polygons, mark, err)) {
        memset(twin, -1, side_count * sizeof *twin);
        fill_buckets(polygons, end, entries);
        result = match_buckets(polygons, end, entries, mark, twin, err);
    }
    free(end);
    free(mark);
    free(entries);
    return result;
}

/* Whether the kernel's answer is beyond doubt: no edge has many sides, and no two boundary sides
 * leave one vertex, as they do where two triangles run through an edge in the same direction. */
static bool is_beyond_doubt(const struct polygons *polygons, const int32_t *twin, uint8_t *has_side)
{
    for (int32_t s = 0; s < 3 * polygons->face_count; s++) {
        if (twin[s] >= 0)
            continue;
        if (twin[s] == TWIN_MANY || has_side[polygons->corners[s]])
            return false;
        has_side[polygons->corners[s]] = 1;
    }
    return true;
}

/* Triangles, by the fastest kernel. Returns whether all is well; what is not, it cannot name. */
static bool match_triangles(const struct polygons *polygons, int32_t *twin)
{
    const struct kernel *kernel = kernel_find("twins", NULL);
    int64_t vertices = polygons->vertex_count, triangles = polygons->face_count;
    struct mesh mesh = {.vertex_count = polygons->vertex_count,
                        .triangle_count = polygons->face_count};
    memcpy(&mesh.triangles, &polygons->corners, sizeof mesh.triangles); /* which it only reads */
    size_t scratch_bytes = kernel->scratch_bytes(vertices, triangles);
    size_t output_bytes = kernel->output_bytes(vertices, triangles);
    void *scratch = aligned_alloc(64, (scratch_bytes / 64 + 1) * 64);
    int32_t *output = aligned_alloc(64, (output_bytes / 64 + 1) * 64);
    uint8_t *has_side = calloc((size_t)vertices + 1, 1);
    bool is_done = false;
    if (scratch && output && has_side) {
        kernel->run(&mesh, scratch, output);
        is_done = is_beyond_doubt(polygons, output, has_side);
        if (is_done && triangles > 0)
            memcpy(twin, output, 3 * (size_t)triangles * sizeof *twin);
    }
    free(scratch);
    free(output);
    free(has_side);
    return is_done;
}

int sides_match(const struct polygons *polygons, int32_t *twin, struct error *err)
{
    if (!polygons->face_starts) {
        if (check_triangles(polygons, err))
            return -1;
        if (match_triangles(polygons, twin))
            return 0;
    }
    return match_faces(polygons, twin, err);
}

/* -- fans ----------------------------------------------------------------------------------- */

/* The side before each side in its face; only for faces that are not all triangles. */
static void list_previous(const struct polygons *polygons, int32_t *previous)
{
    for (int32_t f = 0; f < polygons->face_count; f++) {
        int32_t last = polygons_start(polygons, f + 1) - 1;
        for (int32_t s = polygons_start(polygons, f); s <= last; s++)
            previous[s] = s == polygons_start(polygons, f) ? last : s - 1;
    }
}

enum { TOGETHER = 16 }; /* fans that are walked at the same time, so that cache misses overlap */

/* Turns counter-clockwise around each of `count` vertices from `first` on until the boundary or the
 * start of the fan; length[i] is how many sides that meets. */
static void walk_fans(int32_t first, int32_t count, const int32_t *fan, const int32_t *twin,
                      const int32_t *previous, int32_t *length)
{
    int32_t side[TOGETHER], vertex[TOGETHER], walking = 0;
    for (int32_t i = 0; i < count; i++) {
        length[i] = 0;
        if (fan[first + i] < 0)
            continue;
        vertex[walking] = i;
        side[walking++] = fan[first + i];
    }
    while (walking > 0)
        for (int32_t i = 0; i < walking; i++) {
            int32_t s = side[i];
            length[vertex[i]]++;
            side[i] = twin[previous ? previous[s] : s % 3 ? s - 1 : s + 2];
            if (side[i] < 0 || side[i] == fan[first + vertex[i]]) { /* the last takes its place */
                walking--;
                vertex[i] = vertex[walking];
                side[i] = side[walking];
                i--;
            }
        }
}

static int find_fans(const struct polygons *polygons, const int32_t *twin, const int32_t *previous,
                     int32_t *corner_count, int32_t *fan, struct error *err)
{
    for (int32_t s = 0; s < polygons_side_count(polygons); s++) {
        int32_t v = polygons->corners[s];
        if (twin[s] < 0 || fan[v] < 0)
            fan[v] = s;
        corner_count[v]++;
    }
    for (int32_t v = 0; v < polygons->vertex_count; v += TOGETHER) {
        int32_t left = polygons->vertex_count - v, length[TOGETHER];
        int32_t count = left < TOGETHER ? left : TOGETHER;
        walk_fans(v, count, fan, twin, previous, length);
        for (int32_t i = 0; i < count; i++)
            if (length[i] != corner_count[v + i])
                return error_set(err, "vertex %d is non-manifold: its %d faces are not one fan",
                                 v + i, corner_count[v + i]);
    }
    return 0;
}

int sides_fans(const struct polygons *polygons, const int32_t *twin, int32_t *fan,
               struct error *err)
{
    size_t vertex_count = (size_t)polygons->vertex_count;
    size_t side_count = (size_t)polygons_side_count(polygons);
    int32_t *corner_count = calloc(vertex_count + 1, sizeof *corner_count);
    int32_t *previous = NULL;
    if (polygons->face_starts)
        previous = malloc((side_count + 1) * sizeof *previous);
    int result = -1;
    if (!corner_count || (polygons->face_starts && !previous)) {
        error_set(err, "out of memory: the fans of %d vertices", polygons->vertex_count);
    } else {
        if (previous)
            list_previous(polygons, previous);
        memset(fan, -1, vertex_count * sizeof *fan);
        result = find_fans(polygons, twin, previous, corner_count, fan, err);
    }
    free(corner_count);
    free(previous);
    return result;
}
