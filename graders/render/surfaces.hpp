/* Surfaces, wires and shadows as VTK actors. */
#ifndef GRADERS_RENDER_SURFACES_HPP
#define GRADERS_RENDER_SURFACES_HPP

#include "graders/render/palette.hpp"
#include "graders/render/vec.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

vtkSmartPointer<vtkPoints> vtk_points(const std::vector<vec3> &points);
vtkSmartPointer<vtkFloatArray> vtk_normals(const std::vector<vec3> &normals);
vtkSmartPointer<vtkCellArray> vtk_cells(const std::vector<triangle> &triangles);
vtkSmartPointer<vtkCellArray> vtk_cells(const std::vector<edge> &edges);

/* A lit surface, smooth but for creases sharper than 40 degrees; its back faces are peach. */
vtkSmartPointer<vtkActor> surface_actor(const std::vector<vec3> &points,
                                        const std::vector<triangle> &triangles, colour paint);

/* The same for data that may have its own colours or values. */
vtkSmartPointer<vtkActor> lit_surface(vtkPolyData *data, colour paint);

/* Unlit lines over a surface; the width is in drawn pixels. */
vtkSmartPointer<vtkActor> wire_actor(const std::vector<vec3> &points,
                                     const std::vector<edge> &edges, double width, colour paint);

/* How opaque edges should be that lie so many units of paper apart: dense wires fade. */
double wire_opacity(double spacing_units);

/* The soft shadow that things throw on a floor just below their lowest point. */
vtkSmartPointer<vtkActor> shadow_actor(const std::vector<vec3> &points,
                                       const std::vector<triangle> &triangles);

#endif
