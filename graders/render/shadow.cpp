/* The floor's shadow: the triangles seen from above, blurred; see surfaces.hpp. */
#include "graders/render/surfaces.hpp"

#include <limits>
#include <vtkImageData.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

namespace
{
const int side = 384; /* texels */
using field = std::vector<float>;

/* The square of floor that is looked at. */
struct floor_square {
    double x, y, size, z;

    double column(double at) const
    {
        return (at - x) / size * side;
    }
    double row(double at) const
    {
        return (at - y) / size * side;
    }
};

floor_square floor_below(const std::vector<vec3> &points, const std::vector<triangle> &triangles)
{
    double big = std::numeric_limits<double>::infinity();
    vec3 low = {big, big, big}, high = {-big, -big, -big};
    for (const triangle &t : triangles)
        for (int32_t v : t) {
            vec3 p = points[v];
            low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        }
    double extent = std::max(high.x - low.x, high.y - low.y);
    double size = 1.5 * extent + .1;
    return {(low.x + high.x - size) / 2, (low.y + high.y - size) / 2, size, low.z - .012};
}

/* Marks the texels whose centres a triangle covers; what is near to the floor is darker. */
void cover(field &shade, const floor_square &floor, vec3 a, vec3 b, vec3 c)
{
    vec3 p[3] = {a, b, c};
    double height = (a.z + b.z + c.z) / 3 - floor.z;
    float weight = float(.35 + .65 * std::exp(-9 * height));
    for (vec3 &q : p)
        q = {floor.column(q.x), floor.row(q.y), 0};
    auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
    auto [bottom, top] = std::minmax({p[0].y, p[1].y, p[2].y});
    double area = cross(p[1] - p[0], p[2] - p[0]).z;
    if (area == 0)
        return;
    for (int y = std::max(0, int(bottom)); y <= std::min(side - 1, int(top)); y++)
        for (int x = std::max(0, int(left)); x <= std::min(side - 1, int(right)); x++) {
            vec3 at = {x + .5, y + .5, 0};
            bool inside = true;
            for (int i = 0; i < 3; i++)
                inside = inside && cross(p[(i + 1) % 3] - p[i], at - p[i]).z * area >= -.5;
            float &texel = shade[size_t(y) * side + x];
            if (inside)
                texel = std::max(texel, weight);
        }
}

/* A running mean along rows (step 1) or columns (step `side`). */
void box_blur(field &values, int radius, bool along_rows)
{
    field line(side);
    for (int i = 0; i < side; i++) {
        size_t start = along_rows ? size_t(i) * side : size_t(i);
        size_t step = along_rows ? 1 : side;
        float sum = 0;
        for (int k = 0; k < side; k++)
            line[k] = values[start + k * step];
        for (int k = -radius; k < side + radius; k++) {
            if (k + radius < side)
                sum += line[k + radius];
            if (k - radius - 1 >= 0)
                sum -= line[k - radius - 1];
            if (k >= 0 && k < side)
                values[start + k * step] = sum / float(2 * radius + 1);
        }
    }
}

field blurred(field values, int radius)
{
    for (int pass = 0; pass < 3; pass++) {
        box_blur(values, radius, true);
        box_blur(values, radius, false);
    }
    return values;
}

vtkSmartPointer<vtkTexture> shade_texture(const field &wide, const field &tight)
{
    vtkNew<vtkImageData> pixels;
    pixels->SetDimensions(side, side, 1);
    pixels->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    auto rgba = static_cast<uint8_t *>(pixels->GetScalarPointer());
    for (size_t i = 0; i < wide.size(); i++) {
        double opacity = std::clamp(.36 * wide[i] + .16 * tight[i], 0.0, .5);
        const uint8_t texel[] = {44, 54, 74, uint8_t(opacity * 255)};
        std::copy(texel, texel + 4, rgba + 4 * i);
    }
    vtkNew<vtkTexture> texture;
    texture->SetInputData(pixels);
    texture->InterpolateOn();
    texture->SetEdgeClamp(1);
    return texture.Get();
}
} // namespace

vtkSmartPointer<vtkActor> shadow_actor(const std::vector<vec3> &points,
                                       const std::vector<triangle> &triangles)
{
    vtkNew<vtkActor> actor;
    if (triangles.empty())
        return actor.Get();
    floor_square floor = floor_below(points, triangles);
    field shade(size_t(side) * side);
    for (const triangle &t : triangles)
        cover(shade, floor, points[t[0]], points[t[1]], points[t[2]]);
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(floor.x, floor.y, floor.z);
    plane->SetPoint1(floor.x + floor.size, floor.y, floor.z);
    plane->SetPoint2(floor.x, floor.y + floor.size, floor.z);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    actor->SetMapper(mapper);
    actor->SetTexture(shade_texture(blurred(shade, 16), blurred(shade, 4)));
    actor->ForceTranslucentOn();
    actor->GetProperty()->LightingOff();
    return actor.Get();
}
