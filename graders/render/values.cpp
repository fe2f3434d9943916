/* See values.hpp. */
#include "graders/render/values.hpp"
#include "graders/render/surfaces.hpp"

#include <cstdio>
#include <set>
#include <vtkCellData.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

namespace
{
colour between(colour a, colour b, double share)
{
    auto mix = [share](uint8_t p, uint8_t q) { return uint8_t(std::lround(p + (q - p) * share)); };
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

/* The colour of a place on the scale, 0 ... 1. */
colour scale_colour(double share)
{
    const size_t steps = std::size(palette::scale) - 1;
    double at = std::clamp(share, 0.0, 1.0) * double(steps);
    size_t low = std::min(size_t(at), steps - 1);
    return between(palette::scale[low], palette::scale[low + 1], at - double(low));
}

vtkSmartPointer<vtkLookupTable> table_of(const value_scale &values)
{
    const int entries = 256;
    vtkNew<vtkLookupTable> table;
    table->SetNumberOfTableValues(entries);
    for (int i = 0; i < entries; i++) {
        colour c = scale_colour(double(i) / (entries - 1));
        table->SetTableValue(i, c.red / 255.0, c.green / 255.0, c.blue / 255.0);
    }
    double widest = values.high > values.low ? values.high : values.low + 1;
    table->SetTableRange(values.low, widest);
    colour none = palette::no_value;
    table->SetNanColor(none.red / 255.0, none.green / 255.0, none.blue / 255.0, 1);
    return table.Get();
}

/* The values of the vertices, or of the triangles that are drawn. */
vtkSmartPointer<vtkFloatArray> scalars_of(const value_scale &values, const shape &mesh)
{
    vtkNew<vtkFloatArray> scalars;
    size_t count = values.of_vertices ? mesh.points.size() : mesh.triangles.size();
    scalars->SetNumberOfTuples(vtkIdType(count));
    for (size_t i = 0; i < count; i++)
        scalars->SetValue(vtkIdType(i),
                          values.numbers[values.of_vertices ? i : size_t(mesh.sources[i])]);
    return scalars.Get();
}

vtkSmartPointer<vtkUnsignedCharArray> group_colours(const scene &from, const shape &mesh)
{
    const double strength = .72; /* the rest is the plain surface: marks stand out */
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(3);
    colours->SetNumberOfTuples(vtkIdType(mesh.triangles.size()));
    for (size_t t = 0; t < mesh.triangles.size(); t++) {
        int group = from.groups[size_t(mesh.sources[t])];
        colour paint = palette::surface;
        if (turn_0 + group <= turn_last)
            paint = between(palette::surface, palette::marks[turn_0 + group], strength);
        colours->SetTuple3(vtkIdType(t), paint.red, paint.green, paint.blue);
    }
    return colours.Get();
}

/* Vertices no two of which lie closer than `gap`, in a grid of that width; the first mark's first.
 */
std::vector<int32_t> spread_vertices(const scene &from, const shape &mesh, double gap)
{
    std::set<std::array<int, 3>> taken;
    std::vector<int32_t> chosen;
    auto choose = [&](int32_t v) {
        vec3 p = mesh.points[v] * (1 / gap);
        if (taken.insert({int(std::floor(p.x)), int(std::floor(p.y)), int(std::floor(p.z))}).second)
            chosen.push_back(v);
    };
    if (!from.marks.empty())
        for (int32_t v : from.marks[0].vertex)
            choose(v);
    for (size_t v = 0; v < mesh.points.size(); v++)
        choose(int32_t(v));
    return chosen;
}

/* The length below which nearly all vectors are. */
double usual_length(const scene &from, const std::vector<int32_t> &vertices)
{
    std::vector<double> lengths;
    for (const vector_set &set : from.vectors)
        for (int32_t v : vertices)
            if (length(set.vectors[v]) > 0)
                lengths.push_back(length(set.vectors[v]));
    if (lengths.empty())
        return 1;
    std::sort(lengths.begin(), lengths.end());
    return lengths[lengths.size() * 9 / 10];
}

std::string short_value(double number)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", number);
    return text;
}
} // namespace

bool has_coloured_faces(const scene &from)
{
    return !from.values.numbers.empty() || !from.groups.empty();
}

std::vector<mark> drawn_marks(const scene &from)
{
    std::vector<mark> marks = from.marks;
    for (mark &one : marks)
        if (has_coloured_faces(from))
            one.fill.clear();
    return marks;
}

vtkSmartPointer<vtkActor> scene_surface(const scene &from, const shape &mesh)
{
    if (!has_coloured_faces(from))
        return surface_actor(mesh.points, mesh.triangles, palette::surface);
    vtkNew<vtkPolyData> data;
    data->SetPoints(vtk_points(mesh.points));
    data->SetPolys(vtk_cells(mesh.triangles));
    const value_scale &values = from.values;
    if (values.numbers.empty())
        data->GetCellData()->SetScalars(group_colours(from, mesh));
    else if (values.of_vertices)
        data->GetPointData()->SetScalars(scalars_of(values, mesh));
    else
        data->GetCellData()->SetScalars(scalars_of(values, mesh));
    vtkSmartPointer<vtkActor> actor = lit_surface(data, palette::surface);
    vtkMapper *mapper = actor->GetMapper();
    mapper->ScalarVisibilityOn();
    if (!values.numbers.empty()) {
        vtkSmartPointer<vtkLookupTable> table = table_of(values);
        mapper->SetLookupTable(table);
        mapper->UseLookupTableScalarRangeOn();
        mapper->SetInterpolateScalarsBeforeMapping(values.of_vertices);
    }
    /* Shades must not pass for values. */
    actor->GetProperty()->SetAmbient(.5);
    actor->GetProperty()->SetDiffuse(.48);
    actor->GetProperty()->SetSpecular(0);
    return actor;
}

void add_vectors(vtkRenderer *renderer, const scene &from, const shape &mesh, const pen &how,
                 finish look)
{
    const double gap_units = 30, thickness = .8, zero_ball = 1.6;
    if (from.vectors.empty())
        return;
    double gap = std::max(.75 * mesh.spacing, gap_units * how.unit);
    double most = std::min(1.1 * gap, vectors_reach);
    std::vector<int32_t> vertices = spread_vertices(from, mesh, gap);
    double scale = most / usual_length(from, vertices);
    if (look == finish::ghost)
        vertices = from.marks.empty() ? std::vector<int32_t>() : from.marks[0].vertex;
    for (const vector_set &set : from.vectors) {
        solids arrows;
        pen thin = {thickness * how.radius * (set.kind == right_one ? .7 : 1), .6 * how.unit};
        for (int32_t v : vertices) {
            vec3 from_here = mesh.points[v], vector = set.vectors[v] * scale;
            double far = length(vector) / (2 * most); /* one may be huge */
            if (set.finite[v] && !(length(vector) > 0))
                arrows.ball(from_here, zero_ball * how.radius);
            else if (set.finite[v])
                add_arrow(arrows, from_here, from_here + vector * (far > 1 ? 1 / far : 1), thin,
                          false);
        }
        if (!arrows.empty())
            renderer->AddActor(arrows.actor(
                palette::marks[set.kind].with_alpha(look == finish::ghost ? .35 : 1), look));
    }
}

std::vector<legend_entry> vector_legend(const scene &from)
{
    std::vector<legend_entry> entries;
    for (const vector_set &set : from.vectors) {
        colour paint = palette::marks[set.kind];
        entries.push_back(
            {mark_word(from, set.kind), "", [paint](paper &sheet, point2 at, double width) {
                 double tip = at.x + width / 2;
                 sheet.line({at.x - width / 2, at.y}, {tip - 6, at.y}, 3, paint);
                 sheet.polygon({{tip - 9, at.y - 5}, {tip, at.y}, {tip - 9, at.y + 5}}, paint);
             }});
    }
    return entries;
}

void draw_scale(paper &sheet, point2 corner, const value_scale &values)
{
    const double width = 190, height = 10;
    const int pieces = 95;
    const font plain = {11.5, weight::regular, palette::grey_ink};
    const font bold = {11.5, weight::semibold, palette::ink};
    for (int i = 0; i < pieces; i++)
        sheet.rectangle({corner.x + width * i / pieces, corner.y}, width / pieces + .3, height,
                        scale_colour((i + .5) / pieces));
    double below = corner.y + height + 15;
    sheet.text({corner.x, below}, short_value(values.low), plain);
    sheet.text({corner.x + width, below}, short_value(values.high), plain, align::right);
    sheet.text({corner.x + width + 10, corner.y + height}, values.unit, plain);
    if (std::isnan(values.worst))
        return;
    double share =
        values.high > values.low ? (values.worst - values.low) / (values.high - values.low) : 0;
    double x = corner.x + width * std::clamp(share, 0.0, 1.0), top = corner.y + 1;
    sheet.polygon({{x, top}, {x - 5, top - 8}, {x + 5, top - 8}}, palette::ink);
    std::string words = short_value(values.worst);
    double half = sheet.text_width(words, bold) / 2;
    sheet.text({std::max(x, corner.x + half), top - 11}, words, bold, align::centre);
}
