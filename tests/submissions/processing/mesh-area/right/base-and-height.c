/* Half of the longest side times the height above it, which is what is left of another side when
 * its part along the base is taken away. */
#include "mesh-area.h"

#include <math.h>
#include <stddef.h>

struct vector {
    double x, y, z;
};

static struct vector between(const float *from, const float *to)
{
    struct vector v = {(double)to[0] - (double)from[0], (double)to[1] - (double)from[1],
                       (double)to[2] - (double)from[2]};
    return v;
}

static double dot(struct vector u, struct vector v)
{
    return u.x * v.x + u.y * v.y + u.z * v.z;
}

static double half_base_height(struct vector base, struct vector side)
{
    double square = dot(base, base);
    if (square == 0)
        return 0;
    double along = dot(side, base) / square;
    struct vector height = {side.x - along * base.x, side.y - along * base.y,
                            side.z - along * base.z};
    return 0.5 * sqrt(square) * sqrt(dot(height, height));
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
        struct vector ab = between(a, b), bc = between(b, c), ca = between(c, a);
        double squares[3] = {dot(ab, ab), dot(bc, bc), dot(ca, ca)};
        if (squares[0] >= squares[1] && squares[0] >= squares[2])
            area += half_base_height(ab, bc);
        else if (squares[1] >= squares[2])
            area += half_base_height(bc, ca);
        else
            area += half_base_height(ca, ab);
    }
    return area;
}
