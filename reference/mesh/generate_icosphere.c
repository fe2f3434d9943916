/* The icosphere: an icosahedron whose triangles are split in four, again and again. See generate.h.
 */
#include "reference/mesh/generate.h"

#include "reference/mesh/builder.h"

#include <math.h>
#include <stdlib.h>

/* The edges of one vertex of a mesh whose valences are at most 6: neighbour and midpoint. */
struct spokes {
    int32_t neighbour[6];
    int32_t midpoint[6];
    int count;
};

/* On the sphere of radius 1/2. */
static void add_projected(struct builder *b, double x, double y, double z)
{
    double scale = 0.5 / sqrt(x * x + y * y + z * z);
    add_vertex(b, x * scale, y * scale, z * scale);
}

/* Three golden rectangles, each in a coordinate plane. */
static void add_icosahedron(struct builder *b)
{
    static const signed char faces[20][3] = {
        {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
        {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
        {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    const double golden = (1.0 + sqrt(5.0)) / 2.0;
    for (int plane = 0; plane < 3; plane++)
        for (int i = 0; i < 4; i++) {
            double p[3] = {0};
            p[plane] = i % 2 == 0 ? -1.0 : 1.0;
            p[(plane + 1) % 3] = i < 2 ? golden : -golden;
            add_projected(b, p[0], p[1], p[2]);
        }
    for (int f = 0; f < 20; f++)
        add_triangle(b, faces[f][0], faces[f][1], faces[f][2]);
}

/* The vertex in the middle of edge a b: made at the first call, found again at the second. */
static int32_t midpoint(struct builder *builder, struct spokes *spokes, int32_t a, int32_t b)
{
    struct spokes *s = &spokes[a < b ? a : b];
    int32_t other = a < b ? b : a;
    for (int i = 0; i < s->count; i++)
        if (s->neighbour[i] == other)
            return s->midpoint[i];
    int32_t made = (int32_t)builder->vertex_count;
    s->neighbour[s->count] = other;
    s->midpoint[s->count++] = made;
    const float *p = builder->mesh->positions + 3 * (int64_t)a;
    const float *q = builder->mesh->positions + 3 * (int64_t)b;
    add_projected(builder, (double)p[0] + (double)q[0], (double)p[1] + (double)q[1],
                  (double)p[2] + (double)q[2]);
    return made;
}

/* Triangle t becomes 4 t ... 4 t + 3; from the last to the first, so that none is overwritten. */
static void split_all(struct builder *b, struct spokes *spokes)
{
    int32_t *triangles = b->mesh->triangles;
    int64_t count = b->triangle_count;
    for (int64_t t = count - 1; t >= 0; t--) {
        int32_t p = triangles[3 * t], q = triangles[3 * t + 1], r = triangles[3 * t + 2];
        int32_t pq = midpoint(b, spokes, p, q);
        int32_t qr = midpoint(b, spokes, q, r);
        int32_t rp = midpoint(b, spokes, r, p);
        b->triangle_count = 4 * t;
        add_triangle(b, p, pq, rp);
        add_triangle(b, pq, q, qr);
        add_triangle(b, rp, qr, r);
        add_triangle(b, pq, qr, rp);
    }
    b->triangle_count = 4 * count;
}

int generate_icosphere(struct mesh *mesh, int levels, struct error *err)
{
    *mesh = (struct mesh){0};
    if (levels < 0 || levels > 9)
        return error_set(err, "generating an icosphere: %d levels, it must be 0 to 9", levels);
    int64_t triangle_count = 20 * (INT64_C(1) << (2 * levels));
    if (mesh_init(mesh, triangle_count / 2 + 2, triangle_count, err))
        return -1;
    struct builder b = {.mesh = mesh};
    add_icosahedron(&b);
    for (int level = 0; level < levels; level++) {
        struct spokes *spokes = calloc((size_t)b.vertex_count, sizeof *spokes);
        if (!spokes) {
            mesh_release(mesh);
            return error_set(err, "out of memory: splitting %lld triangles",
                             (long long)b.triangle_count);
        }
        split_all(&b, spokes);
        free(spokes);
    }
    return 0;
}
