/* See solids.hpp. */
#include "graders/render/solids.hpp"
#include "graders/render/surfaces.hpp"

#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

static const int sides = 16; /* around tubes and cones */

int32_t solids::add(vec3 point, vec3 normal)
{
    points_.push_back(point);
    normals_.push_back(normal);
    return int32_t(points_.size()) - 1;
}

void solids::ball(vec3 centre, double radius)
{
    const int rows = 9;
    int32_t first = int32_t(points_.size());
    for (int row = 0; row <= rows; row++)
        for (int i = 0; i <= sides; i++) {
            double polar = M_PI * row / rows, around = 2 * M_PI * i / sides;
            vec3 normal = {std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
                           std::cos(polar)};
            add(centre + normal * radius, normal);
        }
    for (int row = 0; row < rows; row++)
        for (int i = 0; i < sides; i++) {
            int32_t a = first + row * (sides + 1) + i, below = a + sides + 1;
            triangles_.push_back({a, below, below + 1});
            triangles_.push_back({a, below + 1, a + 1});
        }
}

/* Two unit vectors square to `axis` and to each other. */
static std::array<vec3, 2> frame_around(vec3 axis)
{
    vec3 other = std::fabs(axis.z) < .9 ? vec3{0, 0, 1} : vec3{1, 0, 0};
    vec3 u = normalised(cross(axis, other));
    return {u, cross(axis, u)};
}

void solids::tube(vec3 from, vec3 to, double radius)
{
    ball(from, radius);
    ball(to, radius);
    vec3 axis = normalised(to - from);
    if (length(axis) == 0)
        return;
    auto [u, v] = frame_around(axis);
    int32_t first = int32_t(points_.size());
    for (int i = 0; i <= sides; i++) {
        double around = 2 * M_PI * i / sides;
        vec3 normal = u * std::cos(around) + v * std::sin(around);
        add(from + normal * radius, normal);
        add(to + normal * radius, normal);
    }
    for (int i = 0; i < sides; i++) {
        int32_t a = first + 2 * i;
        triangles_.push_back({a, a + 2, a + 1});
        triangles_.push_back({a + 1, a + 2, a + 3});
    }
}

void solids::cone(vec3 base, vec3 tip, double radius)
{
    vec3 axis = normalised(tip - base);
    if (length(axis) == 0)
        return;
    auto [u, v] = frame_around(axis);
    double slope = radius / length(tip - base);
    int32_t first = int32_t(points_.size());
    for (int i = 0; i <= sides; i++) {
        double around = 2 * M_PI * i / sides;
        vec3 out = u * std::cos(around) + v * std::sin(around);
        vec3 normal = normalised(out + axis * slope);
        add(base + out * radius, normal);
        add(tip, normal);
        add(base + out * radius, axis * -1);
    }
    int32_t middle = add(base, axis * -1);
    for (int i = 0; i < sides; i++) {
        int32_t a = first + 3 * i;
        triangles_.push_back({a, a + 3, a + 1});
        triangles_.push_back({a + 2, middle, a + 5});
    }
}

void solids::patch(vec3 a, vec3 b, vec3 c)
{
    vec3 normal = normalised(cross(b - a, c - a));
    int32_t first = add(a, normal);
    add(b, normal);
    add(c, normal);
    triangles_.push_back({first, first + 1, first + 2});
}

vtkSmartPointer<vtkActor> solids::actor_of(const std::vector<vec3> &points, colour paint,
                                           finish look) const
{
    vtkNew<vtkPolyData> data;
    data->SetPoints(vtk_points(points));
    data->SetPolys(vtk_cells(triangles_));
    data->GetPointData()->SetNormals(vtk_normals(normals_));
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    vtkProperty *property = actor->GetProperty();
    property->SetColor(paint.red / 255.0, paint.green / 255.0, paint.blue / 255.0);
    property->SetOpacity(paint.alpha / 255.0);
    property->SetInterpolationToPhong();
    property->SetAmbient(.45);
    property->SetDiffuse(.6);
    property->SetSpecular(look == finish::lit ? .25 : 0);
    property->SetSpecularPower(20);
    property->SetLighting(look == finish::lit);
    if (look == finish::ghost)
        actor->ForceTranslucentOn();
    return actor.Get();
}

vtkSmartPointer<vtkActor> solids::actor(colour paint, finish look) const
{
    return actor_of(points_, paint, look);
}

/* The inner side of a hull that lies further out: it is seen only beyond the thing's outline. */
vtkSmartPointer<vtkActor> solids::rim(colour paint, double width) const
{
    std::vector<vec3> hull = points_;
    for (size_t i = 0; i < hull.size(); i++)
        hull[i] = hull[i] + normals_[i] * width;
    vtkSmartPointer<vtkActor> actor = actor_of(hull, paint, finish::flat);
    actor->GetProperty()->FrontfaceCullingOn();
    actor->GetProperty()->SetAmbient(1);
    return actor;
}
