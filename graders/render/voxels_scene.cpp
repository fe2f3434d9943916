/* Voxels, and beside them the boxes of an octree and a mesh, where there are any; see pictures.hpp.
 */
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
    std::vector<colour> paints; /* of each point */
    std::vector<triangle> triangles;
    std::vector<edge> outlines;
    int64_t full_count = 0;
};

struct cell {
    int axis[3];
};

const colour full_paint = {120, 176, 222};

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

/* One side of a cube of cells: `corner` is its lowest cell. */
struct cube_side {
    cell corner;
    int cells; /* along the cube */
    int axis, direction;
};

/* Adds two triangles and their outline, in the paints of the four corners. */
void add_side(voxel_faces &faces, const cube_side &one, double per_side, const colour paint[4])
{
    double scale = 1 / (per_side * std::sqrt(3.0));
    int u = (one.axis + 1) % 3, v = (one.axis + 2) % 3;
    int32_t first = int32_t(faces.points.size());
    for (int i = 0; i < 4; i++) {
        int du = i == 1 || i == 2, dv = i >= 2;
        if (one.direction < 0)
            std::swap(du, dv);
        double xyz[3], normal[3] = {0, 0, 0};
        xyz[one.axis] = one.corner.axis[one.axis] + (one.direction > 0 ? one.cells : 0);
        xyz[u] = one.corner.axis[u] + du * one.cells;
        xyz[v] = one.corner.axis[v] + dv * one.cells;
        normal[one.axis] = one.direction;
        vec3 point = {xyz[0] - per_side / 2, xyz[1] - per_side / 2, xyz[2] - per_side / 2};
        faces.points.push_back(point * scale);
        faces.normals.push_back({normal[0], normal[1], normal[2]});
        faces.paints.push_back(paint[2 * du + dv]);
        faces.outlines.push_back({first + i, first + (i + 1) % 4});
    }
    faces.triangles.push_back({first, first + 1, first + 2});
    faces.triangles.push_back({first, first + 2, first + 3});
}

void add_face(voxel_faces &faces, const scene &from, cell at, int axis, int direction)
{
    bool wrong = from.wrong_voxel(at.axis[0], at.axis[1], at.axis[2]);
    const colour paint = wrong ? palette::marks[extra] : full_paint;
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    cell front = at;
    front.axis[axis] += direction;
    colour corners[4];
    for (int du = 0; du < 2; du++)
        for (int dv = 0; dv < 2; dv++)
            corners[2 * du + dv] = paint.darker(
                .62 + .38 * corner_openness(from, front, u, v, 2 * du - 1, 2 * dv - 1));
    add_side(faces, {at, 1, axis, direction}, from.voxels_per_side, corners);
}

/* The boxes of an octree, each size in a colour of its own. */
voxel_faces faces_of_boxes(const scene &from)
{
    static const colour paints[] = {
        {120, 176, 222}, {176, 214, 184}, {244, 208, 122}, {226, 142, 98}, {176, 104, 140}};
    voxel_faces faces;
    for (const cell_box &box : from.shown.boxes) {
        size_t level = 0;
        while (level + 1 < std::size(paints) && box.side >> (level + 1))
            level++;
        const colour paint[] = {paints[level], paints[level], paints[level], paints[level]};
        for (int axis = 0; axis < 3; axis++)
            for (int direction : {-1, 1})
                add_side(faces, {{{box.x, box.y, box.z}}, box.side, axis, direction},
                         from.voxels_per_side, paint);
        faces.full_count++;
    }
    return faces;
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
    for (colour paint : faces.paints)
        colours->InsertNextTuple3(paint.red, paint.green, paint.blue);
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

/* Frames of cells: of those that are empty and should be full, and of the named one. */
struct cell_frames {
    solids missing, named;
    int64_t missing_count = 0, extra_count = 0;
    vec3 named_middle;
};

cell cell_of(int number, int side)
{
    return {{number % side, number / side % side, number / side / side}};
}

/* The lowest corner of a cell, or of the cell after the last, moved aside. */
vec3 corner_of(cell at, int side, vec3 aside)
{
    double scale = 1 / (side * std::sqrt(3.0)), half = side / 2.0;
    return vec3{at.axis[0] - half, at.axis[1] - half, at.axis[2] - half} * scale + aside;
}

/* The twelve edges of a cube. */
void add_frame(solids &out, vec3 low, double side, double radius)
{
    for (int i = 0; i < 8; i++)
        for (int axis = 0; axis < 3; axis++) {
            if (i >> axis & 1)
                continue;
            auto corner = [&](int bits) {
                return low + vec3{bits & 1 ? side : 0, bits & 2 ? side : 0, bits & 4 ? side : 0};
            };
            out.tube(corner(i), corner(i | 1 << axis), radius);
        }
}

cell_frames frames_of(const scene &from, vec3 aside, double units)
{
    const size_t most_frames = 600;
    cell_frames frames;
    int side = from.voxels_per_side;
    double size = 1 / (side * std::sqrt(3.0));
    double radius = std::clamp(.03 * size, .6 / units, 1.6 / units);
    for (int i = 0; i < side * side * side && !from.wrong_bits.empty(); i++) {
        cell at = cell_of(i, side);
        if (!from.wrong_voxel(at.axis[0], at.axis[1], at.axis[2]))
            continue;
        bool is_full = full(from, at);
        (is_full ? frames.extra_count : frames.missing_count)++;
        if (!is_full && size_t(frames.missing_count) <= most_frames)
            add_frame(frames.missing, corner_of(at, side, aside), size, radius);
    }
    if (from.named_voxel >= 0) {
        vec3 low = corner_of(cell_of(from.named_voxel, side), side, aside);
        add_frame(frames.named, low, size, 2 * radius);
        frames.named_middle = low + vec3{size / 2, size / 2, size / 2};
    }
    return frames;
}

void add_frames(canvas &target, const cell_frames &frames)
{
    colour red = palette::marks[missing];
    if (!frames.missing.empty()) {
        target.world()->AddActor(frames.missing.actor(red, finish::lit));
        target.front()->AddActor(frames.missing.actor(red.with_alpha(.2), finish::ghost));
    }
    if (!frames.named.empty()) {
        target.world()->AddActor(frames.named.actor(palette::ink, finish::lit));
        target.front()->AddActor(frames.named.actor(palette::ink.with_alpha(.5), finish::ghost));
    }
}

/* From the side of the named cell. */
view look_of(const scene &from)
{
    if (from.named_voxel < 0)
        return {};
    view usual;
    int side = from.voxels_per_side;
    cell at = cell_of(from.named_voxel, side);
    vec3 middle = vec3{at.axis[0] + .5, at.axis[1] + .5, at.axis[2] + .5} -
                  vec3{side / 2.0, side / 2.0, side / 2.0};
    vec3 level = {middle.x, middle.y, 0};
    double elevation = middle.z < -.25 * side ? -22 : 22;
    if (length(level) == 0 || dot(level, usual.toward) >= 0)
        return view(-55, elevation);
    for (double azimuth : {35.0, 125.0, 215.0})
        if (dot(level, view(azimuth, 22).toward) > .6 * length(level))
            return view(azimuth, elevation);
    return view(125, elevation);
}

std::vector<legend_entry> voxel_legend(const scene &from, const voxel_faces &faces,
                                       const cell_frames &frames)
{
    std::vector<legend_entry> entries = mark_legend(from);
    auto add = [&entries](const char *name, int64_t count, colour paint) {
        entries.push_back(patch_entry(name, paint));
        entries.back().count = grouped(count);
        entries.back().muted = false;
    };
    if (from.wrong_bits.empty())
        return entries;
    add(from.say("rightly full", "llenas, correctas"), faces.full_count - frames.extra_count,
        full_paint);
    if (frames.extra_count > 0)
        add(from.say("full, but outside", "llenas, pero fuera"), frames.extra_count,
            palette::marks[extra]);
    if (frames.missing_count > 0)
        add(from.say("empty, but inside", "vacías, pero dentro"), frames.missing_count,
            palette::marks[missing]);
    return entries;
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

std::string voxel_bytes(const scene &from, int side)
{
    return from.say("one bit each: ", "un bit cada uno: ") +
           byte_size(std::ceil(double(side) * side * side / 8));
}

std::string mesh_bytes(const scene &from, const scene_mesh &mesh)
{
    return from.say("12 bytes each: ", "12 bytes cada uno: ") +
           byte_size(12.0 * double(mesh.points.size() + mesh.triangles.size()));
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
    pen how = mark_pen(mesh, units);
    add_marks(target.world(), mesh.points, from.marks, how, finish::lit);
    add_marks(target.front(), mesh.points, from.marks, how, finish::ghost);
}
/* Things side by side, from the left: what stands under each and where its middle is. */
struct exhibit {
    vec3 aside;
    std::string name, note;
};

/* Offsets of `count` things of diagonal 1 (spheres: a good half as wide). */
vec3 aside_of(size_t index, size_t count, const view &look)
{
    return look.right * (.76 * (double(index) - double(count - 1) / 2));
}

void draw_exhibits(paper &sheet, const std::vector<exhibit> &exhibits, const framing &frame,
                   double y)
{
    for (const exhibit &one : exhibits)
        draw_caption(sheet, {frame.on_paper(one.aside).x, y}, one.name, one.note);
}

std::vector<exhibit> exhibits_of(const scene &from, const voxel_faces &voxels, const view &look)
{
    std::string k = std::to_string(from.voxels_per_side);
    bool boxes = !from.shown.boxes.empty(), mesh = !from.mesh.points.empty();
    size_t count = 1 + boxes + mesh;
    std::vector<exhibit> all;
    bool answer = !from.wrong_bits.empty();
    all.push_back({aside_of(0, count, look),
                   k + " × " + k + " × " + k + from.say(" voxels", " vóxeles") +
                       (answer ? from.say(" of the answer", " de la respuesta") : ""),
                   from.cut ? grouped(voxels.full_count) +
                                  from.say(" full, a sample of more", " llenos, una muestra")
                            : voxel_bytes(from, from.voxels_per_side)});
    if (boxes)
        all.push_back(
            {aside_of(1, count, look), "octree",
             grouped(int64_t(from.shown.boxes.size())) + from.say(" full cubes", " cubos llenos")});
    if (mesh)
        all.push_back({aside_of(count - 1, count, look),
                       (answer ? from.say("for comparison: ", "para comparar: ") : "") +
                           grouped(int64_t(from.mesh.points.size())) +
                           from.say(" vertices, ", " vértices, ") +
                           grouped(int64_t(from.mesh.triangles.size())) +
                           from.say(" triangles", " triángulos"),
                       mesh_bytes(from, from.mesh)});
    for (size_t i = 0; i < all.size() && i < from.shown.captions.size(); i++) {
        all[i].name = from.shown.captions[i].first;
        all[i].note = from.shown.captions[i].second;
    }
    return all;
}

/* Everything as one set of points and triangles, for framing and shadow. */
struct collection {
    std::vector<vec3> points;
    std::vector<triangle> triangles;

    void add(const std::vector<vec3> &more, const std::vector<triangle> &of_more)
    {
        for (triangle t : of_more) {
            for (int32_t &v : t)
                v += int32_t(points.size());
            triangles.push_back(t);
        }
        points.insert(points.end(), more.begin(), more.end());
    }
};
} // namespace

image draw_voxels(const scene &from, picture_size size)
{
    voxel_faces faces = faces_of(from), boxes = faces_of_boxes(from);
    bool beside = !from.mesh.points.empty();
    if (faces.full_count == 0 && boxes.full_count == 0 && !beside && from.wrong_bits.empty())
        throw not_showable(from.say("All voxels are empty.", "Todos los vóxeles están vacíos."));
    canvas target(size.width, size.height, backdrop::gradient);
    view look = look_of(from);
    shape mesh(unit_box(from.mesh.points).apply(from.mesh.points), from.mesh.triangles);
    std::vector<exhibit> exhibits = exhibits_of(from, faces, look);
    move_all(faces.points, exhibits.front().aside);
    if (boxes.full_count > 0)
        move_all(boxes.points, exhibits[1].aside);
    move_all(mesh.points, exhibits.back().aside);
    collection all;
    all.add(faces.points, faces.triangles);
    all.add(boxes.points, boxes.triangles);
    all.add(mesh.points, mesh.triangles);

    int side = std::max(1, from.voxels_per_side);
    for (int i = 0; i < 8; i++) {
        cell corner = {{i & 1 ? side : 0, i & 2 ? side : 0, i & 4 ? side : 0}};
        if (!from.wrong_bits.empty())
            all.points.push_back(corner_of(corner, side, exhibits.front().aside));
    }
    bool answer = !from.wrong_bits.empty();
    framing frame(target.world()->GetActiveCamera(), all.points, look, target.paper_width(),
                  {56, 56, 92, answer ? 160.0 : 130.0});
    cell_frames frames = frames_of(from, exhibits.front().aside, frame.units_at_middle());
    std::vector<legend_entry> legend = voxel_legend(from, faces, frames);
    if (look.toward.z > 0)
        target.world()->AddActor(shadow_actor(all.points, all.triangles));
    add_voxels(target, faces, frame.units_at_middle(), side);
    if (boxes.full_count > 0)
        add_voxels(target, boxes, frame.units_at_middle(), side);
    add_mesh_beside(target, from, mesh, frame.units_at_middle());
    add_frames(target, frames);
    target.on_paper([&](paper &sheet) {
        if (from.named_voxel >= 0) {
            cell at = cell_of(from.named_voxel, side);
            draw_label(sheet, frame.on_paper(frames.named_middle), {0, 1},
                       from.say("cell (", "celda (") + std::to_string(at.axis[0]) + ", " +
                           std::to_string(at.axis[1]) + ", " + std::to_string(at.axis[2]) + ")",
                       false);
        }
        draw_title(sheet, from.title, from.subtitle);
        draw_exhibits(sheet, exhibits, frame, sheet.height() - (legend.empty() ? 74 : 100));
        draw_legend(sheet, legend);
        draw_axes(sheet, look);
    });
    return target.draw(from.world.get());
}
