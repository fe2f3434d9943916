/* Plain loops over triangles; see triangle_sweeps.h. */
#include "reference/representation/triangle_sweeps.h"

#include <math.h>

int positions_check(const float *positions, int64_t count, struct error *err)
{
    for (int64_t i = 0; i < 3 * count; i++)
        if (!isfinite(positions[i]))
            return error_set(err, "vertex %lld: its %c is not a finite number", (long long)(i / 3),
                             "xyz"[i % 3]);
    return 0;
}

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
    double px = (double)p[0], py = (double)p[1], pz = (double)p[2];
    double ux = (double)q[0] - px, uy = (double)q[1] - py, uz = (double)q[2] - pz;
    double vx = (double)r[0] - px, vy = (double)r[1] - py, vz = (double)r[2] - pz;
    vector[0] = uy * vz - uz * vy;
    vector[1] = uz * vx - ux * vz;
    vector[2] = ux * vy - uy * vx;
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
