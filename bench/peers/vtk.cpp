// VTK: filters on vtkPolyData, which shares our arrays' values (the copy is not measured).
#include "bench/peers/peer.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkExtractEdges.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkMassProperties.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkSmartPointer.h>
#include <vtkStripper.h>

#include <memory>
#include <stdexcept>

namespace
{

vtkSmartPointer<vtkPolyData> make_poly_data(const ::mesh &from)
{
    vtkNew<vtkPoints> points;
    points->SetDataTypeToFloat();
    points->SetNumberOfPoints(from.vertex_count);
    for (vtkIdType v = 0; v < from.vertex_count; v++)
        points->SetPoint(v, from.positions + 3 * v);
    vtkNew<vtkCellArray> cells;
    cells->AllocateExact(from.triangle_count, 3 * vtkIdType{from.triangle_count});
    for (vtkIdType t = 0; t < from.triangle_count; t++) {
        const std::int32_t *c = from.triangles + 3 * t;
        const vtkIdType corners[3] = {c[0], c[1], c[2]};
        cells->InsertNextCell(3, corners);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    return data;
}

struct state {
    const ::mesh *from;
    std::string path;
    vtkSmartPointer<vtkPolyData> data;
    vtkSmartPointer<vtkPolyData> result;
    std::vector<std::int32_t> neighbours;
    double area = 0;

    void extract_edges()
    {
        vtkNew<vtkExtractEdges> filter;
        filter->UseAllPointsOn();
        filter->SetInputData(data);
        filter->Update();
        result = filter->GetOutput();
    }

    void tell_edges(worker_answer &answer)
    {
        std::vector<std::int32_t> pairs;
        vtkNew<vtkIdList> ends;
        vtkCellArray *lines = result->GetLines();
        for (lines->InitTraversal(); lines->GetNextCell(ends);) {
            pairs.push_back(static_cast<std::int32_t>(ends->GetId(0)));
            pairs.push_back(static_cast<std::int32_t>(ends->GetId(1)));
        }
        answer_edges(&answer, pairs.data(), static_cast<std::int64_t>(pairs.size() / 2));
    }

    // VTK has no twins: it links vertices to cells and then finds the neighbour across each side.
    void find_neighbours()
    {
        vtkNew<vtkPolyData> copy;
        vtkNew<vtkIdList> found;
        copy->ShallowCopy(data);
        copy->BuildLinks();
        neighbours.assign(3 * static_cast<std::size_t>(from->triangle_count), -1);
        for (std::int64_t side = 0; side < 3 * std::int64_t{from->triangle_count}; side++) {
            std::int64_t next = side % 3 == 2 ? side - 2 : side + 1;
            copy->GetCellEdgeNeighbors(side / 3, from->triangles[side], from->triangles[next],
                                       found);
            if (found->GetNumberOfIds() == 1)
                neighbours[static_cast<std::size_t>(side)] =
                    static_cast<std::int32_t>(found->GetId(0));
        }
    }

    void sum_area()
    {
        vtkNew<vtkMassProperties> filter;
        filter->SetInputData(data);
        filter->Update();
        area = filter->GetSurfaceArea();
    }

    void find_normals(bool of_vertices)
    {
        vtkNew<vtkPolyDataNormals> filter;
        filter->SplittingOff();
        filter->ConsistencyOff();
        filter->SetComputePointNormals(of_vertices);
        filter->SetComputeCellNormals(!of_vertices);
        filter->SetInputData(data);
        filter->Update();
        result = filter->GetOutput();
    }

    void tell_normals(worker_answer &answer, bool of_vertices)
    {
        vtkDataArray *array = of_vertices ? result->GetPointData()->GetNormals()
                                          : result->GetCellData()->GetNormals();
        auto *normals = vtkFloatArray::SafeDownCast(array);
        if (!normals)
            throw std::runtime_error("VTK gave no normals");
        if (!of_vertices)
            answer_normals(&answer, normals->GetPointer(0), normals->GetNumberOfTuples());
        else if (normals->GetNumberOfTuples() == from->vertex_count)
            // the mean of unit normals, ours is weighted by area
            answer_normals_about(&answer, normals->GetPointer(0), from);
    }

    void stripify()
    {
        vtkNew<vtkStripper> filter;
        filter->SetMaximumLength(100000);
        filter->SetInputData(data);
        filter->Update();
        result = filter->GetOutput();
    }

    static void append_strips(vtkCellArray *cells, std::vector<std::int32_t> &indices)
    {
        vtkNew<vtkIdList> strip;
        for (cells->InitTraversal(); cells->GetNextCell(strip);) {
            if (!indices.empty())
                indices.push_back(STRIP_RESTART);
            for (vtkIdType i = 0; i < strip->GetNumberOfIds(); i++)
                indices.push_back(static_cast<std::int32_t>(strip->GetId(i)));
        }
    }

    // Triangles that stayed alone are strips of three.
    void tell_strips(worker_answer &answer)
    {
        std::vector<std::int32_t> indices;
        append_strips(result->GetStrips(), indices);
        append_strips(result->GetPolys(), indices);
        answer_strips(&answer, indices.data(), static_cast<std::int64_t>(indices.size()));
    }

    template <typename Reader> void read(const std::string &extension)
    {
        vtkNew<Reader> reader;
        reader->SetFileName(peer::file_beside(path, extension).c_str());
        reader->Update();
        result = reader->GetOutput();
        if (result->GetNumberOfPolys() == 0)
            throw std::runtime_error("VTK could not read the file");
    }
};

void tell_read(const std::shared_ptr<state> &s, worker_answer &answer)
{
    std::vector<float> corners;
    vtkNew<vtkIdList> face;
    vtkCellArray *faces = s->result->GetPolys();
    for (faces->InitTraversal(); faces->GetNextCell(face);)
        for (vtkIdType i = 0; i < face->GetNumberOfIds(); i++)
            for (int k = 0; k < 3; k++)
                corners.push_back(static_cast<float>(s->result->GetPoint(face->GetId(i))[k]));
    answer_read_mesh(&answer, corners.data(), static_cast<std::int64_t>(corners.size() / 9));
}

std::vector<peer::operation> make(const snapshot &snapshot, const std::string &path)
{
    auto s = std::make_shared<state>();
    s->from = &snapshot.mesh;
    s->path = path;
    s->data = make_poly_data(snapshot.mesh);
    auto forget = [s] { s->result = nullptr; };
    auto tell = [s](worker_answer &answer) { tell_read(s, answer); };
    return {{"edges-any", [s] { s->extract_edges(); }, forget,
             [s](worker_answer &answer) { s->tell_edges(answer); }},
            {"twins",
             [s] { s->find_neighbours(); },
             {},
             [s](worker_answer &answer) {
                 answer_neighbours(&answer, s->neighbours.data(), s->from->triangle_count);
             }},
            {"area",
             [s] { s->sum_area(); },
             {},
             [s](worker_answer &answer) { answer_area(&answer, s->area); }},
            {"face-normals", [s] { s->find_normals(false); }, forget,
             [s](worker_answer &answer) { s->tell_normals(answer, false); }},
            {"vertex-normals", [s] { s->find_normals(true); }, forget,
             [s](worker_answer &answer) { s->tell_normals(answer, true); }},
            {"stripify", [s] { s->stripify(); }, forget,
             [s](worker_answer &answer) { s->tell_strips(answer); }},
            {"read-ply-binary", [s] { s->read<vtkPLYReader>(".ply"); }, forget, tell},
            {"read-ply-ascii", [s] { s->read<vtkPLYReader>(".ascii.ply"); }, forget, tell},
            {"read-obj", [s] { s->read<vtkOBJReader>(".obj"); }, forget, tell}};
}

} // namespace

int main(int argc, char **argv)
{
    return peer::serve(argc, argv, make);
}
