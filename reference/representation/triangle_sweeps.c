/* Plain loops over triangles; see triangle_sweeps.h. */
#include "reference/representation/triangle_sweeps.h"

#include <math.h>

int64_t positions_transform(float *positions, int64_t count, const float matrix[12])
{
    for (int64_t v = 0; v < count; v++) {
        float *p = positions + 3 * v;
        float x = p[0], y = p[1], z = p[2];
        for (int row = 0; row < 3; row++) {
            const float *m = matrix + 4 * row;
            p[row] = m[0] * x + m[1] * y + m[2] * z + m[3];
        }
    }
    return count;
}

/* The cross product of two sides: normal to the triangle, twice its area long. */
static void area_vector(const float *positions, const int32_t *corner, double vector[3])
{
    const float *p = positions + 3 * (int64_t)corner[0];
    const float *q = positions + 3 * (int64_t)corner[1];
    const float *r = positions + 3 * (int64_t)corner[2];
    double u[3], v[3];
    for (int axis = 0; axis < 3; axis++) {
        u[axis] = (double)q[axis] - (double)p[axis];
        v[axis] = (double)r[axis] - (double)p[axis];
    }
    vector[0] = u[1] * v[2] - u[2] * v[1];
    vector[1] = u[2] * v[0] - u[0] * v[2];
    vector[2] = u[0] * v[1] - u[1] * v[0];
}

static double length_of(const double vector[3])
{
    return sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
}

double triangles_area(const float *positions, const int32_t *corners, int64_t count)
{
    double sum = 0.0;
    for (int64_t t = 0; t < count; t++) {
        double vector[3];
        area_vector(positions, corners + 3 * t, vector);
        sum += length_of(vector);
    }
    return sum / 2.0;
}

void triangles_normals(const float *positions, const int32_t *corners, int64_t count,
                       float *normals)
{
    for (int64_t t = 0; t < count; t++) {
        double vector[3];
        area_vector(positions, corners + 3 * t, vector);
        double length = length_of(vector);
        for (int axis = 0; axis < 3; axis++)
            normals[3 * t + axis] = length > 0.0 ? (float)(vector[axis] / length) : 0.0F;
    }
}

void triangles_add_normals(const float *positions, const int32_t *corners, int64_t count,
                           float *vertex_normals)
{
    for (int64_t t = 0; t < count; t++) {
        double vector[3];
        area_vector(positions, corners + 3 * t, vector);
        for (int corner = 0; corner < 3; corner++) {
            float *normal = vertex_normals + 3 * (int64_t)corners[3 * t + corner];
            for (int axis = 0; axis < 3; axis++)
                normal[axis] += (float)vector[axis];
        }
    }
}

void vectors_to_unit(float *vectors, int64_t count)
{
    for (int64_t i = 0; i < count; i++) {
        float *v = vectors + 3 * i;
        double wide[3] = {(double)v[0], (double)v[1], (double)v[2]};
        double length = length_of(wide);
        for (int axis = 0; axis < 3; axis++)
            v[axis] = length > 0.0 ? (float)(wide[axis] / length) : 0.0F;
    }
}
