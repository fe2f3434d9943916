/* Voxels, with a mesh beside them if there is one; see pictures.hpp. */
#include "graders/render/canvas.hpp"
#include "graders/render/marks.hpp"
#include "graders/render/pictures.hpp"
#include "graders/render/surfaces.hpp"
#include "graders/render/text.hpp"

#include <vtkCamera.h>
#include <vtkMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

namespace
{
/* The faces between a full and an empty cell, two triangles each, in a box of diagonal 1. */
struct voxel_faces {
    std::vector<vec3> points, normals;
    std::vector<double> openness; /* of each point, 0 ... 1: how little the neighbours shade it */
    std::vector<triangle> triangles;
    std::vector<edge> outlines;
    int64_t full_count = 0;
};

struct cell {
    int axis[3];
};

bool full(const scene &from, cell at)
{
    return from.voxel(at.axis[0], at.axis[1], at.axis[2]);
}

/* A corner is shaded by the three cells that stand around it in front of the face. */
double corner_openness(const scene &from, cell front, int u, int v, int du, int dv)
{
    cell side_u = front, side_v = front, diagonal = front;
    side_u.axis[u] += du;
    side_v.axis[v] += dv;
    diagonal.axis[u] += du;
    diagonal.axis[v] += dv;
    int shading = full(from, side_u) + full(from, side_v) + full(from, diagonal);
    return 1 - shading / 3.0;
}

void add_face(voxel_faces &faces, const scene &from, cell at, int axis, int direction)
{
    double side = from.voxels_per_side, scale = 1 / (side * std::sqrt(3.0));
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    cell front = at;
    front.axis[axis] += direction;
    int32_t first = int32_t(faces.points.size());
    for (int i = 0; i < 4; i++) {
        int du = i == 1 || i == 2, dv = i >= 2;
        if (direction < 0)
            std::swap(du, dv);
        double xyz[3], normal[3] = {0, 0, 0};
        xyz[axis] = at.axis[axis] + (direction > 0);
        xyz[u] = at.axis[u] + du;
        xyz[v] = at.axis[v] + dv;
        normal[axis] = direction;
        faces.points.push_back(vec3{xyz[0] - side / 2, xyz[1] - side / 2, xyz[2] - side / 2} *
                               scale);
        faces.normals.push_back({normal[0], normal[1], normal[2]});
        faces.openness.push_back(corner_openness(from, front, u, v, 2 * du - 1, 2 * dv - 1));
        faces.outlines.push_back({first + i, first + (i + 1) % 4});
    }
    faces.triangles.push_back({first, first + 1, first + 2});
    faces.triangles.push_back({first, first + 2, first + 3});
}

voxel_faces faces_of(const scene &from)
{
    voxel_faces faces;
    int side = from.voxels_per_side;
    for (int z = 0; z < side; z++)
        for (int y = 0; y < side; y++)
            for (int x = 0; x < side; x++) {
                if (!from.voxel(x, y, z))
                    continue;
                faces.full_count++;
                for (int axis = 0; axis < 3; axis++)
                    for (int direction : {-1, 1}) {
                        cell front = {{x, y, z}};
                        front.axis[axis] += direction;
                        if (!full(from, front))
                            add_face(faces, from, {{x, y, z}}, axis, direction);
                    }
            }
    return faces;
}

vtkSmartPointer<vtkActor> voxel_actor(const voxel_faces &faces)
{
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(3);
    const colour paint = {120, 176, 222};
    for (double open : faces.openness) {
        double shade = .62 + .38 * open;
        colours->InsertNextTuple3(paint.red * shade, paint.green * shade, paint.blue * shade);
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(vtk_points(faces.points));
    data->SetPolys(vtk_cells(faces.triangles));
    data->GetPointData()->SetNormals(vtk_normals(faces.normals));
    data->GetPointData()->SetScalars(colours);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 1);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetAmbient(.25);
    actor->GetProperty()->SetDiffuse(.74);
    return actor.Get();
}

void move_all(std::vector<vec3> &points, vec3 by)
{
    for (vec3 &p : points)
        p = p + by;
}

/* What stands below a thing: its name in bold and its size in bytes. */
void draw_caption(paper &sheet, point2 at, const std::string &what, const std::string &bytes)
{
    sheet.text(at, what, {14, weight::semibold, palette::ink}, align::centre);
    sheet.text({at.x, at.y + 21}, bytes, {13, weight::regular, palette::grey_ink}, align::centre);
}

std::string voxel_bytes(int side)
{
    return "one bit each: " + byte_size(std::ceil(double(side) * side * side / 8));
}

std::string mesh_bytes(const scene_mesh &mesh)
{
    return "12 bytes each: " + byte_size(12.0 * double(mesh.points.size() + mesh.triangles.size()));
}

void add_voxels(canvas &target, const voxel_faces &faces, double units, int side)
{
    double cell_units = units / (side * std::sqrt(3.0));
    target.world()->AddActor(voxel_actor(faces));
    if (cell_units > 2.5)
        target.world()->AddActor(
            wire_actor(faces.points, faces.outlines, .9 * target.scale(),
                       palette::wire.with_alpha(std::clamp(cell_units / 40, .1, .45))));
}

void add_mesh_beside(canvas &target, const scene &from, const shape &mesh, double units)
{
    double opacity = wire_opacity(mesh.spacing * units);
    target.world()->AddActor(surface_actor(mesh.points, mesh.triangles, palette::surface));
    target.world()->AddActor(wire_actor(mesh.points, mesh.edges, .9 * target.scale(),
                                        palette::wire.with_alpha(opacity)));
    double radius = mark_radius(mesh, units);
    add_marks(target.world(), mesh.points, from.marks, radius, finish::lit);
    add_marks(target.front(), mesh.points, from.marks, radius, finish::ghost);
}
} // namespace

image draw_voxels(const scene &from, picture_size size)
{
    voxel_faces faces = faces_of(from);
    bool beside = !from.mesh.points.empty();
    if (faces.full_count == 0 && !beside)
        throw not_showable("All voxels are empty.");
    canvas target(size.width, size.height, backdrop::gradient);
    view look;
    shape mesh(unit_box(from.mesh.points).apply(from.mesh.points), from.mesh.triangles);
    vec3 aside = look.right * (beside ? .38 : 0);
    move_all(faces.points, aside * -1);
    move_all(mesh.points, aside);
    std::vector<vec3> all = faces.points;
    std::vector<triangle> triangles = faces.triangles;
    for (triangle t : mesh.triangles) {
        for (int32_t &v : t)
            v += int32_t(all.size());
        triangles.push_back(t);
    }
    all.insert(all.end(), mesh.points.begin(), mesh.points.end());

    std::vector<legend_entry> legend = mark_legend(from);
    framing frame(target.world()->GetActiveCamera(), all, look, target.paper_width(),
                  {56, 56, 92, legend.empty() ? 130.0 : 160.0});
    target.world()->AddActor(shadow_actor(all, triangles));
    add_voxels(target, faces, frame.units_at_middle(), std::max(1, from.voxels_per_side));
    add_mesh_beside(target, from, mesh, frame.units_at_middle());
    target.on_paper([&](paper &sheet) {
        std::string k = std::to_string(from.voxels_per_side);
        double y = sheet.height() - (legend.empty() ? 74 : 100);
        draw_title(sheet, from.title, from.subtitle);
        draw_caption(sheet, {frame.on_paper(aside * -1).x, y},
                     k + " × " + k + " × " + k + " voxels",
                     from.cut ? grouped(faces.full_count) + " full, a sample of more"
                              : voxel_bytes(from.voxels_per_side));
        if (beside)
            draw_caption(sheet, {frame.on_paper(aside).x, y},
                         grouped(int64_t(from.mesh.points.size())) + " vertices, " +
                             grouped(int64_t(from.mesh.triangles.size())) + " triangles",
                         mesh_bytes(from.mesh));
        draw_legend(sheet, legend);
        draw_axes(sheet, look);
    });
    return target.draw();
}
