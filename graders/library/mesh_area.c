/* The area of a mesh for a judge; see mesh_area.h. */
#include "graders/library/mesh_area.h"

#include <math.h>

struct vector {
    long double x, y, z;
};

/* Neumaier's compensated sum. */
struct sum {
    long double total, lost;
};

static void add(struct sum *sum, long double term)
{
    long double total = sum->total + term;
    if (fabsl(sum->total) >= fabsl(term))
        sum->lost += (sum->total - total) + term;
    else
        sum->lost += (term - total) + sum->total;
    sum->total = total;
}

static const float *position_of(const struct mesh_view *view, int32_t triangle, int corner)
{
    return view->positions + 3 * (int64_t)view->triangles[3 * (int64_t)triangle + corner];
}

static struct vector side(const float *from, const float *to)
{
    return (struct vector){(long double)to[0] - (long double)from[0],
                           (long double)to[1] - (long double)from[1],
                           (long double)to[2] - (long double)from[2]};
}

static struct vector cross(struct vector u, struct vector v)
{
    return (struct vector){u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

static long double length(struct vector v)
{
    return sqrtl(v.x * v.x + v.y * v.y + v.z * v.z);
}

static struct vector normal_of(const struct mesh_view *view, int32_t triangle)
{
    const float *a = position_of(view, triangle, 0);
    return cross(side(a, position_of(view, triangle, 1)), side(a, position_of(view, triangle, 2)));
}

static double doubled_area(const struct mesh_view *view, int32_t triangle)
{
    const float *a = position_of(view, triangle, 0), *b = position_of(view, triangle, 1);
    const float *c = position_of(view, triangle, 2);
    double u[3], v[3];
    for (int i = 0; i < 3; i++) {
        u[i] = (double)b[i] - (double)a[i];
        v[i] = (double)c[i] - (double)a[i];
    }
    double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2];
    double z = u[0] * v[1] - u[1] * v[0];
    return sqrt(x * x + y * y + z * z);
}

enum area_facing mesh_area_facing(const struct mesh_view *view, int32_t triangle)
{
    struct vector normal = normal_of(view, triangle);
    if (!(length(normal) > 0))
        return AREA_FLAT;
    return normal.z > 0 ? AREA_UPWARDS : AREA_NOT_UPWARDS;
}

/* In double, which is exact for the sides of most triangles and bends the area of a needle of
 * 10^-6 by 10^-10 of it; blocks keep the sum's error near that of one addition. */
double mesh_area_exact(const struct mesh_view *view)
{
    enum { BLOCK = 1024 };
    struct sum sum = {0};
    for (int32_t t = 0; t < view->triangle_count;) {
        int32_t end = view->triangle_count - t < BLOCK ? view->triangle_count : t + BLOCK;
        double block = 0;
        for (; t < end; t++)
            block += doubled_area(view, t);
        add(&sum, (long double)block);
    }
    return (double)((sum.total + sum.lost) / 2);
}

static float float_length(float x, float y, float z)
{
    return sqrtf(x * x + y * y + z * z);
}

static float float_area(const float *a, const float *b, const float *c)
{
    float u[3], v[3];
    for (int i = 0; i < 3; i++) {
        u[i] = b[i] - a[i];
        v[i] = c[i] - a[i];
    }
    return 0.5F * float_length(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                               u[0] * v[1] - u[1] * v[0]);
}

static float float_area_of_positions(const float *a, const float *b, const float *c)
{
    float n[3];
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        n[i] =
            (a[j] * b[k] - a[k] * b[j]) + (b[j] * c[k] - b[k] * c[j]) + (c[j] * a[k] - c[k] * a[j]);
    }
    return 0.5F * float_length(n[0], n[1], n[2]);
}

struct area_sums mesh_area_sums(const struct mesh_view *view)
{
    struct area_sums sums = {.exact = mesh_area_exact(view), .first_flat = -1};
    struct vector all = {0};
    float by_float = 0, all_float = 0;
    double first = 0, last = 0;
    for (int32_t t = 0; t < view->triangle_count; t++) {
        const float *a = position_of(view, t, 0), *b = position_of(view, t, 1);
        const float *c = position_of(view, t, 2);
        struct vector normal = normal_of(view, t);
        long double twice = length(normal);
        double area = (double)(twice / 2);
        if (!(area > 0) && sums.first_flat < 0)
            sums.first_flat = t;
        first = t == 0 ? area : first;
        last = area;
        all = (struct vector){all.x + normal.x, all.y + normal.y, all.z + normal.z};
        sums.squares += (double)(twice * twice / 2);
        sums.seen_from_z += (double)(fabsl(normal.z) / 2);
        sums.facing_up += normal.z > 0 ? area : 0;
        sums.absolute_float += (double)float_area_of_positions(a, b, c);
        by_float += (float)area;
        all_float += float_area(a, b, c);
    }
    sums.without_first = sums.exact - first;
    sums.without_last = sums.exact - last;
    sums.by_float = (double)by_float;
    sums.all_float = (double)all_float;
    sums.vector = (double)(length(all) / 2);
    return sums;
}
