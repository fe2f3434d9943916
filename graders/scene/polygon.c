/* Meshes of polygons; see scene.h and polygon.h. */
#include "graders/scene/polygon.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { EARS_LIMIT = 2000, CORNERS_LIMIT = 1 << 28 };

/* A polygon laid flat: the two coordinates along which it is seen largest, counter-clockwise. */
struct flat {
    const float *positions;
    int along, across; /* coordinates 0, 1, 2 */
};

static const float *corner_at(const float *positions, int32_t vertex)
{
    return positions + 3 * (size_t)vertex;
}

static double gap(const float *from, const float *to, int coordinate)
{
    return (double)to[coordinate] - (double)from[coordinate];
}

/* By Newell's normal: the direction from which the polygon is seen largest. */
static struct flat flat_of(const float *positions, const int32_t *corners, int32_t n)
{
    double normal[3] = {0};
    const float *origin = corner_at(positions, corners[0]);
    for (int32_t i = 0; i < n; i++) {
        const float *p = corner_at(positions, corners[i]);
        const float *q = corner_at(positions, corners[(i + 1) % n]);
        for (int k = 0; k < 3; k++) {
            int u = (k + 1) % 3, v = (k + 2) % 3;
            normal[k] +=
                gap(origin, p, u) * gap(origin, q, v) - gap(origin, p, v) * gap(origin, q, u);
        }
    }
    int down = 0;
    for (int k = 1; k < 3; k++)
        down = fabs(normal[k]) > fabs(normal[down]) ? k : down;
    int u = (down + 1) % 3, v = (down + 2) % 3;
    return normal[down] < 0 ? (struct flat){positions, v, u} : (struct flat){positions, u, v};
}

/* Twice the area of a triangle, positive when it is counter-clockwise. */
static double turn(const struct flat *flat, int32_t a, int32_t b, int32_t c)
{
    const float *p = corner_at(flat->positions, a), *q = corner_at(flat->positions, b);
    const float *r = corner_at(flat->positions, c);
    int u = flat->along, v = flat->across;
    return gap(p, q, u) * gap(p, r, v) - gap(p, q, v) * gap(p, r, u);
}

/* Whether corner i of what is left can be cut off: it turns left, and no other corner lies in it.
 */
static bool is_ear(const struct flat *flat, const int32_t *left, int32_t count, int32_t i)
{
    int32_t a = left[(i + count - 1) % count], b = left[i], c = left[(i + 1) % count];
    if (!(turn(flat, a, b, c) > 0))
        return false;
    for (int32_t j = 0; j < count; j++) {
        int32_t p = left[j];
        if (p != a && p != b && p != c && turn(flat, a, b, p) >= 0 && turn(flat, b, c, p) >= 0 &&
            turn(flat, c, a, p) >= 0)
            return false;
    }
    return true;
}

static int32_t find_ear(const struct flat *flat, const int32_t *left, int32_t count, int32_t from)
{
    for (int32_t step = 0; step < count; step++)
        if (is_ear(flat, left, count, (from + step) % count))
            return (from + step) % count;
    return -1;
}

static bool is_convex(const struct flat *flat, const int32_t *corners, int32_t n)
{
    for (int32_t i = 0; i < n; i++)
        if (!(turn(flat, corners[i], corners[(i + 1) % n], corners[(i + 2) % n]) > 0))
            return false;
    return true;
}

static int32_t *put(int32_t *to, int32_t a, int32_t b, int32_t c)
{
    to[0] = a;
    to[1] = b;
    to[2] = c;
    return to + 3;
}

static int32_t *put_fan(int32_t *to, const int32_t *corners, int32_t n)
{
    for (int32_t i = 1; i + 1 < n; i++)
        to = put(to, corners[0], corners[i], corners[i + 1]);
    return to;
}

void polygon_triangles(const float *positions, const int32_t *corners, int32_t n, int32_t *rest,
                       int32_t *triangles)
{
    struct flat flat = flat_of(positions, corners, n);
    if (n == 3 || n > EARS_LIMIT || is_convex(&flat, corners, n)) {
        put_fan(triangles, corners, n);
        return;
    }
    memcpy(rest, corners, sizeof *rest * (size_t)n);
    int32_t count = n, from = 0;
    while (count > 3) {
        int32_t ear = find_ear(&flat, rest, count, from);
        if (ear < 0)
            break;
        triangles =
            put(triangles, rest[(ear + count - 1) % count], rest[ear], rest[(ear + 1) % count]);
        memmove(rest + ear, rest + ear + 1, sizeof *rest * (size_t)(count - ear - 1));
        count--;
        from = ear; /* what was the next corner: ears are cut all round, and not as a fan */
    }
    put_fan(triangles, rest, count);
}

int polygons_check(const int32_t *first_corner, const int32_t *corners, int64_t face_count,
                   int64_t vertex_count, struct error *err)
{
    if (face_count < 0 || face_count >= INT32_MAX || vertex_count < 0 || vertex_count > INT32_MAX)
        return error_set(err, "a scene cannot have %lld faces and %lld vertices",
                         (long long)face_count, (long long)vertex_count);
    if (face_count > 0 && first_corner[0] != 0)
        return error_set(err, "face 0 of a scene begins at corner %d, not 0", first_corner[0]);
    for (int64_t f = 0; f < face_count; f++) {
        int64_t size = (int64_t)first_corner[f + 1] - first_corner[f];
        if (size < 3 || first_corner[f + 1] > CORNERS_LIMIT)
            return error_set(err, "face %lld of a scene has %lld corners", (long long)f,
                             (long long)size);
        for (int32_t c = first_corner[f]; c < first_corner[f + 1]; c++)
            if (corners[c] < 0 || corners[c] >= vertex_count)
                return error_set(err, "face %lld of a scene names vertex %d of %lld", (long long)f,
                                 corners[c], (long long)vertex_count);
    }
    return 0;
}

void scene_faces_release(struct scene_faces *faces)
{
    free(faces->first_corner);
    free(faces->corners);
    *faces = (struct scene_faces){0};
}

static int copy_faces(struct scene_faces *to, const int32_t *first_corner, const int32_t *corners,
                      int32_t face_count, struct error *err)
{
    size_t firsts = (size_t)face_count + 1, all = face_count ? (size_t)first_corner[face_count] : 0;
    to->first_corner = calloc(firsts, sizeof *first_corner);
    to->corners = malloc((all + 1) * sizeof *corners);
    if (!to->first_corner || !to->corners) {
        scene_faces_release(to);
        error_set(err, "out of memory for %d polygons of a scene", face_count);
        return -1;
    }
    if (face_count > 0) {
        memcpy(to->first_corner, first_corner, firsts * sizeof *first_corner);
        memcpy(to->corners, corners, all * sizeof *corners);
    }
    to->count = face_count;
    return 0;
}

/* The triangles of all faces, 3 * scene_triangles_before(faces, count) of them; NULL: no memory. */
static int32_t *triangles_of(const float *positions, const struct scene_faces *faces)
{
    int32_t longest = 0;
    for (int32_t f = 0; f < faces->count; f++) {
        int32_t n = faces->first_corner[f + 1] - faces->first_corner[f];
        longest = n > longest ? n : longest;
    }
    size_t count = (size_t)scene_triangles_before(faces, faces->count);
    int32_t *triangles = malloc((3 * count + 1) * sizeof *triangles);
    int32_t *rest = malloc(((size_t)longest + 1) * sizeof *rest);
    for (int32_t f = 0; triangles && rest && f < faces->count; f++)
        polygon_triangles(positions, faces->corners + faces->first_corner[f],
                          faces->first_corner[f + 1] - faces->first_corner[f], rest,
                          triangles + 3 * (size_t)scene_triangles_before(faces, f));
    if (!rest) {
        free(triangles);
        triangles = NULL;
    }
    free(rest);
    return triangles;
}

int scene_set_polygons(struct scene *scene, const float *positions, int64_t vertex_count,
                       const int32_t *first_corner, const int32_t *corners, int64_t face_count,
                       struct error *err)
{
    struct scene_faces faces = {0};
    if (polygons_check(first_corner, corners, face_count, vertex_count, err) ||
        copy_faces(&faces, first_corner, corners, (int32_t)face_count, err))
        return -1;
    int32_t *triangles = triangles_of(positions, &faces);
    int failed = triangles ? scene_set_mesh(scene, positions, vertex_count, triangles,
                                            scene_triangles_before(&faces, faces.count), err)
                           : error_set(err, "out of memory for the polygons of a scene");
    free(triangles);
    if (failed)
        scene_faces_release(&faces);
    else
        scene->faces = faces;
    return failed;
}

int32_t scene_triangles_before(const struct scene_faces *faces, int32_t face)
{
    return faces->first_corner[face] - 2 * face;
}
