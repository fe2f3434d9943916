/* Splits every triangle in four, twice, and adds the areas of the 16 parts.
 * expect: too-much-work */
#include "mesh-area.h"

#include <math.h>
#include <stddef.h>

struct point {
    double x, y, z;
};

static struct point middle(struct point p, struct point q)
{
    struct point m = {(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
    return m;
}

static double area_of(struct point a, struct point b, struct point c, int splits)
{
    if (splits > 0) {
        struct point p = middle(a, b), q = middle(b, c), r = middle(c, a);
        return area_of(a, p, r, splits - 1) + area_of(p, b, q, splits - 1) +
               area_of(r, q, c, splits - 1) + area_of(p, q, r, splits - 1);
    }
    double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
    double vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
    double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    return 0.5 * sqrt(x * x + y * y + z * z);
}

static struct point point_at(const float *position)
{
    struct point p = {(double)position[0], (double)position[1], (double)position[2]};
    return p;
}

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    (void)vertex_count;
    double area = 0;
    for (int32_t t = 0; t < triangle_count; t++) {
        const float *a = vertices + 3 * (size_t)triangles[3 * (size_t)t];
        const float *b = vertices + 3 * (size_t)triangles[3 * (size_t)t + 1];
        const float *c = vertices + 3 * (size_t)triangles[3 * (size_t)t + 2];
        area += area_of(point_at(a), point_at(b), point_at(c), 2);
    }
    return area;
}
