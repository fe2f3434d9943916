/* Twins by bucketing on the smaller vertex, and one fan a vertex; see sides.h. */
#include "reference/representation/sides.h"

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

int sides_match(const struct polygons *polygons, int32_t *twin, struct error *err)
{
    size_t vertex_count = (size_t)polygons->vertex_count;
    size_t side_count = (size_t)polygons_side_count(polygons);
    int32_t *end = calloc(vertex_count + 1, sizeof *end);
    int32_t *mark = calloc(vertex_count + 1, sizeof *mark); /* touched by long buckets only */
    struct entry *entries = malloc((side_count + 1) * sizeof *entries);
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

/* Sides met from `first` on, turning counter-clockwise until the boundary or `first` again. */
static int32_t fan_length(int32_t first, const int32_t *twin, const int32_t *previous)
{
    int32_t length = 0, side = first;
    do {
        length++;
        side = twin[previous ? previous[side] : side % 3 ? side - 1 : side + 2];
    } while (side >= 0 && side != first);
    return length;
}

static int find_fans(const struct polygons *polygons, const int32_t *twin, const int32_t *previous,
                     int32_t *corner_count, int32_t *fan, struct error *err)
{
    for (int32_t s = polygons_side_count(polygons) - 1; s >= 0; s--) {
        int32_t v = polygons->corners[s];
        if (twin[s] < 0 || fan[v] < 0 || twin[fan[v]] >= 0)
            fan[v] = s;
        corner_count[v]++;
    }
    for (int32_t v = 0; v < polygons->vertex_count; v++)
        if (fan[v] >= 0 && fan_length(fan[v], twin, previous) != corner_count[v])
            return error_set(err, "vertex %d is non-manifold: its %d faces are not one fan", v,
                             corner_count[v]);
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
