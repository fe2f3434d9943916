/* See surfaces.hpp. */
#include "graders/render/surfaces.hpp"

#include <vtkFloatArray.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>

vtkSmartPointer<vtkPoints> vtk_points(const std::vector<vec3> &points)
{
    vtkNew<vtkPoints> out;
    out->SetDataTypeToFloat();
    out->SetNumberOfPoints(vtkIdType(points.size()));
    for (size_t i = 0; i < points.size(); i++)
        out->SetPoint(vtkIdType(i), points[i].x, points[i].y, points[i].z);
    return out.Get();
}

vtkSmartPointer<vtkFloatArray> vtk_normals(const std::vector<vec3> &normals)
{
    vtkNew<vtkFloatArray> out;
    out->SetNumberOfComponents(3);
    out->SetNumberOfTuples(vtkIdType(normals.size()));
    for (size_t i = 0; i < normals.size(); i++)
        out->SetTuple3(vtkIdType(i), normals[i].x, normals[i].y, normals[i].z);
    return out.Get();
}

template <class cell> static vtkSmartPointer<vtkCellArray> cells_of(const std::vector<cell> &cells)
{
    vtkNew<vtkCellArray> out;
    out->AllocateExact(vtkIdType(cells.size()), vtkIdType(cells.size() * std::tuple_size_v<cell>));
    for (const cell &one : cells) {
        out->InsertNextCell(int(one.size()));
        for (int32_t v : one)
            out->InsertCellPoint(v);
    }
    return out.Get();
}

vtkSmartPointer<vtkCellArray> vtk_cells(const std::vector<triangle> &triangles)
{
    return cells_of(triangles);
}

vtkSmartPointer<vtkCellArray> vtk_cells(const std::vector<edge> &edges)
{
    return cells_of(edges);
}

static void paint_surface(vtkProperty *property, colour paint)
{
    property->SetColor(paint.red / 255.0, paint.green / 255.0, paint.blue / 255.0);
    property->SetInterpolationToPhong();
    property->SetAmbient(.28);
    property->SetDiffuse(.63);
    property->SetSpecular(.10);
    property->SetSpecularPower(22);
}

vtkSmartPointer<vtkActor> surface_actor(const std::vector<vec3> &points,
                                        const std::vector<triangle> &triangles, colour paint)
{
    vtkNew<vtkPolyData> data;
    data->SetPoints(vtk_points(points));
    data->SetPolys(vtk_cells(triangles));
    return lit_surface(data, paint);
}

vtkSmartPointer<vtkActor> lit_surface(vtkPolyData *data, colour paint)
{
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(data);
    normals->SetFeatureAngle(40);
    normals->SplittingOn();
    normals->ConsistencyOff();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(normals->GetOutputPort());
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 1);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    paint_surface(actor->GetProperty(), paint);
    vtkNew<vtkProperty> back;
    paint_surface(back, palette::back_face);
    actor->SetBackfaceProperty(back);
    return actor.Get();
}

double wire_opacity(double spacing_units)
{
    const double opaque_spacing = 28, faintest = .01, strongest = .45;
    return std::clamp(spacing_units / opaque_spacing, faintest, strongest);
}

vtkSmartPointer<vtkActor> wire_actor(const std::vector<vec3> &points,
                                     const std::vector<edge> &edges, double width, colour paint)
{
    vtkNew<vtkPolyData> data;
    data->SetPoints(vtk_points(points));
    data->SetLines(vtk_cells(edges));
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -3);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(paint.red / 255.0, paint.green / 255.0, paint.blue / 255.0);
    actor->GetProperty()->SetOpacity(paint.alpha / 255.0);
    actor->GetProperty()->SetLineWidth(float(width));
    actor->GetProperty()->LightingOff();
    return actor.Get();
}
