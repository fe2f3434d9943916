/* Areas of known growth. BASE, EXTRA and SHARE are defined in front of this text by known.c, which
 * lists what they mean. */
#include "mesh-area.h"

#include <math.h>
#include <stddef.h>

static double side(const float *a, const float *b)
{
    double x = (double)b[0] - (double)a[0], y = (double)b[1] - (double)a[1];
    double z = (double)b[2] - (double)a[2];
    return sqrt(x * x + y * y + z * z);
}

static double area_by_cross_product(const float *a, const float *b, const float *c)
{
    double u[3], v[3];
    for (int i = 0; i < 3; i++) {
        u[i] = (double)b[i] - (double)a[i];
        v[i] = (double)c[i] - (double)a[i];
    }
    double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2];
    double z = u[0] * v[1] - u[1] * v[0];
    return sqrt(x * x + y * y + z * z) / 2;
}

/* Side times height: the foot of the height by projection. */
static double area_by_height(const float *a, const float *b, const float *c)
{
    double length = side(a, b), along = 0, foot[3], square = 0;
    if (length == 0)
        return 0;
    for (int i = 0; i < 3; i++)
        along += ((double)c[i] - (double)a[i]) * ((double)b[i] - (double)a[i]);
    along /= length * length;
    for (int i = 0; i < 3; i++) {
        foot[i] = (double)a[i] + along * ((double)b[i] - (double)a[i]);
        square += ((double)c[i] - foot[i]) * ((double)c[i] - foot[i]);
    }
    return length * sqrt(square) / 2;
}

static double work_of(const float *vertices, const int32_t *triangles, size_t count)
{
    double sum = 0;
    size_t root = 1;
    while (root * root < count)
        root++;
    for (size_t i = 0; i < count; i++) {
        size_t first = EXTRA == 1 ? i % SHARE : 0, step = EXTRA == 1 ? SHARE : 1;
        size_t end = EXTRA == 1 ? count : EXTRA == 2 ? root * SHARE : EXTRA == 3 ? i / SHARE : 0;
        if (EXTRA == 4) /* from SHARE triangles on, a further pass */
            end = count >= SHARE ? 8 : 0;
        for (size_t j = first; j < end && j < count; j += step)
            sum += (double)vertices[3 * (size_t)triangles[3 * j]];
    }
    return sum;
}

static volatile double sink;

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    (void)vertex_count;
    double area = 0, lost = 0;
    if (EXTRA)
        sink = work_of(vertices, triangles, (size_t)triangle_count);
    for (size_t t = 0; t < (size_t)triangle_count; t++) {
        const float *a = vertices + 3 * (size_t)triangles[3 * t];
        const float *b = vertices + 3 * (size_t)triangles[3 * t + 1];
        const float *c = vertices + 3 * (size_t)triangles[3 * t + 2];
        double term = BASE == 1 ? area_by_height(a, b, c) : area_by_cross_product(a, b, c);
        if (BASE == 2) { /* compensated summation */
            double corrected = term - lost, larger = area + corrected;
            lost = (larger - area) - corrected;
            area = larger;
        } else
            area += term;
    }
    return area;
}
