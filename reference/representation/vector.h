/* Vectors of three doubles: positions are binary32, what is computed from them is not. */
#ifndef REFERENCE_REPRESENTATION_VECTOR_H
#define REFERENCE_REPRESENTATION_VECTOR_H

#include <math.h>
#include <stdint.h>

struct vector {
    double x, y, z;
};

/* Vector number `index` of a table of floats, and the other way. */
static inline struct vector vector_at(const float *table, int32_t index)
{
    const float *p = table + 3 * (int64_t)index;
    return (struct vector){(double)p[0], (double)p[1], (double)p[2]};
}

static inline void vector_put(float *table, int32_t index, struct vector v)
{
    float *p = table + 3 * (int64_t)index;
    p[0] = (float)v.x;
    p[1] = (float)v.y;
    p[2] = (float)v.z;
}

static inline struct vector vector_add(struct vector a, struct vector b)
{
    return (struct vector){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline struct vector vector_subtract(struct vector a, struct vector b)
{
    return (struct vector){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline struct vector vector_scale(struct vector v, double factor)
{
    return (struct vector){v.x * factor, v.y * factor, v.z * factor};
}

static inline double vector_dot(struct vector a, struct vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline struct vector vector_cross(struct vector a, struct vector b)
{
    return (struct vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline double vector_length(struct vector v)
{
    return sqrt(vector_dot(v, v));
}

/* The unit vector of the same direction; zero stays zero. */
static inline struct vector vector_unit(struct vector v)
{
    double length = vector_length(v);
    return length > 0.0 ? vector_scale(v, 1.0 / length) : (struct vector){0.0, 0.0, 0.0};
}

/* Twice the area vector of the triangle a b c. */
static inline struct vector triangle_normal(const float *positions, int32_t a, int32_t b, int32_t c)
{
    struct vector p = vector_at(positions, a);
    return vector_cross(vector_subtract(vector_at(positions, b), p),
                        vector_subtract(vector_at(positions, c), p));
}

#endif
