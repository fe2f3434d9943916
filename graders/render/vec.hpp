/* Points and directions in space. */
#ifndef GRADERS_RENDER_VEC_HPP
#define GRADERS_RENDER_VEC_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

struct vec3 {
    double x = 0, y = 0, z = 0;
};

inline vec3 operator+(vec3 a, vec3 b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline vec3 operator-(vec3 a, vec3 b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline vec3 operator*(vec3 a, double s)
{
    return {a.x * s, a.y * s, a.z * s};
}
inline double dot(vec3 a, vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline vec3 cross(vec3 a, vec3 b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(vec3 a)
{
    return std::sqrt(dot(a, a));
}
/* The zero vector stays zero. */
inline vec3 normalised(vec3 a)
{
    double l = length(a);
    return l > 0 ? a * (1 / l) : vec3{};
}

using triangle = std::array<int32_t, 3>;
using edge = std::array<int32_t, 2>;

#endif
