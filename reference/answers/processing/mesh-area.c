/* Problem 4.6: half the length of the cross product of two sides, summed.
 *
 * Everything after the reading of the positions is binary64: differences of binary32 coordinates
 * are then exact or nearly so, which keeps needles and meshes far from the origin right, and ten
 * million terms add up without losing digits that matter. */
#include "mesh-area.h"

#include <math.h>
#include <stddef.h>

struct vector {
    double x, y, z;
};

static struct vector vector_from(const float *from, const float *to)
{
    return (struct vector){(double)to[0] - (double)from[0], (double)to[1] - (double)from[1],
                           (double)to[2] - (double)from[2]};
}

static double cross_length(struct vector u, struct vector v)
{
    double x = u.y * v.z - u.z * v.y;
    double y = u.z * v.x - u.x * v.z;
    double z = u.x * v.y - u.y * v.x;
    return sqrt(x * x + y * y + z * z);
}

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    (void)vertex_count;
    double twice_area = 0;
    for (size_t t = 0; t < 3 * (size_t)triangle_count; t += 3) {
        const float *a = vertices + 3 * (size_t)triangles[t];
        const float *b = vertices + 3 * (size_t)triangles[t + 1];
        const float *c = vertices + 3 * (size_t)triangles[t + 2];
        twice_area += cross_length(vector_from(a, b), vector_from(a, c));
    }
    return 0.5 * twice_area;
}
